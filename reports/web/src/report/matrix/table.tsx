// The table of the matrix.  Rows beyond the first few hundred are drawn when somebody comes near them.
import { useCallback, useEffect, useRef, useState } from 'preact/hooks';

import { cellAddress, link } from '../address';
import type { Cell, Column, Row } from '../fold';
import { digitsText } from '../numbers';
import { isMeasured, looks } from '../status';
import { Differs, spoken } from '../status_mark';
import { withSubsteps } from '../substeps';
import { visible } from '../visible';
import { useGridKeys } from './grid_keys';
import { memo } from './memo';

const chunk = 200; // rows drawn at a time

function CellLink({ cell, row, column }: { cell: Cell; row: number; column: number }) {
  const { glyph } = looks[cell.worst];
  const won = isMeasured(cell.worst) && cell.digits !== null ? ` ${digitsText(cell.digits)}` : '';
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

function toneOf(cell: Cell): string {
  const tone = cell.passedBy.length > 0 ? 'avoidable' : looks[cell.worst].tone;
  return `${tone}${cell.differs ? ' has-differs' : ''}`;
}

function Empty({ row, column }: { row: number; column: number }) {
  return (
    <span class="cell none" tabIndex={-1} data-row={row} data-column={column}>
      <span class="unseen">not run</span>
    </span>
  );
}

/** May break where the words of an engine's name meet. */
function parted(label: string) {
  return label.split(/(?<=[/=-])/).flatMap((part, i) => (i === 0 ? [part] : [<wbr key={i} />, part]));
}

interface LineProps {
  row: Row;
  index: number;
  title: string;
  shown: number[];
  version: string; // of the address: links in the row are made from it
}

const Line = memo(({ row, index, title, shown }: LineProps) => (
  <tr aria-rowindex={index + 2}>
    <th scope="row">
      <span class="name">{visible(row.label)}</span>
      {title && title !== row.label ? <span class="title">{visible(title)}</span> : null}
    </th>
    {shown.map((j, column) => {
      const cell = row.cells[j];
      return (
        <td
          key={j}
          class={cell ? toneOf(cell) : undefined}
        >
          {cell ? (
            <CellLink cell={cell} row={index} column={column} />
          ) : (
            <Empty row={index} column={column} />
          )}
        </td>
      );
    })}
  </tr>
));

interface TableProps {
  columns: Column[];
  shown: number[]; // indices into columns
  rows: Row[];
  titles: Map<string, string>;
  version: string;
}

export function MatrixTable({ columns, shown, rows, titles, version }: TableProps) {
  const [limit, setLimit] = useState(chunk);
  const end = useRef<HTMLDivElement>(null);
  const grow = useCallback(() => setLimit((n) => n + chunk), []);
  const table = useGridKeys(rows.length, shown.length, grow);
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
      <table class="matrix" ref={table} role="grid" aria-rowcount={rows.length + 1} aria-readonly="true">
        <caption class="unseen">
          Scenarios and engines; arrow keys move, Enter opens a cell, Escape comes back
        </caption>
        <thead>
          <tr aria-rowindex={1}>
            <th scope="col">scenario</th>
            {shown.map((j) => (
              <th key={j} scope="col">
                {parted(visible(columns[j]!.label))}
                {columns[j]!.substeps > 1 ? <span class="title">{withSubsteps('', columns[j]!.substeps)}</span> : null}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.slice(0, limit).map((row, i) => (
            <Line
              key={`${row.scenario}\u0000${row.dt}`}
              row={row}
              index={i}
              title={titles.get(row.scenario) ?? ''}
              shown={shown}
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
