// What changed between two runs of the same claims.
import type { Verdict } from '../shared/documents';
import { digits, isMeasured, severity } from './status';

export type Kind = 'status' | 'error' | 'new' | 'gone' | 'scenario';

export interface Change {
  kind: Kind;
  verdict: Verdict; // of this run; of the baseline where it is gone
  before: Verdict | null;
  weight: number; // greater is worse; of an error log10 of its growth, of a status its severity before all
}

export const kinds: Record<Kind, string> = {
  status: 'another status',
  error: 'error moved by more than 10 %',
  new: 'new',
  gone: 'gone',
  scenario: 'the scenario itself changed, not compared',
};

/** Claims of one run may have the same words; then they are told apart by their order.  A step is the same however it
 * is written. */
function keyed(verdicts: Verdict[]): Map<string, Verdict> {
  const seen = new Map<string, number>();
  const out = new Map<string, Verdict>();
  for (const v of verdicts) {
    const name = [v.scenario, v.engine, v.integrator, v.dt ?? v.dt_text, v.claim].join('\u0000');
    const nth = seen.get(name) ?? 0;
    seen.set(name, nth + 1);
    out.set(`${name}\u0000${nth}`, v);
  }
  return out;
}

/** log10 of the growth where the error moved by more than a tenth of the older one, else null. */
function moved(now: Verdict, before: Verdict): number | null {
  if (!isMeasured(now.status) || !isMeasured(before.status)) return null;
  const [a, b] = [before.measured ?? Infinity, now.measured ?? Infinity];
  if (a === b || Math.abs(b - a) <= 0.1 * Math.abs(a)) return null;
  if (a === 0 || b === 0) return b > a ? 99 : -99;
  return Math.log10(b / a);
}

function change(now: Verdict, before: Verdict | undefined): Change | null {
  if (!before) return { kind: 'new', verdict: now, before: null, weight: 0 };
  if (now.scenario_hash !== before.scenario_hash)
    return { kind: 'scenario', verdict: now, before, weight: 0 };
  if (now.status !== before.status) {
    const lost = digits(before.measured, before.allowed) - digits(now.measured, now.allowed);
    return {
      kind: 'status',
      verdict: now,
      before,
      weight: 1000 * (severity(now.status) - severity(before.status)) + lost,
    };
  }
  const weight = moved(now, before);
  return weight === null ? null : { kind: 'error', verdict: now, before, weight };
}

const order: Kind[] = ['status', 'error', 'gone', 'new', 'scenario'];

/** Worst first: other statuses, then errors, what lost most before what won. */
export function changes(now: Verdict[], baseline: Verdict[]): Change[] {
  const before = keyed(baseline);
  const out: Change[] = [];
  for (const [key, verdict] of keyed(now)) {
    const found = change(verdict, before.get(key));
    if (found) out.push(found);
    before.delete(key);
  }
  for (const verdict of before.values()) out.push({ kind: 'gone', verdict, before: verdict, weight: 0 });
  return out.sort((a, b) => order.indexOf(a.kind) - order.indexOf(b.kind) || b.weight - a.weight);
}
