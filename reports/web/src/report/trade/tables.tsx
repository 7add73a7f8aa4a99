// The series of a work-precision plot as its legend, and every setting as a row.
import type { Ending } from '../../shared/documents';
import { Sample } from '../../shared/plot_marks';
import { duration } from '../../shared/durations';
import { short } from '../numbers';
import { StatusMark } from '../status_mark';
import { Foreign, Name } from '../text';
import { useFew } from '../use_few';
import { withSubsteps } from '../substeps';
import { visible } from '../visible';
import { isDrawn, type Point, type Series, settingOf } from './join';

function Heads({ names }: { names: string[] }) {
  return (
    <thead>
      <tr>
        {names.map((name) => (
          <th key={name} scope="col">
            {name}
          </th>
        ))}
      </tr>
    </thead>
  );
}

function floorText({ of }: Series): string {
  if (of.floor === null) return '';
  return `${short(of.floor)}${of.floor_is_rounding ? ', rounding' : ', not rounding'}`;
}

interface LegendProps {
  list: Series[];
  hidden: Set<number>;
  toggle: (series: number) => void;
}

export function Legend({ list, hidden, toggle }: LegendProps) {
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label="Engines and integrators">
      <table>
        <caption>Engines and integrators, with the order fitted to the errors</caption>
        <Heads
          names={[
            'engine and integrator',
            'version',
            'order declared',
            'order fitted',
            'floor',
            'points drawn',
            'remark',
          ]}
        />
        <tbody>
          {list.map((series, i) => (
            <tr key={i}>
              <th scope="row">
                <label>
                  <input
                    type="checkbox"
                    class="on-screen"
                    checked={!hidden.has(i)}
                    onChange={() => toggle(i)}
                  />{' '}
                  <Sample style={i} /> {visible(series.label)}
                </label>
              </th>
              <td>
                {visible(
                  [series.of.version, series.of.precision, series.of.path, series.of.gyroscopic]
                    .filter(Boolean)
                    .join(', '),
                )}
              </td>
              <td class="number">{series.of.adaptive ? 'to tolerance' : series.of.declared_order || ''}</td>
              <td class="number">
                {series.of.observed_order === null ? 'none' : series.of.observed_order.toFixed(2)}
              </td>
              <td class="number">{floorText(series)}</td>
              <td class="number">
                {series.points.filter(isDrawn).length} of {series.points.length}
              </td>
              <td>
                <Foreign text={series.of.reason} />
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** How a run ended. */
function EndingMark({ status }: { status: Ending }) {
  return status === 'ran' ? <>ran</> : <StatusMark status={status} />;
}

interface SettingsProps {
  list: Series[];
  points: Point[];
  caption: string;
}

export function SettingsTable({ list, points, caption }: SettingsProps) {
  const { list: shown, button } = useFew(points);
  if (points.length === 0) return null;
  return (
    <>
      <div class="scroll" tabIndex={0} role="region" aria-label={caption}>
        <table>
          <caption>
            {caption} ({points.length})
          </caption>
          <Heads
            names={[
              'engine and integrator',
              'step and tolerance',
              'error',
              'CPU s per s',
              'per body-step',
              'status',
              'dominated by, or why not',
            ]}
          />
          <tbody>
            {shown.map((p, i) => (
              <tr key={i}>
                <th scope="row">
                  <Name text={list[p.series]!.label} />
                </th>
                <td class="number">{visible(withSubsteps(settingOf(p), list[p.series]!.of.substeps))}</td>
                <td class="number">{short(p.error)}</td>
                <td class="number">{p.cost === null ? 'not timed' : short(p.cost)}</td>
                <td class="number">{duration(p.perBodyStep)}</td>
                <td>
                  <EndingMark status={p.status} />
                </td>
                <td>
                  <Foreign text={p.dominatedBy || p.reason} />
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      {button}
    </>
  );
}
