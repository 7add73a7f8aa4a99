// Which step an engine needs: for each scenario and engine the coarsest step that meets an error, its cost and the
// observed order, or why no step does.  One click shows digits at a step.
import { useMemo } from 'preact/hooks';

import type { Index } from '../../shared/documents';
import { duration } from '../../shared/durations';
import { go, link, sectionAddress, useAddress } from '../address';
import { Build, buildsNote } from '../builds';
import { count, short } from '../numbers';
import { withSubsteps } from '../substeps';
import { Name, Numbers } from '../text';
import { visible } from '../visible';
import { digitsAt, foldSteps, isInHouse, type Reach, type StepCell, type StepMatrix } from './fold_steps';

const steps = [0.01, 0.001, 0.0001]; // at which digits are offered [s]

function stepText(cell: StepCell, reach: Reach): string {
  if (cell.closedForm) return 'no steps';
  if (reach.tolerance !== null) return `tolerance ${short(reach.tolerance, 2)}`;
  return withSubsteps(`${reach.coarsestTried ? '\u2265 ' : ''}${duration(reach.step)}`, cell.substeps);
}

function ReachRow({ cell, reach }: { cell: StepCell; reach: Reach }) {
  const reached = reach.step !== null;
  return (
    <tr class={reached ? undefined : 'not-reached'}>
      <th scope="row">{short(reach.error, 1)}</th>
      <td>{reached ? stepText(cell, reach) : 'not reached'}</td>
      <td class="number">{reached && reach.cost !== null ? `${duration(reach.cost)}/s` : ''}</td>
    </tr>
  );
}

function orderText(cell: StepCell): string {
  if (cell.closedForm) return 'closed form';
  if (cell.adaptive) return 'chooses its steps';
  return cell.order === null ? 'no order seen' : `order ${cell.order.toFixed(2)}`;
}

function Refusal({ cell }: { cell: StepCell }) {
  return (
    <>
      <strong>{cell.avoidable ? 'refused, avoidable' : 'refused'}</strong>
      <p class="why">
        <Numbers text={cell.avoidable ? cell.refusal.replace(/\.$/, '') : cell.refusal} />
        {cell.avoidable ? `; ${visible(cell.avoidable)} can` : ''}
      </p>
    </>
  );
}

function Steps({ cell }: { cell: StepCell }) {
  if (cell.refusal) return <Refusal cell={cell} />;
  const missed = cell.reach.find((reach) => reach.step === null);
  return (
    <>
      <table>
        <tbody>
          {cell.reach.map((reach) => (
            <ReachRow key={reach.error} cell={cell} reach={reach} />
          ))}
        </tbody>
      </table>
      <p class="why">
        {orderText(cell)}
        {missed ? <Numbers text={`; ${short(missed.error, 1)}: ${missed.why}`} /> : null}
      </p>
    </>
  );
}

function Digits({ cell, dt }: { cell: StepCell; dt: number }) {
  if (cell.refusal) return <Refusal cell={cell} />;
  if (cell.closedForm) return <span class="why">closed form</span>;
  if (cell.adaptive) return <span class="why">chooses its steps</span>;
  const at = digitsAt(cell, dt);
  if (!at) return <span class="why">no finite error</span>;
  return (
    <>
      <span class="number">{at.digits.toFixed(1)}</span> <span class="why">at {withSubsteps(duration(at.dt), cell.substeps)}</span>
    </>
  );
}

function Table({ matrix, engines, at }: { matrix: StepMatrix; engines: string[]; at: number | null }) {
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label="Steps by scenario and engine">
      <table class="steps">
        <thead>
          <tr>
            <th scope="col">scenario</th>
            {engines.map((engine) => (
              <th key={engine} scope="col">
                {visible(engine)}
                <Build build={matrix.builds.get(engine) ?? ''} />
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {matrix.rows.map((row, i) => (
            <tr key={i}>
              <th scope="row">
                <a href={link({ ...sectionAddress('trade'), trade: row.sweep })}>
                  <Name text={row.scenario} />
                </a>
                {row.source ? <p class="why">of {row.source}</p> : null}
                <p class="why">
                  <Name text={row.measure} />
                </p>
              </th>
              {engines.map((engine) => {
                const cell = row.cells.get(engine);
                return (
                  <td key={engine} class={cell?.avoidable ? 'avoidable' : undefined}>
                    {cell ? at === null ? <Steps cell={cell} /> : <Digits cell={cell} dt={at} /> : 'not run'}
                  </td>
                );
              })}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

export function StepsSection({ index }: { index: Index }) {
  const { at = '', ours = '' } = useAddress();
  const matrix = useMemo(() => foldSteps(index.trades), [index]);
  const others = matrix.engines.filter((engine) => !isInHouse(engine));
  const choice = others.length > 0 && others.length < matrix.engines.length;
  const engines = choice && ours !== 'yes' ? others : matrix.engines;
  const chosen = steps.find((dt) => String(dt) === at) ?? null;
  return (
    <section aria-labelledby="steps-heading">
      <h2 id="steps-heading">Which step an engine needs</h2>
      {matrix.rows.length === 0 ? (
        <p class="empty">
          This report holds no sweep. <code>cylon matrix --json FILE</code> makes one; then{' '}
          <code>cylon report FILE… --html REPORT</code>.
        </p>
      ) : (
        <>
          <div class="choice">
            <label>
              show{' '}
              <select value={chosen === null ? '' : at} onChange={(event) => go({ at: event.currentTarget.value })}>
                <option value="">the coarsest step that meets an error</option>
                {steps.map((dt) => (
                  <option key={dt} value={String(dt)}>
                    digits at {duration(dt)}
                  </option>
                ))}
              </select>
            </label>
            {choice ? (
              <label>
                <input
                  type="checkbox"
                  checked={ours === 'yes'}
                  onChange={() => go({ ours: ours === 'yes' ? '' : 'yes' })}
                />{' '}
                with the in-house engine
              </label>
            ) : null}
          </div>
          <p class="count" role="status">
            {count(matrix.scenarios, 'scenario')}, {count(engines.length, 'engine')}
          </p>
          <Table matrix={matrix} engines={engines} at={chosen} />
          <p class="note">
            {chosen === null
              ? 'A line says: relative error; the coarsest of the tried steps that meets it, as the next finer ' +
                'one does; CPU time per simulated second. \u2265: no coarser step was tried. '
              : 'Digits are -log10 of the relative error, at the coarsest tried step of at most the given one. '}
            {chosen === null ? visible(buildsNote(engines.map((engine) => matrix.builds.get(engine) ?? ''))) : ''}
            no steps, closed form: the engine knows the motion as a formula of time, and a step says nothing of it.
            A scenario leads to its plot of error against cost.
          </p>
        </>
      )}
    </section>
  );
}
