// How the engine was set for this run: forced settings, and known limits.
import type { Diagnostic, ScenarioView, Verdict } from '../../shared/documents';
import { duration, stepInWords } from '../../shared/durations';
import { count, short, withUnit } from '../numbers';
import { Foreign, ForeignLines } from '../text';
import { withSubsteps } from '../substeps';
import { visible } from '../visible';

/** Values of all claims of a cell: one, as a cell is one run; should they differ, all are shown. */
function distinct(verdicts: Verdict[], of: (v: Verdict) => string): string {
  return [...new Set(verdicts.map(of))].join(' | ');
}

/** "1/60 s (16.7 ms)"; "1 ms" alone, which says the number already. */
export function stepText({ dt, dt_text }: Verdict): string {
  const asked = stepInWords(dt_text);
  return asked.includes('/') ? `${asked} (${duration(dt)})` : asked;
}

const facts: [string, (v: Verdict) => string][] = [
  [
    'engine',
    (v) =>
      `${v.engine} ${v.version}${v.version_listed ? '' : ' (a version that expected.toml does not list)'}`,
  ],
  ['precision', (v) => v.precision],
  ['path', (v) => v.path],
  ['gyroscopic term', (v) => v.gyroscopic],
  ['integrator', (v) => v.integrator],
  ['step', (v) => withSubsteps(stepText(v), v.substeps)],
  ['sampling', (v) => v.sampling],
  [
    'CPU time',
    (v) => `${duration(v.cpu_seconds)} for ${v.body_steps} body-steps${v.cpu_verified ? '' : ' (not verified)'}`,
  ],
  ['scenario hash', (v) => v.scenario_hash],
];

export function Run({ verdicts, view }: { verdicts: Verdict[]; view: ScenarioView | undefined }) {
  return (
    <section aria-labelledby="run-heading">
      <h3 id="run-heading">Run</h3>
      <dl class="facts">
        {facts.map(([label, of]) => (
          <div key={label}>
            <dt>{label}</dt>
            <dd>
              <Foreign text={distinct(verdicts, of)} />
            </dd>
          </div>
        ))}
        {view ? (
          <div>
            <dt>scenario</dt>
            <dd>
              {short(view.duration)} s, nominal step {duration(view.step)}, {' '}
              {count(view.scene.body.length, 'body', 'bodies')}, tags: {visible(view.tags.join(', ') || 'none')}
            </dd>
          </div>
        ) : null}
      </dl>
    </section>
  );
}

export function Settings({ verdicts }: { verdicts: Verdict[] }) {
  const forced = Object.entries(
    Object.assign({}, ...verdicts.map((v) => v.settings)) as Record<string, string>,
  );
  const stuck = [...new Set(verdicts.flatMap((v) => v.unforceable))];
  return (
    <section aria-labelledby="settings-heading">
      <h3 id="settings-heading">Settings forced on the engine</h3>
      {forced.length === 0 ? <p>None: it ran as it is.</p> : null}
      <dl class="facts">
        {forced.map(([key, value]) => (
          <div key={key}>
            <dt>{visible(key)}</dt>
            <dd>{visible(value)}</dd>
          </div>
        ))}
      </dl>
      <h3>Known limits of the engine</h3>
      {stuck.length === 0 ? <p>Nothing is known.</p> : null}
      <ul>
        {stuck.map((text) => (
          <li key={text}>{visible(text)}</li>
        ))}
      </ul>
    </section>
  );
}

const none = '–';

function quantity(value: number | null, unit: string): string {
  return value === null ? none : withUnit(value, unit === '1' ? '' : unit);
}

function part(d: Diagnostic): string {
  const more = d.body_count - d.bodies.length;
  const named = d.bodies.join(', ') + (more > 0 ? ` and ${more} more` : '');
  return d.body_count === 0 ? 'the scene' : named;
}

const columns: [string, (d: Diagnostic) => string][] = [
  ['part', part],
  ['method', (d) => d.method + (d.order > 0 ? `, order ${d.order}` : '') || none],
  ['since', (d) => quantity(d.since, 's')],
  ['until', (d) => (d.until === null ? 'the end' : quantity(d.until, 's'))],
  ['times', (d) => `${d.count}`],
  ['asked, or cap', (d) => quantity(d.limit, d.limit_unit)],
  ['reached', (d) => quantity(d.reached, d.unit)],
  ['in words', (d) => d.text],
];

/** What the engine says of its run: tolerances that were not kept, caps that were hit, per part of the scene. */
export function Diagnostics({ verdicts }: { verdicts: Verdict[] }) {
  // A cell is one run: all claims have the same.
  const rows = verdicts.find((v) => v.diagnostics.length > 0)?.diagnostics ?? [];
  if (rows.length === 0) return null;
  return (
    <section aria-labelledby="diagnostics-heading">
      <h3 id="diagnostics-heading">What the engine says of this run</h3>
      <div class="scroll" tabIndex={0} role="region" aria-label="Diagnostics of this run">
        <table>
          <thead>
            <tr>
              <th scope="col">kind</th>
              {columns.map(([head]) => (
                <th key={head} scope="col">
                  {head}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((d, i) => (
              <tr key={i}>
                <th scope="row">{visible(d.kind)}</th>
                {columns.map(([head, of]) => (
                  <td key={head}>
                    <Foreign text={of(d)} />
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </section>
  );
}

export function Output({ verdicts }: { verdicts: Verdict[] }) {
  const texts = [...new Set(verdicts.map((v) => v.stderr))].filter((text) => text !== '');
  return (
    <section aria-labelledby="output-heading">
      <h3 id="output-heading">What the engine wrote to stderr</h3>
      {texts.length === 0 ? <p>Nothing.</p> : null}
      {texts.map((text, i) => (
        <ForeignLines key={i} text={text} label="stderr of the engine" />
      ))}
    </section>
  );
}
