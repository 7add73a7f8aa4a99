// A status as glyph, words and tone: never colour alone.
import type { Status } from '../shared/documents';
import { digitsText } from './numbers';
import { isMeasured, looks } from './status';

export function StatusMark({ status, word = true }: { status: Status; word?: boolean }) {
  const { glyph, tone } = looks[status];
  const named = glyph.includes(' ');
  return <span class={`status ${tone}`}>{word && !named ? `${glyph} ${status}` : glyph}</span>;
}

export function Differs({ text = '!' }: { text?: string }) {
  return (
    <strong class="differs">
      <span aria-hidden="true">{text}</span>
      <span class="unseen">differs from expected.toml</span>
    </strong>
  );
}

/** What a screen reader says of a cell of the matrix. */
export function spoken(status: Status, digits: number | null, differs: boolean): string {
  const won = isMeasured(status) && digits !== null ? `, ${digitsText(digits)} digits` : '';
  return `${status}${won}${differs ? ', differs from expected.toml' : ''}`;
}
