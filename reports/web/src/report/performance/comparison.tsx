// Two builds side by side, as `cylon track compare` found them.
import type { Comparisons } from '../../shared/documents';
import { duration } from '../../shared/durations';
import { Command } from '../cell/copy';
import { short } from '../numbers';
import { Foreign, Name } from '../text';
import { useFew } from '../use_few';
import { visible } from '../visible';
import { Interval } from './interval';

type Cell = Comparisons['cells'][number];

// In the order of their weight (harness/results/comparison.h).
const order = ['regressed', 'inconclusive', 'improved', 'changed', 'same', 'skipped'];
const signs: Record<string, string> = {
  regressed: '\u2717',
  improved: '\u2713',
  same: '=',
  inconclusive: '?',
  changed: '\u2260',
};

function rank(finding: string): number {
  const at = order.indexOf(finding);
  return at < 0 ? order.length : at;
}

/** The weightiest of the cell's own, of its time and of its results. */
function worst(cell: Cell): string {
  const all = [
    cell.finding,
    ...(cell.time ? [cell.time.finding] : []),
    ...cell.metrics.map((m) => m.finding),
  ];
  return all.sort((a, b) => rank(a) - rank(b))[0]!;
}

function Finding({ finding }: { finding: string }) {
  return (
    <span class={`finding ${finding}`}>
      {signs[finding] ? `${signs[finding]} ` : ''}
      {visible(finding)}
    </span>
  );
}

function Time({ cell, tau }: { cell: Cell; tau: number }) {
  const { time } = cell;
  if (!time) return <Foreign text={cell.untimed || 'not timed'} />;
  if (time.ratio === null || time.low === null || time.high === null) return <Foreign text={time.what} />;
  return (
    <>
      <Interval ratio={time.ratio} low={time.low} high={time.high} tau={tau} />{' '}
      <span class="number">
        {short(time.ratio)} [{short(time.low)}, {short(time.high)}]
        {time.confidence === null ? '' : ` at ${short(100 * time.confidence)} %`}
      </span>
      <br />
      <span class="note">
        {duration(time.baseline_seconds)} to {duration(time.candidate_seconds)} of {visible(time.what)}
        {time.adjusted_p === null ? '' : `, adjusted p ${short(time.adjusted_p, 2)}`}
      </span>
    </>
  );
}

function Row({ cell, tau }: { cell: Cell; tau: number }) {
  const changed = cell.metrics.filter((m) => m.finding !== 'same' && m.sentence !== '');
  return (
    <tr>
      <th scope="row">
        <Name text={`${cell.scenario} / ${cell.engine} at ${cell.dt_text}`} />
      </th>
      <td>
        <Finding finding={worst(cell)} />
      </td>
      <td>
        <Time cell={cell} tau={tau} />
      </td>
      <td class="number">{cell.time?.pairs ?? ''}</td>
      <td>
        <Foreign text={cell.reason} />
        <ul class="plain">
          {changed.map((m, i) => (
            <li key={i}>
              <Finding finding={m.finding} /> {visible(m.name)}: <Foreign text={m.sentence} />
            </li>
          ))}
        </ul>
        {cell.reproduce ? <Command text={cell.reproduce} /> : null}
      </td>
    </tr>
  );
}

export function Comparison({ of, nth }: { of: Comparisons; nth: number }) {
  const { list, button } = useFew([...of.cells].sort((a, b) => rank(worst(a)) - rank(worst(b))));
  const findings = of.cells.map(worst);
  const tally = [...new Set([...order, ...findings])]
    .map((finding) => [findings.filter((f) => f === finding).length, finding] as const)
    .filter(([n]) => n > 0)
    .map(([n, finding]) => `${n} ${finding}`)
    .join(', ');
  return (
    <section aria-labelledby={`comparison-${nth}`}>
      <h3 id={`comparison-${nth}`}>
        {visible(of.baseline)} and {visible(of.candidate)}
      </h3>
      <p>
        {visible(tally || 'no cells')}. Ratios are candidate over baseline; within 1 &plusmn;{' '}
        {short(100 * of.tau)} % (shaded) they count as the same, at &alpha; = {short(of.alpha)}
        {of.gate ? ', as a gate over all cells' : ''}.
      </p>
      {of.reliable ? null : (
        <p class="warnings">
          <strong>Warning:</strong> the environment is unreliable: a build was found different from itself. No
          time here decides anything.
        </p>
      )}
      {of.notes.length > 0 ? (
        <ul>
          {of.notes.map((text, i) => (
            <li key={i}>
              <Foreign text={text} />
            </li>
          ))}
        </ul>
      ) : null}
      <div class="scroll" tabIndex={0} role="region" aria-label="Compared cells">
        <table>
          <thead>
            <tr>
              {[
                'cell',
                'outcome',
                'time, candidate over baseline',
                'pairs',
                'reason, results that changed, command',
              ].map((head) => (
                <th key={head} scope="col">
                  {head}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {list.map((cell, i) => (
              <Row key={i} cell={cell} tau={of.tau} />
            ))}
          </tbody>
        </table>
      </div>
      {button}
    </section>
  );
}
