// Measured motions: what each data set is, how well engines predict it before and after their fits, and what is wrong with it.
import type { Index } from '../../shared/documents';
import type { Prediction } from '../../shared/measured_documents';
import { go, useAddress } from '../address';
import { short } from '../numbers';
import { Foreign } from '../text';
import { visible } from '../visible';
import { type DataSet, dataSets, estimateText, scoreRows } from './data_sets';
import { FitTable } from './fit_table';
import { LengthsView } from './lengths';
import { RunView } from './run_view';
import { ScoreTable } from './score_table';

function Facts({ of }: { of: DataSet['of'] }) {
  const facts: [string, string][] = [
    ['source', of.source],
    ['licence', of.licence],
    ['instrument', of.instrument],
    ['runs', String(of.measured_runs)],
  ];
  return (
    <>
      <dl class="facts">
        {facts.map(([name, text]) =>
          text ? (
            <div key={name}>
              <dt>{name}</dt>
              <dd>
                <Foreign text={text} />
              </dd>
            </div>
          ) : null,
        )}
      </dl>
      {of.known.length > 0 ? (
        <>
          <p>What is known of the data, and wrong with them:</p>
          <ul>
            {of.known.map((text, i) => (
              <li key={i}>
                <Foreign text={text} />
              </li>
            ))}
          </ul>
        </>
      ) : null}
    </>
  );
}

/** Whether places and velocities of the data go together. */
function Columns({ of }: { of: Prediction }) {
  const { kinematics, coordinates } = of;
  if (!kinematics) return null;
  const chain = coordinates === 'chain';
  const pairs = [
    { what: 'positions', over: 'velocities', slope: kinematics.velocity },
    { what: chain ? 'angles' : 'orientations', over: chain ? 'rates' : 'angular velocities', slope: kinematics.spin },
  ].filter(({ slope }) => slope.value !== null);
  if (pairs.length === 0) return null;
  return (
    <>
      <p>Columns of the data against each other, steps from frame to frame over velocities:</p>
      <ul>
        {pairs.map(({ what, over, slope }) => (
          <li key={what}>
            {what} {estimateText(slope, 1, 3)} of {over}
            {slope.goes_together === 'no' ? (
              <>
                : <strong>they do not go together; check columns, units, axes and rate</strong>
              </>
            ) : null}
          </li>
        ))}
      </ul>
    </>
  );
}

function Nearer({ set }: { set: DataSet }) {
  const pairs = set.predictions.flatMap(({ nearer = [] }) => nearer);
  if (pairs.length === 0) return null;
  return (
    <ul>
      {pairs.map((pair, i) => (
        <li key={i}>
          Nearer at rest: {visible(pair.one)} in {pair.runs_of_one} runs, {visible(pair.other)} in {pair.runs_of_other}:{' '}
          <strong>{visible(pair.nearer)}</strong> (p = {short(pair.p, 2)}, sign test, Holm)
        </li>
      ))}
    </ul>
  );
}

function DataSetView({ set }: { set: DataSet }) {
  const { title } = set.of;
  const lengths = set.predictions.find((p) => p.lengths);
  const checked = set.predictions.find((p) => p.kinematics);
  return (
    <article aria-label={visible(title)}>
      <h3>{visible(title)}</h3>
      <Facts of={set.of} />
      {checked ? <Columns of={checked} /> : null}
      <h4>Predictions</h4>
      <ScoreTable rows={scoreRows(set)} title={title} />
      <Nearer set={set} />
      {set.fits.length > 0 ? <h4>Fits</h4> : null}
      {set.fits.map((fit, i) => (
        <FitTable key={i} of={fit} />
      ))}
      {lengths ? <LengthsView of={lengths} /> : null}
      <RunView predictions={set.predictions} />
    </article>
  );
}

export function MeasuredSection({ index }: { index: Index }) {
  const { data } = useAddress();
  const sets = dataSets(index);
  const chosen = sets.find(({ id }) => id === data) ?? sets[0];
  return (
    <section>
      <h2>Measured motions</h2>
      <p class="note">
        Validation: a model of a real thing, with its parameters, on an engine, against what was measured. No engine is
        judged alone. Where an interval does not decide, the answer is <em>undecided</em>.
      </p>
      {sets.length > 1 ? (
        <p>
          <label>
            data set{' '}
            <select value={chosen?.id} onChange={(event) => go({ data: event.currentTarget.value })}>
              {sets.map(({ id, of }) => (
                <option key={id} value={id}>
                  {visible(of.title)}
                </option>
              ))}
            </select>
          </label>
        </p>
      ) : null}
      {chosen ? <DataSetView key={chosen.id} set={chosen} /> : <p class="empty">The report has no measured motions.</p>}
    </section>
  );
}
