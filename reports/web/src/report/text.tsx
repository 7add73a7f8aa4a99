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

const unit = ' (?:[mnp\u00b5]?s|m?m|m?rad|kg|[JNW%])(?:[/^][\\w/^]{1,8})?(?![\\w^])';
const number = '[-+]?\\d{1,20}(?:\\.\\d{1,20})?';
const quantity = new RegExp(`((?<![\\w.])${number}(?:e[-+]?\\d{1,3}(?:${unit})?|${unit}))`); // few digits: one line holds them

/** Text in which a number stays on one line with its exponent and its unit: "1.488e-12 rad". */
export function Numbers({ text }: { text: string }) {
  const parts = visible(text).split(quantity); // every second one is a quantity
  return (
    <>
      {parts.map((part, i) =>
        i % 2 === 0 ? (
          part
        ) : (
          <span key={i} class="unbroken">
            {part}
          </span>
        ),
      )}
    </>
  );
}

/** The name of a scenario or an engine, which may break where its words meet: "bouncing_" "sphere". */
export function Name({ text }: { text: string }) {
  const parts = visible(text).split(/(?<=[/=_-])/);
  return <>{parts.flatMap((part, i) => (i === 0 ? [part] : [<wbr key={i} />, part]))}</>;
}

/** With its full stop, unless it ends as a sentence does. */
export function sentence(text: string): string {
  return /[.?!]$/.test(text) ? text : `${text}.`;
}

/** Within a line. */
export function Foreign({ text }: { text: string }) {
  const { shown, rest, open } = useFold(text);
  return (
    <>
      <bdi>
        <Numbers text={shown} />
      </bdi>
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
