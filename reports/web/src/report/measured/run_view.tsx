// One run: measured and predicted curves with the band, what is left between them, and the bodies in 3D.
import { useMemo, useState } from 'preact/hooks';

import type { Frames } from '../../shared/block';
import type { DrawnPrediction, DrawnRun, MotionLists, Prediction } from '../../shared/measured_documents';
import { TimePlot } from '../../shared/plot';
import { TimeCursor } from '../../shared/plot_cursor';
import type { Curve } from '../../shared/plot_data';
import { CurveTable, described } from '../cell/curve_table';
import { framed } from '../cell/divergence';
import { CameraLink, Pane } from '../cell/pane';
import { Timeline } from '../cell/timeline';
import { short } from '../numbers';
import { visible } from '../visible';
import { valuesOf } from './data_sets';

const measuredStyle = 0;

function frames(time: number[], { position, orientation }: MotionLists): Frames {
  return {
    time: Float32Array.from(time),
    position: Float32Array.from(position),
    orientation: Float32Array.from(orientation),
  };
}

/** Lengths in mm, angles as they are. */
function scaleOf(unit: string): [number, string] {
  return unit === 'm' ? [1000, 'mm'] : [1, unit];
}

const times = (list: number[], scale: number) => list.map((x) => scale * x);
const less = (list: number[], by: number[]) => list.map((x, i) => x - by[i]!);

interface Chosen {
  prediction: Prediction;
  run: DrawnRun;
  at: number; // place of the run
  engine: number; // place of the engine
}

function drawnBy({ prediction, at }: Chosen, engine: number): DrawnPrediction | null {
  const drawn = prediction.engines[engine]?.drawn[at];
  return drawn && !drawn.failure ? drawn : null;
}

function bandOf(drawn: DrawnPrediction, k: number, scale: number, minus: number[] | null) {
  const [low, high] = [drawn.low[k], drawn.high[k]];
  if (!low || !high) return null;
  const shown = (list: number[]) => times(minus ? less(list, minus) : list, scale);
  return { low: shown(low), high: shown(high) };
}

/** What was measured, and what every engine predicts; the band of the chosen one. */
function valueCurves(chosen: Chosen, k: number, scale: number): Curve[] {
  const { prediction, run, engine } = chosen;
  const { time } = run;
  const out: Curve[] = [{ label: 'measured', style: measuredStyle, time, value: times(run.measured[k]!, scale) }];
  prediction.engines.forEach(({ engine: name }, i) => {
    const drawn = drawnBy(chosen, i);
    if (!drawn) return;
    const band = i === engine ? bandOf(drawn, k, scale, null) : null;
    out.push({ label: name, style: i + 1, faint: i !== engine, time, value: times(drawn.predicted[k]!, scale), band });
  });
  return out;
}

/** Measured less predicted, of every engine; the chosen one's band about its prediction. */
function restCurves(chosen: Chosen, k: number, scale: number): Curve[] {
  const { prediction, run, engine } = chosen;
  return prediction.engines.flatMap(({ engine: name }, i): Curve[] => {
    const drawn = drawnBy(chosen, i);
    if (!drawn) return [];
    const predicted = drawn.predicted[k]!;
    const band = i === engine ? bandOf(drawn, k, scale, predicted) : null;
    const value = times(less(run.measured[k]!, predicted), scale);
    return [{ label: `measured less ${name}`, style: i + 1, faint: i !== engine, time: run.time, value, band }];
  });
}

function turnCurves(chosen: Chosen): Curve[] {
  return chosen.prediction.engines.flatMap(({ engine: name }, i): Curve[] => {
    const drawn = drawnBy(chosen, i);
    if (!drawn || drawn.turn.length === 0) return [];
    const value = times(drawn.turn, 180 / Math.PI);
    return [{ label: name, style: i + 1, faint: i !== chosen.engine, time: chosen.run.time, value }];
  });
}

interface PlotProps {
  title: string;
  axis: string;
  unit: string;
  curves: Curve[];
  cursor: TimeCursor;
}

function Plot({ title, axis, unit, curves, cursor }: PlotProps) {
  if (curves.length === 0) return null;
  return (
    <figure>
      <TimePlot
        curves={curves}
        label={described(title, curves, unit)}
        axis={axis}
        log={false}
        cursor={cursor}
        number={short}
        height={210}
      />
      <figcaption>
        <CurveTable curves={curves} cursor={cursor} log={false} unit={unit} caption={title} />
      </figcaption>
    </figure>
  );
}

function Picture({ chosen, cursor }: { chosen: Chosen; cursor: TimeCursor }) {
  const { prediction, run, engine } = chosen;
  const drawn = drawnBy(chosen, engine);
  const cameras = useMemo(() => new CameraLink(), []);
  const motions = useMemo(
    () =>
      drawn
        ? { bodies: frames(run.time, drawn.predicted_motion), ghost: frames(run.time, drawn.measured_motion) }
        : null,
    [drawn, run],
  );
  const bounds = useMemo(() => (motions ? framed(motions.ghost, [motions.bodies]) : null), [motions]);
  const name = prediction.engines[engine]?.engine ?? '';
  if (!drawn || !motions) return null;
  return (
    <>
      <div class="panes">
        <Pane
          title={`${name}, run ${run.run}`}
          scene={drawn.scene}
          motions={motions}
          bounds={bounds}
          cursor={cursor}
          cameras={cameras}
          ghost
          trails
        />
      </div>
      <p class="note">
        The ghost is where the data have the body. Shown is the stored frame nearest to the cursor
        {run.every > 1 ? `; of the data each ${run.every}th frame is kept` : ''}.
      </p>
    </>
  );
}

interface SelectProps {
  label: string;
  options: string[];
  value: number;
  choose: (value: number) => void;
}

function Select({ label, options, value, choose }: SelectProps) {
  return (
    <label>
      {label}{' '}
      <select value={value} onChange={(event) => choose(Number(event.currentTarget.value))}>
        {options.map((option, i) => (
          <option key={i} value={i}>
            {visible(option)}
          </option>
        ))}
      </select>
    </label>
  );
}

function Curves({ chosen }: { chosen: Chosen }) {
  const { prediction, run, engine } = chosen;
  const { names, unit } = prediction.drawn;
  const [scale, shown] = scaleOf(unit);
  const name = prediction.engines[engine]?.engine ?? '';
  const cursor = useMemo(() => new TimeCursor([0, run.time[run.time.length - 1] || 1], 0), [run]);
  const plots = useMemo(
    () =>
      names.flatMap((curve, k) => [
        {
          title: `${curve} of run ${run.run}, measured and predicted`,
          axis: `${curve} [${shown}]`,
          unit: shown,
          curves: valueCurves(chosen, k, scale),
        },
        {
          title: `${curve} of run ${run.run}, measured less predicted`,
          axis: `${curve}, residual [${shown}]`,
          unit: shown,
          curves: restCurves(chosen, k, scale),
        },
      ]),
    [prediction, run, engine],
  );
  const turn = useMemo(() => turnCurves(chosen), [prediction, run, engine]);
  const failure = prediction.engines[engine]?.drawn[chosen.at]?.failure;
  return (
    <>
      <Timeline cursor={cursor} frames={run.time} />
      {failure ? <p class="note">{visible(`${name} has no prediction of it: ${failure}`)}</p> : null}
      <Picture chosen={chosen} cursor={cursor} />
      <div class="total-plots">
        {plots.map((plot) => (
          <Plot key={plot.title} {...plot} cursor={cursor} />
        ))}
        <Plot
          title={`Turn of run ${run.run}, between measured and predicted orientation`}
          axis="turn, residual [deg]"
          unit="deg"
          curves={turn}
          cursor={cursor}
        />
      </div>
    </>
  );
}

export function RunView({ predictions }: { predictions: Prediction[] }) {
  const drawn = predictions.filter((p) => p.drawn.runs.length > 0 && p.engines.length > 0);
  const [values, setValues] = useState(0);
  const [run, setRun] = useState(0);
  const [engine, setEngine] = useState(0);
  const prediction = drawn[values] ?? drawn[0];
  const runs = prediction?.drawn.runs ?? [];
  const at = Math.min(run, runs.length - 1);
  const place = Math.min(engine, (prediction?.engines.length ?? 1) - 1);
  const chosen = useMemo(
    () => (prediction ? { prediction, run: runs[at]!, at, engine: place } : null),
    [prediction, at, place],
  );
  if (!prediction || !chosen) return null;
  const members = prediction.members;
  const level = (100 * (members - 1)) / (members + 1);
  return (
    <section aria-labelledby="runs-heading">
      <h4 id="runs-heading">Runs: measured, and predicted from the first frame</h4>
      <div class="side-tools on-screen">
        <Select label="values" options={drawn.map(valuesOf)} value={drawn.indexOf(prediction)} choose={setValues} />
        <Select label="run" options={runs.map((r) => r.run)} value={at} choose={setRun} />
        <Select label="band and picture of" options={prediction.engines.map((e) => e.engine)} value={place} choose={setEngine} />
      </div>
      <p class="note">
        Runs are the first by the hashes of their names, whatever came out.{' '}
        {members > 0
          ? `Shaded: the range of ${members} predictions of ${visible(prediction.engines[place]!.engine)}, a band of ${short(level, 3)} %, from a start${
              prediction.fitted ? ', fitted parameters' : ''
            } and surfaces that err as stated.`
          : 'There is no band: it was predicted with --members 0.'}
      </p>
      <Curves key={`${values} ${at} ${place}`} chosen={chosen} />
    </section>
  );
}
