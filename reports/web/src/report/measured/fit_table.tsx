// What was fitted, with both intervals, and what cannot be told apart.
import type { FitDocument } from '../../shared/measured_documents';
import { count, short } from '../numbers';
import { visible } from '../visible';

type Fit = FitDocument['fits'][number];

function interval(value: number, low: number | null, high: number | null): string {
  return low === null ? `${short(value)}, not known` : `${short(value)} [${short(low)}, ${short(high)}]`;
}

function Parameters({ fit }: { fit: Fit }) {
  if (fit.failure)
    return (
      <tr>
        <th scope="row">{visible(fit.engine)}</th>
        <td colSpan={4}>no fit: {visible(fit.failure)}</td>
      </tr>
    );
  return (
    <>
      {fit.parameters.map((p) => (
        <tr key={p.name}>
          <th scope="row">{visible(fit.engine)}</th>
          <td>{visible(p.name)}</td>
          <td class="number">{interval(p.value, p.low, p.high)}</td>
          <td class="number">{interval(p.value, p.low_between_runs, p.high_between_runs)}</td>
          <td>{p.at_bound ? 'at its bound' : ''}</td>
        </tr>
      ))}
    </>
  );
}

/** "0.71 mass - 0.71 inertia" */
function combination(fit: Fit, weights: number[]): string {
  const terms = weights.flatMap((w, i) =>
    Math.abs(w) > 0.1 ? [`${w < 0 ? '-' : '+'} ${Math.abs(w).toFixed(2)} ${visible(fit.parameters[i]?.name ?? '')}`] : [],
  );
  return terms.join(' ').replace(/^\+ /, '');
}

function Misfit({ fit }: { fit: Fit }) {
  const explained = fit.misfit_p < 0.05 ? 'the model and the stated uncertainties do not explain it' : 'as the stated uncertainties say';
  return (
    <li>
      {visible(fit.engine)}, on {count(fit.fitted_on.length, 'run')}: misfit of a number{' '}
      {short(fit.misfit / fit.numbers, 3)}: {explained} (p = {short(fit.misfit_p, 2)});{' '}
      {fit.settled ? 'settled' : 'not settled'} after {count(fit.rounds, 'round')}
      {fit.cannot_be_told_apart.map(({ weights, error }, i) => (
        <span key={i}>
          ; cannot be told apart along {combination(fit, weights)} (standard error {short(error, 2)} of the ranges)
        </span>
      ))}
    </li>
  );
}

export function FitTable({ of }: { of: FitDocument }) {
  return (
    <>
      <div class="scroll" tabIndex={0} role="region" aria-label={`Fits to ${visible(of.title)}`}>
        <table>
          <caption>
            Parameters of greatest likelihood, from windows of {short(of.horizon)} s; {of.runs} of {of.measured_runs} runs
            used
          </caption>
          <thead>
            <tr>
              {['engine', 'parameter', 'value, if the uncertainties are right', 'between runs', 'remarks'].map((head) => (
                <th key={head} scope="col">
                  {head}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {of.fits.map((fit, i) => (
              <Parameters key={i} fit={fit} />
            ))}
          </tbody>
        </table>
      </div>
      <ul>
        {of.fits.filter((fit) => !fit.failure).map((fit, i) => (
          <Misfit key={i} fit={fit} />
        ))}
        {of.likelier.map((pair) => (
          <li key={pair.other}>
            Likelier, on runs that were not fitted: {visible(pair.one)} in {pair.runs_of_one}, {visible(pair.other)} in{' '}
            {pair.runs_of_other}: <strong>{visible(pair.likelier)}</strong> (p = {short(pair.p, 2)})
          </li>
        ))}
      </ul>
    </>
  );
}
