// Which columns to show, a group of boxes per family.
import type { Column } from '../fold';
import { grouped, type Family } from '../families';
import { visible } from '../visible';

interface FamilyBoxesProps {
  family: Family;
  columns: Column[];
  shown: boolean[];
  onShow: (which: number[], show: boolean) => void;
}

/** The box in the legend is for all columns of the family; a family of one column of its own name needs no other. */
function FamilyBoxes({ family, columns, shown, onShow }: FamilyBoxesProps) {
  const count = family.columns.filter((j) => shown[j]).length;
  const all = count === family.columns.length;
  const alone = family.columns.length === 1 && columns[family.columns[0]!]!.label === family.name;
  return (
    <fieldset class="family">
      <legend>
        <label>
          <input
            type="checkbox"
            checked={all}
            indeterminate={count > 0 && !all}
            onChange={() => onShow(family.columns, !all)}
          />
          <span>
            {visible(family.name)}
            {alone ? null : <span class="of">, {count} of {family.columns.length}</span>}
          </span>
        </label>
      </legend>
      {alone
        ? null
        : family.columns.map((j) => (
            <label key={j}>
              <input type="checkbox" checked={shown[j]} onChange={() => onShow([j], !shown[j])} />
              <span>{visible(columns[j]!.label)}</span>
            </label>
          ))}
    </fieldset>
  );
}

interface ColumnChoiceProps {
  columns: Column[];
  shown: boolean[];
  onChange: (shown: boolean[]) => void;
}

export function ColumnChoice({ columns, shown, onChange }: ColumnChoiceProps) {
  const show = (which: number[], value: boolean) =>
    onChange(shown.map((s, k) => (which.includes(k) ? value : s)));
  const everything = columns.map(() => true);
  return (
    <details class="column-choice">
      <summary>
        Columns: {shown.filter(Boolean).length} of {columns.length}
      </summary>
      <fieldset class="families">
        <legend class="unseen">Columns to show</legend>
        {grouped(columns, everything).map((family) => (
          <FamilyBoxes key={family.name} family={family} columns={columns} shown={shown} onShow={show} />
        ))}
      </fieldset>
      <p class="choice-note">
        <button type="button" disabled={shown.every(Boolean)} onClick={() => onChange(everything)}>
          show all columns
        </button>{' '}
        Your browser remembers the choice, and the address contains it.
      </p>
    </details>
  );
}
