// A command and a button that copies it.
import { useRef, useState } from 'preact/hooks';

import { visible } from '../visible';

async function copied(text: string, shown: HTMLElement | null): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    if (shown) getSelection()?.selectAllChildren(shown); // the reader copies what is selected
    return false;
  }
}

export function Command({ text }: { text: string }) {
  const shown = useRef<HTMLElement>(null);
  const [said, say] = useState('');
  const copy = async () =>
    say((await copied(text, shown.current)) ? 'copied' : 'selected: copy it with the keyboard');
  return (
    <p class="command">
      <code ref={shown}>{visible(text)}</code>{' '}
      <button type="button" onClick={copy} aria-label={`Copy the command ${visible(text)}`}>
        copy
      </button>{' '}
      <span role="status">{said}</span>
    </p>
  );
}
