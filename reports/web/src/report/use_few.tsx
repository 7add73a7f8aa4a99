// The first rows of a long list, and a button for the rest; on paper all.
import type { JSX } from 'preact';
import { useEffect, useState } from 'preact/hooks';

const few = 12;

export function useFew<T>(all: T[]): { list: T[]; button: JSX.Element | null } {
  const [whole, setWhole] = useState(false);
  useEffect(() => {
    const all = () => setWhole(true);
    addEventListener('beforeprint', all);
    return () => removeEventListener('beforeprint', all);
  }, []);
  const button =
    all.length > few && !whole ? (
      <button type="button" onClick={() => setWhole(true)}>
        show all {all.length}
      </button>
    ) : null;
  return { list: whole ? all : all.slice(0, few), button };
}
