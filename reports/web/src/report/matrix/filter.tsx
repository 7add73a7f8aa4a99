// The line in which the reader asks, what is wrong with the question, and how to ask.
import type { RefObject } from 'preact';

import { useAddress } from '../address';
import { sentence } from '../text';
import { visible } from '../visible';
import type { QueryError } from '../query/parse';

const examples: [string, string][] = [
  ['*:differs', 'some engine differs from expected.toml'],
  ['bullet:fail and ode:pass', 'one fails where another passes'],
  ['any:crash or any:timeout', 'any is short for *'],
  ['bullet*:digits<-2', 'some Bullet misses a tolerance by more than two digits'],
  ['digits<0 not in-house:digits<0', 'somebody fails, the in-house engine does not'],
  [
    'tag:top (claim:energy* or claim:*momentum*)',
    'tags of the scenario, claims or observables; * and ? in all names',
  ],
  ['scenario:heavy_* columns:ode*,bullet', 'rows by name; only these columns (columns:-ode* leaves out)'],
  ['columns:-in-house*', 'without the in-house engine'],
  ['"not a spring"', 'plain or quoted words are looked for in names and titles'],
];

export function QueryFault({ query, fault }: { query: string; fault: QueryError }) {
  const caret = ' '.repeat(fault.at) + '^'.repeat(Math.max(1, fault.length));
  return (
    <div class="query-fault" role="alert">
      <pre aria-hidden="true">{`${visible(query)}\n${caret}`}</pre>
      <p>
        Character {fault.at + 1}: {visible(sentence(fault.message))} All rows are shown.
      </p>
    </div>
  );
}

export function QueryHelp({ onPick }: { onPick: (query: string) => void }) {
  return (
    <details class="query-help">
      <summary>How to ask</summary>
      <p>
        Terms side by side must all hold; <code>or</code>, <code>not</code> and parentheses do as they
        say.{' '}
        <code>ENGINE:STATUS</code> with pass (all claims), low-quality, fail, undecided, unsupported, crash,
        timeout, non-finite, protocol (some claim), differs, expected, none (not run);{' '}
        <code>ENGINE:digits&lt;X</code>{' '}
        with &lt; &lt;= &gt; &gt;= =. An engine means all its columns, shown or not.
      </p>
      <ul>
        {examples.map(([query, what]) => (
          <li key={query}>
            <button type="button" onClick={() => onPick(query)}>
              <code>{query}</code>
            </button>{' '}
            {what}
          </li>
        ))}
      </ul>
    </details>
  );
}

interface FilterProps {
  input: RefObject<HTMLInputElement | null>;
  fault: QueryError | null;
  onQuery: (query: string) => void;
}

export function Filter({ input, fault, onQuery }: FilterProps) {
  const query = useAddress().q ?? '';
  return (
    <div class="filter" role="search">
      <label>
        Filter <kbd>/</kbd>{' '}
        <input
          ref={input}
          type="search"
          value={query}
          spellcheck={false}
          autocomplete="off"
          aria-invalid={fault !== null}
          onInput={(event) => onQuery(event.currentTarget.value)}
          placeholder="bullet:fail and ode:pass"
        />
      </label>
      {fault ? <QueryFault query={query} fault={fault} /> : null}
      <QueryHelp onPick={onQuery} />
    </div>
  );
}
