// The head of the matrix: a row of families where that helps, and the row of columns.
import { hasFamilyRow, type Family } from '../families';
import type { Column } from '../fold';
import { withSubsteps } from '../substeps';
import { Name } from '../text';
import { visible } from '../visible';

/** A family of one column of its own name is not named twice: its one head spans both rows. */
function isAlone({ name, columns: [first, second] }: Family, columns: Column[]): boolean {
  return second === undefined && columns[first!]!.label === name;
}

/** How many rows the head of these families has: 1 or 2. */
export function headRows(families: Family[], columns: Column[]): number {
  return hasFamilyRow(families) && families.some((f) => !isAlone(f, columns)) ? 2 : 1;
}

/** Columns as the head groups them, so that scope="colgroup" means something. */
export function ColumnGroups({ families }: { families: Family[] }) {
  return (
    <>
      <colgroup class="names" />
      {families.map(({ name, columns }) => (
        <colgroup key={name} span={columns.length} />
      ))}
    </>
  );
}

function ColumnHead({ column, starts, rows }: { column: Column; starts: boolean; rows: number }) {
  return (
    <th scope="col" class={starts ? 'starts' : undefined} rowSpan={rows}>
      <Name text={column.label} />
      {column.substeps > 1 ? <span class="title">{withSubsteps('', column.substeps)}</span> : null}
    </th>
  );
}

export function MatrixHead({ families, columns }: { families: Family[]; columns: Column[] }) {
  const rows = headRows(families, columns);
  const below = rows === 1 ? families : families.filter((f) => !isAlone(f, columns));
  const corner = (
    <th scope="col" class="corner" rowSpan={rows}>
      scenario
    </th>
  );
  return (
    <thead>
      {rows === 2 ? (
        <tr aria-rowindex={1}>
          {corner}
          {families.map((f) =>
            isAlone(f, columns) ? (
              <ColumnHead key={f.name} column={columns[f.columns[0]!]!} starts rows={2} />
            ) : (
              <th key={f.name} scope="colgroup" class="family starts" colSpan={f.columns.length}>
                <span>{visible(f.name)}</span>
              </th>
            ),
          )}
        </tr>
      ) : null}
      <tr aria-rowindex={rows}>
        {rows === 1 ? corner : null}
        {below.flatMap((f) =>
          f.columns.map((j, i) => <ColumnHead key={j} column={columns[j]!} starts={i === 0} rows={1} />),
        )}
      </tr>
    </thead>
  );
}
