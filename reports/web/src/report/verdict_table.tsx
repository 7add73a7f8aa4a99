// Verdicts as a list, each with the way to its cell.
import type { Verdict } from '../shared/documents';
import { cellAddress, link } from './address';
import { digitsText, withUnit } from './numbers';
import { digits, isMeasured } from './status';
import { StatusMark } from './status_mark';
import { Foreign } from './text';
import { useFew } from './use_few';
import { visible } from './visible';

export function CellName({ verdict: v }: { verdict: Verdict }) {
  const name = { scenario: v.scenario, engine: v.engine, integrator: v.integrator, dt: v.dt_text };
  return (
    <a href={link(cellAddress(name))}>
      {visible(v.scenario)} / {visible(v.engine)}
    </a>
  );
}

export function measuredText(v: Verdict): string {
  if (!isMeasured(v.status)) return v.first_bad_step === null ? '' : `not finite from step ${v.first_bad_step}`;
  return `${withUnit(v.measured, v.unit)} of ${withUnit(v.allowed, v.unit)}, ${digitsText(digits(v.measured, v.allowed))} digits`;
}

export function VerdictTable({ verdicts, caption }: { verdicts: Verdict[]; caption: string }) {
  const { list, button } = useFew(verdicts);
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label={caption}>
      <table>
        <caption>{caption}</caption>
        <thead>
          <tr>
            <th scope="col">cell</th>
            <th scope="col">claim</th>
            <th scope="col">status</th>
            <th scope="col">expected</th>
            <th scope="col">measured of allowed</th>
            <th scope="col">detail</th>
          </tr>
        </thead>
        <tbody>
          {list.map((v, i) => (
            <tr key={i}>
              <th scope="row">
                <CellName verdict={v} />
              </th>
              <td>{visible(v.claim)}</td>
              <td>
                <StatusMark status={v.status} />
              </td>
              <td>{v.expected}</td>
              <td class="number">{measuredText(v)}</td>
              <td>
                <Foreign text={v.detail} />
              </td>
            </tr>
          ))}
        </tbody>
      </table>
      {button}
    </div>
  );
}
