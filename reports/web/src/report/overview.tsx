// The verdict line, with what speaks against it: differences, warnings, what changed since the baseline.
import { useMemo } from 'preact/hooks';

import type { Index, Provenance } from '../shared/documents';
import { cellAddress, link } from './address';
import { type Change, changes, kinds } from './changes';
import { type Matrix, severalSteps, supported } from './fold';
import { count, digitsText, withUnit } from './numbers';
import { worstFirst } from './status';
import { StatusMark } from './status_mark';
import { Name } from './text';
import { type Summary, summary, warnings } from './summary';
import { useFew } from './use_few';
import { CellName, cellText, VerdictTable } from './verdict_table';
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

function ChangeRow({ change, step }: { change: Change; step: boolean }) {
  const { kind, verdict, before } = change;
  return (
    <tr>
      <th scope="row">
        {kind === 'gone' ? (
          <Name text={cellText(verdict, step)} />
        ) : (
          <CellName verdict={verdict} step={step} />
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
  stepped: Set<string>; // scenarios whose rows name their step
}

function Changes({ list, baseline, scale, stepped }: ChangesProps) {
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
                <ChangeRow key={i} change={change} step={stepped.has(change.verdict.scenario)} />
              ))}
            </tbody>
          </table>
        </div>
      ) : null}
      {button}
    </section>
  );
}

/** How many scenes each engine runs, and refusals that another engine shows to be avoidable. */
function Supported({ matrix }: { matrix: Matrix }) {
  const counts = matrix.columns.map(({ label }, j) => ({ label, ...supported(matrix, j) }));
  const scenes = new Set(matrix.rows.map(({ scenario }) => scenario)).size;
  const all = counts.every(({ run }) => run === scenes);
  const avoidable = matrix.rows.flatMap(({ label, cells }) =>
    cells.flatMap((cell) => (cell && cell.passedBy.length > 0 ? [{ label, cell }] : [])),
  );
  return (
    <>
      <p class="supported">
        Scenes supported:{' '}
        {all
          ? `all ${scenes} by ${counts.length === 1 ? 'the engine' : `each of ${counts.length} engines`}`
          : counts.map(({ label, run, asked }) => `${visible(label)} ${run} of ${asked}`).join(', ')}
        .
      </p>
      {avoidable.length > 0 ? (
        <details class="supported">
          <summary>
            <strong>{count(avoidable.length, 'refusal')}</strong> that another engine shows to be avoidable
          </summary>
          <ul>
            {avoidable.map(({ label, cell }, i) => (
              <li key={i}>
                <a href={link(cellAddress(cell))}>
                  {visible(cell.engine)}: {visible(label)}
                </a>
                , which {visible(cell.passedBy.join(', '))} {cell.passedBy.length === 1 ? 'passes' : 'pass'}
              </li>
            ))}
          </ul>
        </details>
      ) : null}
    </>
  );
}

export function VerdictLine({ index, matrix }: { index: Index; matrix: Matrix }) {
  const all = useMemo(() => summary(index.results.verdicts), [index]);
  const cautions = useMemo(() => warnings(index.results), [index]);
  return (
    <>
      {all.total > 0 ? (
        <Line of={all} />
      ) : (
        <p class="verdict-line">No verdicts: cylon run --json FILE makes them.</p>
      )}
      {all.total > 0 ? <Supported matrix={matrix} /> : null}
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
  const stepped = useMemo(
    () => severalSteps([...index.results.verdicts, ...(index.baseline?.verdicts ?? [])]),
    [index],
  );
  return (
    <>
      {differ.length > 0 ? (
        <section aria-labelledby="differ-heading">
          <h2 id="differ-heading">Not as expected.toml says</h2>
          <VerdictTable verdicts={differ} stepped={stepped} />
        </section>
      ) : null}
      {index.baseline ? (
        <Changes
          list={list}
          baseline={index.baseline.provenance}
          scale={index.results.provenance.tolerance_scale}
          stepped={stepped}
        />
      ) : null}
    </>
  );
}
