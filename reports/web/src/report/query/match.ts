// Whether a row of the matrix answers a query.  Terms about engines look at all columns, shown or not.
import type { ScenarioView } from '../../shared/documents';
import type { Cell, Column, Row } from '../fold';
import { distance, type Field, type Named, type Query, QueryError, type Relation } from './parse';

/** '*' is any text, '?' any letter; a glob matches the whole text, whatever the case.  Takes at most the
 * product of both lengths, as a link may hold any glob. */
export function glob(pattern: string): (text: string) => boolean {
  const wanted = pattern.toLowerCase();
  return (text) => matches(wanted, text.toLowerCase());
}

function matches(pattern: string, text: string): boolean {
  let [p, t] = [0, 0];
  let [star, from] = [-1, 0]; // the last '*', and where the text goes on after what it took
  while (t < text.length) {
    if (pattern[p] === '*') {
      star = p++;
      from = t;
    } else if (p < pattern.length && (pattern[p] === '?' || pattern[p] === text[t])) {
      ++p;
      ++t;
    } else if (star >= 0) {
      p = star + 1;
      t = ++from;
    } else {
      return false;
    }
  }
  while (pattern[p] === '*') ++p;
  return p === pattern.length;
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

const longestName = 64; // a distance costs the product of both lengths, and a link may hold any name

/** Throws QueryError for an engine that no column has: its terms would hold nowhere, and `not` of them everywhere. */
export function requireKnown(engines: Named[], columns: Column[]): void {
  for (const { name, at } of engines) {
    const fits = glob(name);
    if (columns.some((c) => fits(c.engine) || fits(c.label))) continue;
    const near =
      name.length > longestName ? undefined : columns.map((c) => c.engine).find((engine) => distance(engine.toLowerCase(), name) <= 2);
    const hint = near ? `, did you mean '${near}'?` : '';
    throw new QueryError(`no engine of this report is called '${name}'${hint}`, at, name.length);
  }
}

function onEngines(pattern: string, columns: Column[], test: (cell: Cell | null) => boolean): Test {
  const fits = glob(pattern);
  const chosen = columns.flatMap((c, j) => (fits(c.engine) || fits(c.label) ? [j] : []));
  return (row) => chosen.some((j) => test(row.cells[j] ?? null));
}

function onField(field: Field, pattern: string, views: Map<string, ScenarioView>): Test {
  const fits = glob(pattern);
  switch (field) {
    case 'scenario':
      return (row) => fits(row.scenario);
    case 'tag':
      return (row) => views.get(row.scenario)?.tags.some(fits) ?? false;
    case 'claim':
      return (row) =>
        row.cells.some((cell) => cell?.verdicts.some((v) => fits(v.claim) || fits(v.observable)));
  }
}

function onWord(text: string, views: Map<string, ScenarioView>): Test {
  const fits = /[*?]/.test(text) ? glob(`*${text}*`) : (whole: string) => whole.toLowerCase().includes(text);
  return (row) => fits(row.scenario) || fits(views.get(row.scenario)?.title ?? '');
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
    const fits = glob(away ? pattern.slice(1) : pattern);
    columns.forEach((c, j) => {
      if (fits(c.engine) || fits(c.label)) shown[j] = !away;
    });
  }
  return shown;
}
