// The verdict line, with what speaks against it: differences, warnings, what changed since the baseline.
import { useMemo } from 'preact/hooks';

import type { Index, Provenance } from '../shared/documents';
import { type Change, changes, kinds } from './changes';
import { count, digitsText, withUnit } from './numbers';
import { worstFirst } from './status';
import { StatusMark } from './status_mark';
import { type Summary, summary, warnings } from './summary';
import { useFew } from './use_few';
import { CellName, VerdictTable } from './verdict_table';
import { visible } from './visible';

function Line({ of }: { of: Summary }) {
  const look = of.differ.length > 0 ? 'differs' : 'agrees';
  return (
    <p class="verdict-line">
      {count(of.total, 'verdict')}: <strong class={look}>{of.differText}</strong>,{' '}
      {`${of.expectedText}, ${of.passText}`}
    </p>
  );
}

function movedText({ kind, verdict, before, weight }: Change): string {
  if (kind !== 'error' || !before) return '';
  const how = weight > 0 ? `${digitsText(-weight)} digits: worse` : `${digitsText(-weight)} digits: better`;
  return `${withUnit(before.measured, before.unit)} to ${withUnit(verdict.measured, verdict.unit)}, ${how}`;
}

function ChangeRow({ change }: { change: Change }) {
  const { kind, verdict, before } = change;
  return (
    <tr>
      <th scope="row">
        {kind === 'gone' ? (
          `${visible(verdict.scenario)} / ${visible(verdict.engine)}`
        ) : (
          <CellName verdict={verdict} />
        )}
      </th>
      <td>{visible(verdict.claim)}</td>
      <td>{kinds[kind]}</td>
      <td>{before ? <StatusMark status={before.status} /> : ''}</td>
      <td>{kind === 'gone' ? '' : <StatusMark status={verdict.status} />}</td>
      <td class="number">{movedText(change)}</td>
    </tr>
  );
}

function named(p: Provenance): string {
  return `${p.cylon} (${p.revision}) of ${p.date}`;
}

interface ChangesProps {
  list: Change[];
  baseline: Provenance;
  scale: number; // of this run's tolerances
}

function Changes({ list, baseline, scale }: ChangesProps) {
  const { list: shown, button } = useFew(list);
  const tally = Object.entries(kinds)
    .map(([kind, words]) => [list.filter((c) => c.kind === kind).length, words] as const)
    .filter(([n]) => n > 0)
    .map(([n, words]) => `${n} ${words}`)
    .join(', ');
  return (
    <section aria-labelledby="changes-heading">
      <h2 id="changes-heading">Since the baseline, {visible(named(baseline))}</h2>
      <p>{list.length === 0 ? 'No status changed, no error moved by more than 10 %.' : `${tally}.`}</p>
      {baseline.tolerance_scale === scale ? null : (
        <p class="warnings">
          <strong>Warning:</strong> the tolerances of the baseline were multiplied by{' '}
          {baseline.tolerance_scale}, those of this run by {scale}: statuses of one are not those of the
          other.
        </p>
      )}
      {list.length > 0 ? (
        <div class="scroll" tabIndex={0} role="region" aria-label="Changes since the baseline">
          <table>
            <thead>
              <tr>
                {['cell', 'claim', 'change', 'before', 'now', 'error'].map((head) => (
                  <th key={head} scope="col">
                    {head}
                  </th>
                ))}
              </tr>
            </thead>
            <tbody>
              {shown.map((change, i) => (
                <ChangeRow key={i} change={change} />
              ))}
            </tbody>
          </table>
        </div>
      ) : null}
      {button}
    </section>
  );
}

export function VerdictLine({ index }: { index: Index }) {
  const all = useMemo(() => summary(index.results.verdicts), [index]);
  const cautions = useMemo(() => warnings(index.results), [index]);
  return (
    <>
      {all.total > 0 ? (
        <Line of={all} />
      ) : (
        <p class="verdict-line">No verdicts: cylon run --json FILE makes them.</p>
      )}
      {cautions.length > 0 ? (
        <ul class="warnings" aria-label="Warnings">
          {cautions.map((text) => (
            <li key={text}>
              <strong>Warning:</strong> {visible(text)}
            </li>
          ))}
        </ul>
      ) : null}
    </>
  );
}

/** What differs and what changed, where anything did. */
export function Overview({ index }: { index: Index }) {
  const differ = useMemo(() => worstFirst(summary(index.results.verdicts).differ), [index]);
  const list = useMemo(
    () => (index.baseline ? changes(index.results.verdicts, index.baseline.verdicts) : []),
    [index],
  );
  return (
    <>
      {differ.length > 0 ? (
        <section aria-labelledby="differ-heading">
          <h2 id="differ-heading">Not as expected.toml says</h2>
          <VerdictTable verdicts={differ} caption={`${count(differ.length, 'verdict')}, worst first`} />
        </section>
      ) : null}
      {index.baseline ? (
        <Changes
          list={list}
          baseline={index.baseline.provenance}
          scale={index.results.provenance.tolerance_scale}
        />
      ) : null}
    </>
  );
}
