// Whether a row of the matrix answers a query.  Terms about engines look at all columns, shown or not.
import type { ScenarioView } from '../../shared/documents';
import type { Cell, Column, Row } from '../fold';
import type { Field, Query, Relation } from './parse';

/** '*' is any text, '?' any letter; a glob matches the whole text. */
export function glob(pattern: string): (text: string) => boolean {
  const source = pattern
    .replace(/[.+^${}()|[\]\\]/g, '\\$&')
    .replace(/\*+/g, '.*')
    .replace(/\?/g, '.');
  const whole = new RegExp(`^${source}$`, 'is');
  return (text) => whole.test(text);
}

type Test = (row: Row) => boolean;

const relations: Record<Relation, (a: number, b: number) => boolean> = {
  '<': (a, b) => a < b,
  '<=': (a, b) => a <= b,
  '>': (a, b) => a > b,
  '>=': (a, b) => a >= b,
  '=': (a, b) => a === b,
};

/** 'pass': all claims do; 'none': there is no run; another status: some claim has it. */
function has(status: string): (cell: Cell | null) => boolean {
  switch (status) {
    case 'none':
      return (cell) => cell === null;
    case 'pass':
      return (cell) => cell?.worst === 'pass';
    case 'differs':
      return (cell) => cell?.differs === true;
    case 'expected':
      return (cell) => cell?.differs === false;
    default:
      return (cell) => cell !== null && cell.verdicts.some((v) => v.status === status);
  }
}

function onEngines(pattern: string, columns: Column[], test: (cell: Cell | null) => boolean): Test {
  const matches = glob(pattern);
  const chosen = columns.flatMap((c, j) => (matches(c.engine) || matches(c.label) ? [j] : []));
  return (row) => chosen.some((j) => test(row.cells[j] ?? null));
}

function onField(field: Field, pattern: string, views: Map<string, ScenarioView>): Test {
  const matches = glob(pattern);
  switch (field) {
    case 'scenario':
      return (row) => matches(row.scenario);
    case 'tag':
      return (row) => views.get(row.scenario)?.tags.some(matches) ?? false;
    case 'claim':
      return (row) =>
        row.cells.some((cell) => cell?.verdicts.some((v) => matches(v.claim) || matches(v.observable)));
  }
}

function onWord(text: string, views: Map<string, ScenarioView>): Test {
  const matches = /[*?]/.test(text)
    ? glob(`*${text}*`)
    : (whole: string) => whole.toLowerCase().includes(text);
  return (row) => matches(row.scenario) || matches(views.get(row.scenario)?.title ?? '');
}

export function matcher(query: Query, columns: Column[], views: Map<string, ScenarioView>): Test {
  const part = (q: Query): Test => matcher(q, columns, views);
  switch (query.kind) {
    case 'all':
      return () => true;
    case 'and': {
      const tests = query.parts.map(part);
      return (row) => tests.every((test) => test(row));
    }
    case 'or': {
      const tests = query.parts.map(part);
      return (row) => tests.some((test) => test(row));
    }
    case 'not': {
      const test = part(query.part);
      return (row) => !test(row);
    }
    case 'word':
      return onWord(query.text, views);
    case 'field':
      return onField(query.field, query.glob, views);
    case 'status':
      return onEngines(query.engine, columns, has(query.status));
    case 'digits': {
      const holds = relations[query.relation];
      return onEngines(
        query.engine,
        columns,
        (cell) => cell?.digits != null && holds(cell.digits, query.value),
      );
    }
  }
}

/** Globs in order; one that starts with '-' takes away, and where the first does it takes away from all. */
export function shownColumns(globs: string[], columns: Column[]): boolean[] {
  const shown = columns.map(() => globs.length === 0 || globs[0]!.startsWith('-'));
  for (const pattern of globs) {
    const away = pattern.startsWith('-');
    const matches = glob(away ? pattern.slice(1) : pattern);
    columns.forEach((c, j) => {
      if (matches(c.engine) || matches(c.label)) shown[j] = !away;
    });
  }
  return shown;
}
