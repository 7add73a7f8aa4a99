// Every claim of a cell: what was claimed, what the truth is worth, what was measured.
import { useMemo, useState } from 'preact/hooks';

import type { ErrorCurve, ScenarioView, Verdict } from '../../shared/documents';
import { Sample } from '../../shared/plot_marks';
import { short, withInterval, withUnit, wonText } from '../numbers';
import { compare, differs, digits, hasAllowed, isMeasured } from '../status';
import { Differs, StatusMark } from '../status_mark';
import { Foreign, Numbers } from '../text';
import { visible } from '../visible';

type Claim = ScenarioView['claims'][number];

export interface ClaimRow {
  verdict: Verdict;
  claim: Claim | null;
  curve: ErrorCurve | null;
  index: number; // among the cell's claims; also the style of its curve
}

export function claimRows(
  verdicts: Verdict[],
  view: ScenarioView | undefined,
  curves: ErrorCurve[],
): ClaimRow[] {
  return verdicts.map((verdict, index) => ({
    verdict,
    index,
    claim: view?.claims.find((c) => c.label === verdict.claim) ?? null,
    curve: curves.find((c) => c.claim === verdict.claim) ?? null,
  }));
}

function untilText({ until }: Claim): string {
  return until === null ? '' : `, until ${short(until)} s`;
}

/** A claim that something happens has no truth: it asks for a change. */
function Asked({ claim, verdict }: { claim: Claim | null; verdict: Verdict }) {
  if (claim?.at_least == null) return <>truth: <Truth claim={claim} verdict={verdict} /></>;
  return <Numbers text={`must change by at least ${withUnit(claim.at_least, claim.unit)}${untilText(claim)}`} />;
}

function Truth({ claim, verdict: v }: { claim: Claim | null; verdict: Verdict }) {
  const bound = v.truth_error === null ? '' : `known to ${withUnit(v.truth_error, v.unit)}`;
  if (claim === null) return <Numbers text={bound || 'not told'} />;
  const name = claim.follows === '' ? 'its initial value' : claim.follows;
  const source = claim.source ? `: ${claim.source}` : '';
  const until = untilText(claim);
  return <Numbers text={name + source + (bound ? ` (${bound})` : '') + `, ${v.evidence}` + until} />;
}

function Violation({ curve, verdict }: { curve: ErrorCurve | null; verdict: Verdict }) {
  const first = curve?.first_violation;
  if (first) {
    return (
      <>
        {short(first.time)} s, step {first.step}: {withUnit(first.value, curve.unit)}
      </>
    );
  }
  if (verdict.first_bad_step !== null) return <>not finite from step {verdict.first_bad_step}</>;
  if (curve) return <>none</>;
  return <>{hasAllowed(verdict.status) ? 'not recorded' : ''}</>;
}

interface LineProps {
  row: ClaimRow;
  shown: boolean;
  toggle: (index: number) => void;
  reasons: boolean;
}

/** What a reader must know to believe the numbers of the line above. */
function Notes({ row: { verdict: v, claim } }: { row: ClaimRow }) {
  return (
    <ul class="notes">
      {v.detail ? (
        <li>
          <Foreign text={v.detail} />
        </li>
      ) : null}
      {v.expected_reason ? (
        <li>
          expected.toml: <Foreign text={v.expected_reason} />
        </li>
      ) : null}
      <li>
        <Asked claim={claim} verdict={v} />
      </li>
      <li>
        tolerance: <Foreign text={v.reason} />
        {v.tolerance_scale === 1 ? '' : `; all times ${v.tolerance_scale}`}
        {v.spread === null ? null : (
          <Numbers text={`; runs that start an ulp apart end ${withUnit(v.spread, v.unit)} apart`} />
        )}
      </li>
    </ul>
  );
}

function Line({ row, shown, toggle, reasons }: LineProps) {
  const { verdict: v, curve, index } = row;
  return (
    <tbody class={differs(v) ? 'differing' : undefined}>
      <tr>
        <td class="on-screen">
          <label>
            <input type="checkbox" checked={shown} disabled={!curve} onChange={() => toggle(index)} />
            <span class="unseen">show the error curve of {visible(v.claim)}</span>
            {curve ? <Sample style={index} /> : null}
          </label>
        </td>
        <td>
          <StatusMark status={v.status} />
        </td>
        <th scope="rowgroup">{visible(v.claim)}</th>
        <td class="number">{isMeasured(v.status) ? withInterval(v) : ''}</td>
        <td class="number">{v.allowed === null || !hasAllowed(v.status) ? '' : withUnit(v.allowed, v.unit)}</td>
        <td class="number">{isMeasured(v.status) ? wonText(digits(v.measured, v.allowed)) : ''}</td>
        <td class="number">
          <Violation curve={curve} verdict={v} />
        </td>
        <td class="expected">
          {v.expected_size === null ? v.expected : `${withUnit(v.expected_size, v.unit)} within ×${v.expected_within}`}
          {differs(v) ? <Differs text="differs" /> : null}
        </td>
      </tr>
      {reasons ? (
        <tr>
          <td class="on-screen" />
          <td />
          <td colSpan={6}>
            <Notes row={row} />
          </td>
        </tr>
      ) : null}
    </tbody>
  );
}

const heads = ['status', 'claim', 'measured', 'allowed', 'digits', 'first violation', 'expected'];

interface ClaimsProps {
  rows: ClaimRow[];
  shown: Set<number>;
  toggle: (index: number) => void;
}

export function Claims({ rows, shown, toggle }: ClaimsProps) {
  const [worst, setWorst] = useState(false);
  const [reasons, setReasons] = useState(true);
  const sorted = useMemo(
    () => (worst ? [...rows].sort((a, b) => compare(b.verdict, a.verdict)) : rows),
    [rows, worst],
  );
  return (
    <section aria-labelledby="claims-heading">
      <h3 id="claims-heading">Claims</h3>
      <label class="on-screen">
        <input type="checkbox" checked={worst} onChange={() => setWorst(!worst)} /> worst first
      </label>{' '}
      <label class="on-screen">
        <input type="checkbox" checked={reasons} onChange={() => setReasons(!reasons)} /> truths, bounds and
        reasons
      </label>
      <div class="scroll claims" tabIndex={0} role="region" aria-label="Claims of this cell">
        <table>
          <thead>
            <tr>
              <th scope="col" class="on-screen">
                curve
              </th>
              {heads.map((head) => (
                <th key={head} scope="col">
                  {head}
                </th>
              ))}
            </tr>
          </thead>
          {sorted.map((row) => (
            <Line key={row.index} row={row} shown={shown.has(row.index)} toggle={toggle} reasons={reasons} />
          ))}
        </table>
      </div>
    </section>
  );
}
