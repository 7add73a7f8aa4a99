// The verdict line, in the words of `cylon run`.
import type { Results, Status, Verdict } from '../shared/documents';
import { count } from './numbers';
import { differs, severity } from './status';

function tally(verdicts: Verdict[]): string {
  const counts = new Map<Status, number>();
  for (const v of verdicts) counts.set(v.status, (counts.get(v.status) ?? 0) + 1);
  const worst = [...counts].sort(([a], [b]) => severity(b) - severity(a));
  return worst.map(([status, n]) => `${n} ${status}`).join(', ');
}

export interface Summary {
  total: number;
  differ: Verdict[];
  differText: string; // "2 differ (1 crash, 1 fail)"
  expectedText: string; // "718 as expected (2 crash, 99 fail), 1 undecided"
  passText: string;
}

export function summary(verdicts: Verdict[]): Summary {
  const differ = verdicts.filter(differs);
  const undecided = verdicts.filter((v) => !differs(v) && v.status === 'undecided').length;
  const expected = verdicts.filter((v) => !differs(v) && v.status !== 'pass' && v.status !== 'undecided');
  const passed = verdicts.length - differ.length - expected.length - undecided;
  const named = (text: string, list: Verdict[]) => (list.length > 0 ? `${text} (${tally(list)})` : text);
  return {
    total: verdicts.length,
    differ,
    differText: named(`${differ.length} ${differ.length === 1 ? 'differs' : 'differ'}`, differ),
    expectedText:
      named(`${expected.length} as expected`, expected) + (undecided > 0 ? `, ${undecided} undecided` : ''),
    passText: `${passed} pass`,
  };
}

/** What makes these verdicts mean less than they seem to. */
export function warnings(results: Results): string[] {
  const out: string[] = [];
  const scales = new Set([
    results.provenance.tolerance_scale,
    ...results.verdicts.map((v) => v.tolerance_scale),
  ]);
  scales.delete(1);
  if (scales.size > 0)
    out.push(
      `All tolerances are multiplied by ${[...scales].join(', ')}: the verdicts are not those of the stated tolerances.`,
    );
  const unlisted = new Map<string, number>();
  for (const v of results.verdicts)
    if (!v.version_listed) {
      const name = `${v.engine} ${v.version}`;
      unlisted.set(name, (unlisted.get(name) ?? 0) + 1);
    }
  for (const [name, n] of unlisted)
    out.push(
      `expected.toml does not list ${name}: ` +
        `${count(n, 'verdict')} ${n === 1 ? 'is' : 'are'} compared with the expectations for other versions.`,
    );
  return out;
}
