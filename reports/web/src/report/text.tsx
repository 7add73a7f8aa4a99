// Foreign text on the page: as text, visible, and folded where it is very long.
import { useState } from 'preact/hooks';

import { visible, visibleLines } from './visible';

const longest = 4096; // characters shown at first

function useFold(text: string): { shown: string; rest: number; open: () => void } {
  const [whole, setWhole] = useState(false);
  const folded = !whole && text.length > longest;
  return {
    shown: folded ? text.slice(0, longest) : text,
    rest: folded ? text.length - longest : 0,
    open: () => setWhole(true),
  };
}

function More({ rest, open }: { rest: number; open: () => void }) {
  if (rest === 0) return null;
  const what = `${rest.toLocaleString('en')} more characters`;
  return (
    <>
      <button type="button" class="more" onClick={open}>
        show {what}
      </button>
      <span class="on-paper">({what} are not printed)</span>
    </>
  );
}

/** Within a line. */
export function Foreign({ text }: { text: string }) {
  const { shown, rest, open } = useFold(text);
  return (
    <>
      <bdi>{visible(shown)}</bdi>
      <More rest={rest} open={open} />
    </>
  );
}

/** Lines as they were printed; `label` names them to a screen reader. */
export function ForeignLines({ text, label }: { text: string; label: string }) {
  const { shown, rest, open } = useFold(text);
  return (
    <>
      <pre class="output" tabIndex={0} role="region" aria-label={label}>
        {visibleLines(shown)}
      </pre>
      <More rest={rest} open={open} />
    </>
  );
}
