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
  const unlisted = new Map<string, { all: number; explained: number }>();
  for (const v of results.verdicts)
    if (!v.version_listed) {
      const name = `${v.engine} ${v.version}`;
      const of = unlisted.get(name) ?? { all: 0, explained: 0 };
      ++of.all;
      if (v.expected_reason !== '') ++of.explained; // by a row, which is of another version
      unlisted.set(name, of);
    }
  for (const [name, { all, explained: n }] of unlisted) {
    const compared = `${count(n, 'verdict')} ${n === 1 ? 'is' : 'are'} compared with the expectations for other versions`;
    const said = n === 0 ? 'a pass is expected' : compared + (n < all ? ', of the others a pass is expected' : '');
    out.push(`expected.toml has no row for ${name}: ${said}.`);
  }
  return out;
}
