// Statuses and digits, as the program prints them (reports/verdict_matrix.cc, reports/console_options.cc), but for
// the sign of timeout: few fonts have the console's hourglass, or have it as a picture.
import type { Status, Verdict } from '../shared/documents';

export interface Look {
  glyph: string; // with the selector of text presentation where a font may have a picture
  meaning: string;
  tone: 'pass' | 'unsupported' | 'undecided' | 'low-quality' | 'fail' | 'broken';
}

/** From best to worst. */
export const looks: Record<Status, Look> = {
  pass: { glyph: '\u2713', meaning: 'within tolerance', tone: 'pass' },
  unsupported: { glyph: '\u2013', meaning: 'the engine refuses the scene', tone: 'unsupported' },
  undecided: { glyph: '?', meaning: 'undecided: the tolerance lies within the uncertainty, or theory bounds nothing', tone: 'undecided' },
  'low-quality': { glyph: '~', meaning: 'within ten times the tolerance', tone: 'low-quality' },
  fail: { glyph: '\u2717', meaning: 'beyond that', tone: 'fail' },
  'non-finite': { glyph: '\u221e non-finite', meaning: 'NaN or infinite', tone: 'broken' },
  timeout: { glyph: '\u25f7 timeout', meaning: 'no end before the deadline', tone: 'broken' },
  crash: { glyph: '\u2620\ufe0e crash', meaning: 'the worker died', tone: 'broken' },
  protocol: { glyph: '\u203d protocol', meaning: 'the worker sent garbage', tone: 'broken' },
};

export const statuses = Object.keys(looks) as Status[];

export function severity(status: Status): number {
  return statuses.indexOf(status);
}

export function isMeasured(status: Status): boolean {
  return status === 'pass' || status === 'low-quality' || status === 'fail' || status === 'undecided';
}

/** Whether `allowed` says anything: of what is measured, and of what is not finite. */
export function hasAllowed(status: Status): boolean {
  return isMeasured(status) || status === 'non-finite';
}

/** log10(allowed / measured) in [-99, 99]: 99 for an error of nothing, -99 for one that is not finite. */
export function digits(measured: number | null, allowed: number | null): number {
  if (measured === null || allowed === null || !Number.isFinite(measured)) return -99;
  if (measured === 0) return 99;
  if (allowed === 0) return -99;
  return Math.min(99, Math.max(-99, Math.log10(allowed / measured)));
}

export function differs(verdict: Verdict): boolean {
  return !verdict.as_expected;
}

/** Best first; what was not measured by severity alone. */
export function compare(a: Verdict, b: Verdict): number {
  const order = severity(a.status) - severity(b.status);
  if (order !== 0 || !isMeasured(a.status)) return order;
  return digits(b.measured, b.allowed) - digits(a.measured, a.allowed);
}

export function worstFirst(verdicts: Verdict[]): Verdict[] {
  return [...verdicts].sort((a, b) => Number(differs(b)) - Number(differs(a)) || compare(b, a));
}
