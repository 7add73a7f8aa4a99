// The table of the matrix.  Rows beyond the first few hundred are drawn when somebody comes near them.
import { useCallback, useEffect, useRef, useState } from 'preact/hooks';

import { cellAddress, link } from '../address';
import type { Family } from '../families';
import type { Cell, Column, Row } from '../fold';
import { wonText } from '../numbers';
import { isMeasured, looks } from '../status';
import { Differs, spoken } from '../status_mark';
import { Name } from '../text';
import { visible } from '../visible';
import { useGridKeys } from './grid_keys';
import { ColumnGroups, headRows, MatrixHead } from './head';
import { memo } from './memo';

const chunk = 200; // rows drawn at a time
const roomy = 12; // columns; more of them are drawn dense

function CellLink({ cell, row, column }: { cell: Cell; row: number; column: number }) {
  const { glyph } = looks[cell.worst];
  const won = isMeasured(cell.worst) && cell.digits !== null ? ` ${wonText(cell.digits)}` : '';
  const name = visible(`${cell.scenario}, ${cell.engine}`);
  const avoidable = cell.passedBy.length > 0 ? ' avoidable' : '';
  const closed = cell.closedForm ? ' =' : '';
  return (
    <a
      href={link(cellAddress(cell))}
      class="cell"
      tabIndex={-1}
      data-row={row}
      data-column={column}
      aria-label={`${name}: ${spoken(cell.worst, cell.digits, cell.differs)}${cell.closedForm ? ', closed form' : ''}${avoidable}`}
    >
      {glyph + won + closed + avoidable}
      {cell.differs ? <Differs /> : null}
    </a>
  );
}

function classOf(cell: Cell | null | undefined, starts: boolean): string | undefined {
  const tone = cell && (cell.passedBy.length > 0 ? 'avoidable' : looks[cell.worst].tone);
  const words = [tone, cell?.differs && 'has-differs', starts && 'starts'].filter(Boolean);
  return words.length > 0 ? words.join(' ') : undefined;
}

function Empty({ row, column }: { row: number; column: number }) {
  return (
    <span class="cell none" tabIndex={-1} data-row={row} data-column={column}>
      <span class="unseen">not run</span>
    </span>
  );
}

interface LineProps {
  row: Row;
  index: number;
  above: number; // rows of the head
  title: string;
  families: Family[];
  version: string; // of the address: links in the row are made from it
}

const Line = memo(({ row, index, above, title, families }: LineProps) => {
  let column = 0;
  return (
    <tr aria-rowindex={index + above + 1}>
      <th scope="row">
        <span class="name">
          <Name text={row.label} />
        </span>
        {title && title !== row.label ? <span class="title">{visible(title)}</span> : null}
      </th>
      {families.flatMap((family) =>
        family.columns.map((j, i) => {
          const cell = row.cells[j];
          const place = { row: index, column: column++ };
          return (
            <td key={j} class={classOf(cell, i === 0)}>
              {cell ? <CellLink cell={cell} {...place} /> : <Empty {...place} />}
            </td>
          );
        }),
      )}
    </tr>
  );
});

interface TableProps {
  columns: Column[];
  families: Family[]; // with the columns to show
  rows: Row[];
  titles: Map<string, string>;
  version: string;
}

export function MatrixTable({ columns, families, rows, titles, version }: TableProps) {
  const [limit, setLimit] = useState(chunk);
  const end = useRef<HTMLDivElement>(null);
  const grow = useCallback(() => setLimit((n) => n + chunk), []);
  const width = families.reduce((n, family) => n + family.columns.length, 0);
  const above = headRows(families, columns);
  const table = useGridKeys(rows.length, width, grow);
  const more = rows.length > limit;

  useEffect(() => {
    const all = () => setLimit(Infinity);
    addEventListener('beforeprint', all);
    return () => removeEventListener('beforeprint', all);
  }, []);
  useEffect(() => {
    if (!more || !end.current) return;
    const watch = new IntersectionObserver((seen) => seen.some((e) => e.isIntersecting) && grow(), {
      rootMargin: '600px',
    });
    watch.observe(end.current);
    return () => watch.disconnect();
  }, [more, limit]);

  return (
    <div class="matrix-scroll" role="region" aria-label="Matrix of scenarios and engines">
      <table
        class={width > roomy ? 'matrix dense' : 'matrix'}
        ref={table}
        role="grid"
        aria-rowcount={rows.length + above}
        aria-readonly="true"
      >
        <caption class="unseen">
          Scenarios and engines; arrow keys move, Enter opens a cell, Escape comes back
        </caption>
        <ColumnGroups families={families} />
        <MatrixHead families={families} columns={columns} />
        <tbody>
          {rows.slice(0, limit).map((row, i) => (
            <Line
              key={`${row.scenario}\u0000${row.dt}`}
              row={row}
              index={i}
              above={above}
              title={titles.get(row.scenario) ?? ''}
              families={families}
              version={version}
            />
          ))}
        </tbody>
      </table>
      {more ? (
        <div ref={end} class="matrix-end">
          {rows.length - limit} more rows{' '}
          <button type="button" onClick={() => setLimit(Infinity)}>
            draw all
          </button>
        </div>
      ) : null}
    </div>
  );
}
