// What was run, where and by which builds.
import { useMemo } from 'preact/hooks';

import type { Comparisons, History, Hunt, Index, Provenance, Verdict } from '../shared/documents';
import type { FitDocument, Prediction } from '../shared/measured_documents';
import { count, short } from './numbers';
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

type Fact = [name: string, text: string];

function Facts({ of, title }: { of: Fact[]; title: string }) {
  return (
    <>
      <h3>{title}</h3>
      <dl class="facts">
        {of.map(([name, text]) =>
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
    </>
  );
}

function ofRun(of: Provenance | undefined): Fact[] {
  return words.map(([key, label]) => [label, String(of?.[key] ?? '')]);
}

// The documents of other commands say less of their making.

function ofHistory({ series }: History): Fact[] {
  const points = series.flatMap((s) => s.points).sort((a, b) => a.run - b.run);
  const [first, last] = [points[0], points[points.length - 1]];
  const named = (p: typeof first) => (p ? `${p.run}, revision ${p.revision}, ${p.date}` : '');
  const engines = series.flatMap((s) => (s.versions ?? []).map((version) => `${s.engine} ${version}`));
  return [
    ['series', String(series.length)],
    ['first run', named(first)],
    ['last run', named(last)],
    ['engines', [...new Set(engines)].join(', ')],
  ];
}

function ofComparison(of: Comparisons): Fact[] {
  return [
    ['baseline', of.baseline],
    ['candidate', of.candidate],
    ['cells', String(of.cells.length)],
    ['environment', of.reliable ? '' : 'unreliable: a build was found different from itself'],
  ];
}

function ofHunt(of: Hunt): Fact[] {
  const asked = (of.asked ?? []).map(({ engine, scenes }) => `${engine} in ${count(scenes, 'scene')}`);
  const versions = new Set(of.cards.map(({ engine, version }) => `${engine} ${version}`));
  return [
    ['asked', asked.join(', ')],
    ['with a fault', [...versions].join(', ')],
  ];
}

function ofMeasured(of: Prediction | FitDocument): Fact[] {
  const own: Fact[] =
    of.format === 'cylon-prediction/1'
      ? [
          ['hash of the model', of.model ?? ''],
          ['step [s]', short(of.step)],
          ['engines', of.engines.map(({ engine }) => engine).join(', ')],
        ]
      : [['engines', of.fits.map(({ engine }) => engine).join(', ')]];
  return [
    ['data', of.title],
    ['source', of.source],
    ['licence', of.licence],
    ['hash of the data', of.experiment],
    ...own,
  ];
}

/** Every document that is no run, with its part of the report. */
function documents(index: Index): { title: string; of: Fact[] }[] {
  const files = (title: string, list: Fact[][]) => list.map((of, i) => ({ title: `${title}, file ${i + 1}`, of }));
  return [
    ...files('Speed against accuracy', index.trades.map(({ provenance }) => ofRun(provenance))),
    ...files('Comparison of builds', index.comparisons.map(ofComparison)),
    ...files('History', index.histories.map(ofHistory)),
    ...files('Hunt', index.hunts.map(ofHunt)),
    ...files('Prediction', index.predictions.map(ofMeasured)),
    ...files('Fit', index.fits.map(ofMeasured)),
  ];
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
      {index.results.verdicts.length > 0 ? <Facts of={ofRun(index.results.provenance)} title="This run" /> : null}
      {index.baseline ? <Facts of={ofRun(index.baseline.provenance)} title="Baseline" /> : null}
      {documents(index).map((facts) => (
        <Facts key={facts.title} {...facts} />
      ))}
      {index.results.verdicts.length > 0 ? (
        <>
          <Engines verdicts={index.results.verdicts} />
          <Scenarios verdicts={index.results.verdicts} />
        </>
      ) : null}
    </section>
  );
}
