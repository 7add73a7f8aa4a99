// The matrix with its filter, its order and the choice of columns.
import { useLayoutEffect, useMemo, useRef } from 'preact/hooks';

import type { ScenarioView } from '../../shared/documents';
import { go, useAddress } from '../address';
import { grouped } from '../families';
import { badness, type Column, type Matrix, type Row } from '../fold';
import { matcher, requireKnown, shownColumns } from '../query/match';
import { parse, type Parsed, QueryError } from '../query/parse';
import { withColumns } from '../query/columns';
import { looks, statuses } from '../status';
import { Differs } from '../status_mark';
import { ColumnChoice } from './column_choice';
import { Filter } from './filter';
import { rememberColumns } from './remembered_columns';
import { MatrixTable } from './table';

const everything: Parsed = { query: { kind: 'all' }, columns: [], engines: [] };

function read(text: string, columns: Column[]): { parsed: Parsed; fault: QueryError | null } {
  try {
    const parsed = parse(text);
    requireKnown(parsed.engines, columns);
    return { parsed, fault: null };
  } catch (error) {
    if (error instanceof QueryError) return { parsed: everything, fault: error };
    throw error;
  }
}

function byBadness(a: Row, b: Row): number {
  const [x, y] = [badness(a), badness(b)];
  return y[0] - x[0] || y[1] - x[1] || y[2] - x[2];
}

const orders: Record<string, { label: string; compare: ((a: Row, b: Row) => number) | null }> = {
  '': { label: 'as run', compare: null },
  worst: { label: 'worst first', compare: byBadness },
  name: { label: 'by name', compare: (a, b) => a.label.localeCompare(b.label, 'en') },
};

function Legend({ rows }: { rows: Row[] }) {
  const present = new Set(rows.flatMap((row) => row.cells.map((cell) => cell?.worst)));
  return (
    <p class="legend">
      {statuses
        .filter((status) => present.has(status))
        .map((status) => (
          <span key={status}>
            <span class={`status ${looks[status].tone}`}>{looks[status].glyph}</span> {looks[status].meaning}
            ;{' '}
          </span>
        ))}
      {rows.some((row) => row.cells.some((cell) => cell && cell.passedBy.length > 0)) ? (
        <span>
          <span class="status avoidable">{looks.unsupported.glyph} avoidable</span> refused, though another engine
          passes;{' '}
        </span>
      ) : null}
      <span>
        <span class="number">+1.0</span> log10(allowed / measured) of the worst claim: + is better than
        allowed, − is worse;{' '}
      </span>
      {rows.some((row) => row.cells.some((cell) => cell?.closedForm)) ? (
        <span>= no steps: the engine has the motion in closed form; </span>
      ) : null}
      <span>
        <Differs /> differs from expected.toml
      </span>
    </p>
  );
}

interface MatrixSectionProps {
  matrix: Matrix;
  views: Map<string, ScenarioView>;
}

export function MatrixSection({ matrix, views }: MatrixSectionProps) {
  const { q: query = '', sort = '', section = '' } = useAddress();
  const input = useRef<HTMLInputElement>(null);
  const { parsed, fault } = useMemo(() => read(query, matrix.columns), [query, matrix]);
  const titles = useMemo(() => new Map([...views].map(([name, view]) => [name, view.title])), [views]);
  const shown = useMemo(() => shownColumns(parsed.columns, matrix.columns), [parsed, matrix]);
  const families = useMemo(() => grouped(matrix.columns, shown), [matrix, shown]);
  const rows = useMemo(() => {
    const found = matrix.rows.filter(matcher(parsed.query, matrix.columns, views));
    const compare = orders[sort]?.compare;
    return compare ? found.sort(compare) : found;
  }, [parsed, matrix, views, sort]);

  useLayoutEffect(() => {
    const focus = (event: KeyboardEvent) => {
      const typing = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement;
      if (event.key !== '/' || typing || event.ctrlKey || event.metaKey || !input.current?.offsetParent)
        return;
      event.preventDefault();
      input.current.select();
    };
    addEventListener('keydown', focus);
    return () => removeEventListener('keydown', focus);
  }, []);

  // What a link chose is not remembered until the reader changes it.
  const ask = (q: string) => {
    go({ q });
    const next = read(q, matrix.columns);
    const chosen = shownColumns(next.parsed.columns, matrix.columns);
    if (!next.fault && chosen.some((s, j) => s !== shown[j])) rememberColumns(matrix.columns, chosen);
  };

  return (
    <section class="matrix-section" aria-labelledby="matrix-heading">
      <h2 id="matrix-heading">Scenarios and engines</h2>
      <div class="matrix-tools">
        <Filter input={input} fault={fault} onQuery={ask} />
        <label class="sort">
          Order{' '}
          <select value={sort} onChange={(event) => go({ sort: event.currentTarget.value })}>
            {Object.entries(orders).map(([key, { label }]) => (
              <option key={key} value={key}>
                {label}
              </option>
            ))}
          </select>
        </label>
        <ColumnChoice
          columns={matrix.columns}
          shown={shown}
          onChange={(next) => ask(withColumns(query, matrix.columns, next))}
        />
      </div>
      <p class="count" role="status">
        {rows.length} of {matrix.rows.length} rows, {shown.filter(Boolean).length} of {matrix.columns.length} columns
        {rows.length === 0 ? ': nothing answers the filter' : ''}
      </p>
      <MatrixTable
        columns={matrix.columns}
        families={families}
        rows={rows}
        titles={titles}
        version={`${query} ${sort} ${section}`}
      />
      <Legend rows={matrix.rows} />
    </section>
  );
}
