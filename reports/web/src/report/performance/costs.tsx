// CPU time per body-step of every run, with the digits that it bought.
import { useMemo } from 'preact/hooks';

import type { Verdict } from '../../shared/documents';
import { duration } from '../../shared/durations';
import { cellAddress, link } from '../address';
import { Build, buildOf, buildsNote } from '../builds';
import { type Cell, fold } from '../fold';
import { wonText } from '../numbers';
import { isMeasured, looks } from '../status';
import { Name } from '../text';
import { useFew } from '../use_few';
import { visible } from '../visible';

function Cost({ cell }: { cell: Cell | null }) {
  const first = cell?.verdicts[0];
  if (!cell || !first) return null;
  const known = first.body_steps > 0 && first.cpu_seconds > 0;
  const won = isMeasured(cell.worst) && cell.digits !== null ? ` ${wonText(cell.digits)}` : '';
  return (
    <a href={link(cellAddress(cell))} class="cost">
      <span class="number">{known ? duration(first.cpu_seconds / first.body_steps) : 'not timed'}</span>{' '}
      {known && !first.cpu_verified ? <span class="why">not verified </span> : null}
      <span class={`status ${looks[cell.worst].tone}`}>
        {looks[cell.worst].glyph}
        {won}
      </span>
    </a>
  );
}

export function Costs({ verdicts }: { verdicts: Verdict[] }) {
  const { columns, rows } = useMemo(() => fold(verdicts), [verdicts]);
  const { list, button } = useFew(rows);
  // A cell that did not start has no version.
  const builds = columns.map((_, j) =>
    buildOf(rows.flatMap((row) => row.cells[j]?.verdicts ?? []).find((v) => v.version)?.version ?? ''),
  );
  return (
    <section aria-labelledby="costs-heading">
      <h3 id="costs-heading">CPU time per body-step, with the digits of the worst claim</h3>
      <p class="note">
        Timed once, while the verdicts were made and perhaps with other runs beside it: orders of magnitude.{' '}
        <em>not verified</em>: the CPU time of the engine&apos;s process does not confirm what it tells, as in
        short runs, where requests and samples cost more than steps.{' '}
        {visible(buildsNote(builds))}
        To decide between builds there is <code>cylon track compare</code>, between engines and integrators{' '}
        <code>cylon trade</code>.
      </p>
      <div class="scroll" tabIndex={0} role="region" aria-label="CPU time per body-step">
        <table class="costs">
          <thead>
            <tr>
              <th scope="col">scenario</th>
              {columns.map((column, j) => (
                <th key={column.label} scope="col">
                  <Name text={column.label} />
                  <Build build={builds[j] ?? ''} />
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {list.map((row) => (
              <tr key={row.label}>
                <th scope="row">
                  <Name text={row.label} />
                </th>
                {row.cells.map((cell, j) => (
                  <td key={j}>
                    <Cost cell={cell} />
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      {button}
    </section>
  );
}
