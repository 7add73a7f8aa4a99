// All that is known of one cell: one engine's run of one scenario.
import { useEffect, useLayoutEffect, useMemo } from 'preact/hooks';

import type { ErrorCurve, Index, ScenarioView } from '../../shared/documents';
import { stepInWords } from '../../shared/durations';
import { address, cellAddress, go, link, sectionAddress, useAddress } from '../address';
import type { Cell, CellName, Matrix } from '../fold';
import { count, wonInWords } from '../numbers';
import { isMeasured, looks, worstFirst } from '../status';
import { Differs, StatusMark } from '../status_mark';
import { Foreign } from '../text';
import { visible } from '../visible';
import { Claims, claimRows } from './claims';
import { Command } from './copy';
import { Motion } from './motion';
import { Diagnostics, Output, Run, Settings } from './settings';
import { entryOf, useTrace } from './use_trace';

const noCurves: ErrorCurve[] = [];

/** The other cells of the row. */
function Neighbours({ matrix, cell }: { matrix: Matrix; cell: Cell }) {
  const row = matrix.rows.find((r) => r.scenario === cell.scenario && r.dt === cell.dt);
  return (
    <ul class="neighbours on-screen" aria-label="Engines of this scenario">
      {(row?.cells ?? []).flatMap((c, j) =>
        c ? (
          <li key={j}>
            <a href={link(cellAddress(c))} aria-current={c === cell ? 'page' : undefined}>
              {visible(matrix.columns[j]!.label)}{' '}
              <span class={`status ${looks[c.worst].tone}`}>{looks[c.worst].glyph}</span>
              {c.differs ? <Differs /> : null}
            </a>
          </li>
        ) : (
          []
        ),
      )}
    </ul>
  );
}

function Heading({ cell, view }: { cell: Cell; view: ScenarioView | undefined }) {
  const won = isMeasured(cell.worst) && cell.digits !== null ? `, ${wonInWords(cell.digits)}` : '';
  return (
    <>
      <h2 id="cell-heading" tabIndex={-1}>
        {visible(cell.scenario)} / {visible(cell.engine)}{' '}
        <span class="note">{visible([cell.integrator, `step ${stepInWords(cell.dt)}`].filter(Boolean).join(', '))}</span>
      </h2>
      <p class="cell-verdict">
        <StatusMark status={cell.worst} />
        {won} by the worst of {count(cell.verdicts.length, 'claim')}
        {cell.differs ? ' ' : '; as expected.toml says'}
        {cell.differs ? <Differs text="differs from expected.toml" /> : null}
      </p>
      {view ? (
        <>
          <p>
            <strong>
              <Foreign text={view.title} />
            </strong>
          </p>
          <p>
            <Foreign text={view.story} />
          </p>
        </>
      ) : (
        <p class="note">The report does not describe this scenario.</p>
      )}
    </>
  );
}

function Reproduce({ cell }: { cell: Cell }) {
  const commands = [...new Set(cell.verdicts.map((v) => v.reproduce))];
  return (
    <section aria-labelledby="reproduce-heading">
      <h3 id="reproduce-heading">To reproduce it</h3>
      {commands.map((text) => (
        <Command key={text} text={text} />
      ))}
    </section>
  );
}

function back(): void {
  go(sectionAddress(address().section ?? 'matrix'), true);
}

function useEscape(): void {
  useLayoutEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      if (event.key === 'Escape' && !event.defaultPrevented) back();
    };
    addEventListener('keydown', onKey);
    return () => removeEventListener('keydown', onKey);
  }, []);
}

interface CellPageProps {
  index: Index;
  matrix: Matrix;
  cell: Cell;
  view: ScenarioView | undefined;
}

/** Which claims' curves are shown: those of the address, else the worst that has one. */
function useShown(cell: Cell, curves: Set<string>): [Set<number>, (index: number) => void] {
  const { claims } = useAddress();
  const shown = useMemo(() => {
    if (claims !== undefined)
      return new Set(
        claims
          .split(',')
          .filter((text) => text !== '-')
          .map(Number),
      );
    const [worst] = worstFirst(cell.verdicts.filter((v) => curves.has(v.claim)));
    return new Set(worst ? [cell.verdicts.indexOf(worst)] : []);
  }, [claims, cell, curves]);
  const toggle = (index: number) => {
    const next = new Set(shown);
    if (!next.delete(index)) next.add(index);
    go({ claims: next.size === 0 ? '-' : [...next].sort((a, b) => a - b).join(',') });
  };
  return [shown, toggle];
}

export function CellPage({ index, matrix, cell, view }: CellPageProps) {
  const entry = useMemo(() => entryOf(index.traces, cell), [index, cell]);
  const loaded = useTrace(entry?.block ?? null);
  const curves = loaded.state === 'ready' ? loaded.block.trace.errors : noCurves;
  const labels = useMemo(() => new Set(curves.map((c) => c.claim)), [curves]);
  const rows = useMemo(() => claimRows(cell.verdicts, view, curves), [cell, view, curves]);
  const [shown, toggle] = useShown(cell, labels);
  const shownRows = useMemo(() => rows.filter((row) => shown.has(row.index)), [rows, shown]);
  useEscape();
  useEffect(() => {
    scrollTo(0, 0);
    document.getElementById('cell-heading')?.focus();
  }, [cell]);

  return (
    <article class="cell-page" aria-labelledby="cell-heading">
      <p class="on-screen">
        <a href={link(sectionAddress(address().section ?? 'matrix'))}>back to the matrix</a> <kbd>Escape</kbd>
      </p>
      <Neighbours matrix={matrix} cell={cell} />
      <Heading cell={cell} view={view} />
      <Reproduce cell={cell} />
      <Claims rows={rows} shown={shown} toggle={toggle} />
      {loaded.state === 'ready' ? (
        <Motion
          key={entry!.block}
          index={index}
          cell={cell}
          view={view}
          block={loaded.block}
          rows={shownRows}
        />
      ) : (
        <NoTrace
          state={loaded.state}
          why={loaded.state === 'broken' ? loaded.why : index.omitted_traces}
          cell={cell}
        />
      )}
      <div class="columns">
        <Run verdicts={cell.verdicts} view={view} />
        <Settings verdicts={cell.verdicts} />
      </div>
      <Diagnostics verdicts={cell.verdicts} />
      <Output verdicts={cell.verdicts} />
    </article>
  );
}

function NoTrace({ state, why, cell }: { state: string; why: string; cell: CellName }) {
  if (state === 'loading') return <p role="status">Unpacking the trace…</p>;
  const what =
    state === 'broken'
      ? 'The trace cannot be read.'
      : 'No trace of this run is stored: there are no curves and no pictures.';
  return (
    <section aria-label={`Trace of ${visible(cell.engine)}`}>
      <p class="empty">
        {what} {visible(why)}
      </p>
    </section>
  );
}
