// Verdicts to a matrix of scenarios and engines: a cell is the worst of its claims (as reports/verdict_matrix.cc
// folds).
import { stepInWords } from '../shared/durations';
import type { Status, Verdict } from '../shared/documents';
import { families } from './families';
import { differs, digits, isMeasured, severity } from './status';

/** What one run of one engine is called. */
export interface CellName {
  scenario: string;
  engine: string;
  integrator: string;
  dt: string;
}

export interface Cell extends CellName {
  verdicts: Verdict[];
  worst: Status;
  digits: number | null; // the least of the measured claims; null: none is
  differs: boolean;
  closedForm: boolean; // the engine took no steps
  passedBy: string[]; // of a refusal: the columns that pass the same row, so that it is avoidable
}

export interface Column {
  engine: string;
  integrator: string;
  label: string;
  family: string;
  substeps: number; // the most that the engine made of a step
}

export interface Row {
  scenario: string;
  dt: string;
  label: string;
  cells: (Cell | null)[];
}

export interface Matrix {
  columns: Column[];
  rows: Row[];
}

const separator = '\u0000';

/** Pairs in order of first appearance; the second word is shown only where a first word has several. */
class Labels {
  private readonly order = new Map<string, { index: number; first: string; second: string }>();
  private readonly several = new Map<string, number>();

  index(first: string, second: string): number {
    const key = first + separator + second;
    const known = this.order.get(key);
    if (known) return known.index;
    this.order.set(key, { index: this.order.size, first, second });
    this.several.set(first, (this.several.get(first) ?? 0) + 1);
    return this.order.size - 1;
  }

  all(): { first: string; second: string; label: string }[] {
    return [...this.order.values()].map(({ first, second }) => ({
      first,
      second,
      label: this.several.get(first)! > 1 ? `${first} ${stepInWords(second)}` : first, // an integrator stays as it is
    }));
  }
}

// A claim that an engine cannot answer is no refusal where it answers others.
function join(cell: Cell, verdict: Verdict): void {
  const worse = verdict.status !== 'unsupported' && severity(verdict.status) > severity(cell.worst);
  if (cell.worst === 'unsupported' || worse) cell.worst = verdict.status;
  if (isMeasured(verdict.status)) {
    const won = digits(verdict.measured, verdict.allowed);
    cell.digits = cell.digits === null ? won : Math.min(cell.digits, won);
  }
  cell.differs ||= differs(verdict);
  cell.closedForm ||= verdict.closed_form;
  cell.verdicts.push(verdict);
}

function markAvoidable(row: Row, columns: Column[]): void {
  const passing = columns.filter((_, j) => row.cells[j]?.worst === 'pass').map(({ label }) => label);
  for (const cell of row.cells) if (cell?.worst === 'unsupported') cell.passedBy = passing;
}

/** The integrator of a verdict's column. An engine may choose it by the scene: only one that ran a scene by several has
 * several columns. A run without one, as the engine could not express the scene, stands with the engine's first. */
function columnIntegrators(verdicts: Verdict[]): (v: Verdict) => string {
  const first = new Map<string, string>();
  const one = new Map<string, string>();
  const several = new Set<string>();
  for (const v of verdicts) {
    if (v.integrator === '') continue;
    if (!first.has(v.engine)) first.set(v.engine, v.integrator);
    const cell = [v.engine, v.scenario, v.dt_text].join(separator);
    if (!one.has(cell)) one.set(cell, v.integrator);
    if (one.get(cell) !== v.integrator) several.add(v.engine);
  }
  return (v) => (several.has(v.engine) ? v.integrator || (first.get(v.engine) ?? '') : '');
}

/** The version that each engine says; a run that ended at once says none. */
function versionsOf(verdicts: Verdict[]): Map<string, string> {
  const out = new Map<string, string>();
  for (const v of verdicts) out.set(v.engine, out.get(v.engine) || v.version);
  return out;
}

export function fold(verdicts: Verdict[]): Matrix {
  const scenarios = new Labels();
  const engines = new Labels();
  const integratorOf = columnIntegrators(verdicts);
  const cells: (Cell | undefined)[][] = [];
  const substeps: number[] = []; // by column
  for (const v of verdicts) {
    const row = (cells[scenarios.index(v.scenario, v.dt_text)] ??= []);
    const j = engines.index(v.engine, integratorOf(v));
    const { scenario, engine, integrator, dt_text: dt, status: worst } = v;
    row[j] ??= { scenario, engine, integrator, dt, verdicts: [], worst, digits: null, differs: false, closedForm: false, passedBy: [] };
    join(row[j], v);
    substeps[j] = Math.max(substeps[j] ?? 1, v.substeps ?? 1);
  }
  const familyOf = families(versionsOf(verdicts));
  const columns = engines.all().map(({ first, second, label }, j) => ({
    engine: first,
    integrator: second,
    label,
    family: familyOf.get(first)!,
    substeps: substeps[j]!,
  }));
  const rows = scenarios.all().map(({ first, second, label }, i) => ({
    scenario: first,
    dt: second,
    label,
    cells: columns.map((_, j) => cells[i]?.[j] ?? null),
  }));
  for (const row of rows) markAvoidable(row, columns);
  return { columns, rows };
}

/** Scenarios of several steps, of which a name without its step would be that of several rows. */
export function severalSteps(verdicts: Verdict[]): Set<string> {
  const steps = new Map<string, number | string>();
  const out = new Set<string>();
  for (const v of verdicts) {
    const step = v.dt ?? v.dt_text;
    if ((steps.get(v.scenario) ?? step) !== step) out.add(v.scenario);
    steps.set(v.scenario, step);
  }
  return out;
}

/** Scenarios that a column runs, at every step that it was asked for, of those that it was asked for. */
export function supported(matrix: Matrix, column: number): { run: number; asked: number } {
  const runs = new Map<string, boolean>();
  for (const { scenario, cells } of matrix.rows) {
    const cell = cells[column];
    if (cell) runs.set(scenario, (runs.get(scenario) ?? true) && cell.worst !== 'unsupported');
  }
  return { run: [...runs.values()].filter(Boolean).length, asked: runs.size };
}

export function find(matrix: Matrix, name: CellName): Cell | null {
  const row = matrix.rows.find((r) => r.scenario === name.scenario && r.dt === name.dt);
  const same = (v: Verdict) => v.engine === name.engine && v.integrator === name.integrator;
  return row?.cells.find((cell) => cell?.verdicts.some(same)) ?? null;
}

/** How bad a row is, for sorting: worse rows have greater keys. */
export function badness(row: Row): [number, number, number] {
  let different = 0;
  let worst = -1;
  let least = 100;
  for (const cell of row.cells) {
    if (!cell) continue;
    if (cell.differs) different = 1;
    // A refusal that another engine shows to be avoidable counts as a failure.
    worst = Math.max(worst, severity(cell.passedBy.length > 0 ? 'fail' : cell.worst));
    least = Math.min(least, cell.digits ?? 100);
  }
  return [different, worst, -least];
}
