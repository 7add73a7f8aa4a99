// What was run, where and by which builds.
import { useMemo } from 'preact/hooks';

import type { Index, Provenance, Verdict } from '../shared/documents';
import { count } from './numbers';
import { warnings } from './summary';
import { Foreign } from './text';
import { visible } from './visible';

const words: [keyof Provenance, string][] = [
  ['cylon', 'Cylon'],
  ['revision', 'revision'],
  ['compiler', 'compiler'],
  ['flags', 'flags'],
  ['machine', 'machine'],
  ['os', 'operating system'],
  ['date', 'date'],
  ['command_line', 'command'],
  ['tolerance_scale', 'tolerances times'],
];

function Facts({ of, title }: { of: Provenance; title: string }) {
  return (
    <>
      <h3>{title}</h3>
      <dl class="facts">
        {words
          .filter(([key]) => of[key] !== undefined && of[key] !== '')
          .map(([key, label]) => (
            <div key={key}>
              <dt>{label}</dt>
              <dd>
                <Foreign text={String(of[key])} />
              </dd>
            </div>
          ))}
      </dl>
    </>
  );
}

interface EngineRow {
  first: Verdict;
  verdicts: number;
}

function engines(verdicts: Verdict[]): EngineRow[] {
  const out = new Map<string, EngineRow>();
  for (const v of verdicts) {
    const key = [v.engine, v.version, v.precision, v.path, v.gyroscopic, v.integrator].join('\u0000');
    const row = out.get(key);
    if (row) ++row.verdicts;
    else out.set(key, { first: v, verdicts: 1 });
  }
  return [...out.values()];
}

function Engines({ verdicts }: { verdicts: Verdict[] }) {
  const rows = useMemo(() => engines(verdicts), [verdicts]);
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label="Engines">
      <table>
        <caption>Engines, one row per version, precision, path, gyroscopic mode and integrator</caption>
        <thead>
          <tr>
            {['engine', 'version', 'precision', 'path', 'gyroscopic', 'integrator', 'verdicts'].map(
              (head) => (
                <th key={head} scope="col">
                  {head}
                </th>
              ),
            )}
          </tr>
        </thead>
        <tbody>
          {rows.map(({ first: v, verdicts: n }, i) => (
            <tr key={i}>
              <th scope="row">{visible(v.engine)}</th>
              <td>
                {visible(v.version)}
                {v.version_listed ? '' : ' (unlisted)'}
              </td>
              <td>{visible(v.precision)}</td>
              <td>{visible(v.path)}</td>
              <td>{visible(v.gyroscopic)}</td>
              <td>{visible(v.integrator)}</td>
              <td class="number">{n}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Scenarios({ verdicts }: { verdicts: Verdict[] }) {
  const hashes = useMemo(() => [...new Map(verdicts.map((v) => [v.scenario, v.scenario_hash]))], [verdicts]);
  return (
    <details>
      <summary>{count(hashes.length, 'scenario')}: content hashes</summary>
      <div class="scroll" tabIndex={0} role="region" aria-label="Hashes of the scenarios">
        <table>
          <thead>
            <tr>
              <th scope="col">scenario</th>
              <th scope="col">hash</th>
            </tr>
          </thead>
          <tbody>
            {hashes.map(([name, hash]) => (
              <tr key={name}>
                <th scope="row">{visible(name)}</th>
                <td>
                  <code>{visible(hash)}</code>
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </details>
  );
}

export function ProvenanceSection({ index }: { index: Index }) {
  const cautions = warnings(index.results);
  return (
    <section aria-labelledby="provenance-heading">
      <h2 id="provenance-heading">Provenance</h2>
      <p>{cautions.length > 0 ? cautions.map(visible).join(' ') : 'No warnings.'}</p>
      {index.omitted_traces ? <p>{visible(index.omitted_traces)}</p> : null}
      {index.results.verdicts.length > 0 ? <Facts of={index.results.provenance} title="This run" /> : null}
      {index.baseline ? <Facts of={index.baseline.provenance} title="Baseline" /> : null}
      {index.trades.map((trade, i) => (
        <Facts key={i} of={trade.provenance} title={`Speed against accuracy, file ${i + 1}`} />
      ))}
      <Engines verdicts={index.results.verdicts} />
      <Scenarios verdicts={index.results.verdicts} />
    </section>
  );
}
