// What `cylon predict --json` and `cylon fit --json` say of measured motions (only what the report reads of it).
import type { Scene } from './documents';

/** With the interval of 95 %; null: not known, of a time later than the data. */
export interface Estimate {
  value: number | null;
  low: number | null;
  high: number | null;
  runs: number;
}

export type Answer = 'yes' | 'no' | 'undecided';

interface Summary {
  runs: number;
  failed: number;
  first_failure: string;
  covered: Estimate; // share inside the band
  band: Answer; // whether that is 90 to 98 %
}

/** Of a free body. */
export interface RestSummary extends Summary {
  distance: Estimate; // [m]
  angle: Estimate; // [rad]
  same_side: Estimate;
  impact: Estimate; // [s]
  place?: Estimate; // of the first touch [m]; documents of before lack it
  loss: Estimate;
}

/** Of a chain of hinges. */
export interface HorizonSummary extends Summary {
  to_the_end: number;
  held: Estimate; // [s]
  expected: Estimate; // [s]
  exponent: Estimate; // [1/s]
}

/** Frame after frame, body after body: x, y, z and w, x, y, z. */
export interface MotionLists {
  position: number[];
  orientation: number[];
}

/** What an engine predicts of one run, by curve and frame. */
export interface DrawnPrediction {
  run: string;
  failure: string; // "": the rest is there
  predicted: number[][];
  low: number[][]; // empty: no band
  high: number[][];
  turn: number[]; // between predicted and measured orientation [rad]; empty: of a chain
  scene: Scene;
  predicted_motion: MotionLists;
  measured_motion: MotionLists;
}

export interface DrawnRun {
  run: string;
  every: number; // frames of the data for each of these
  time: number[]; // [s]
  measured: number[][]; // by curve and frame
  off_the_fall?: number[]; // heights less the nearest parabola of the scene's gravity [m]
}

export interface Lengths {
  flight: Estimate; // measured over true
  rest: Estimate;
  height: Estimate; // of the centre at rest [m]
  tilt: number | null; // root mean square [rad]
  gravity: number; // of the scene [m/s^2]
  each: {
    run: string;
    flight: number | null;
    roughness: number | null;
    height: number | null;
    half: number | null;
    tilt: number | null;
    side: number;
  }[];
}

/** Steps of places from frame to frame over velocities: 1 where columns, units, axes and rate are right. */
export type Slope = Estimate & { goes_together: Answer };

interface OfData {
  title: string;
  source: string;
  licence: string;
  instrument: string;
  known: string[]; // to be wrong with the data
  experiment: string; // hash of data, description and scene
}

export interface Prediction extends OfData {
  format: 'cylon-prediction/1';
  model: string; // hash of the scene
  coordinates: 'free' | 'chain';
  step: number; // [s]
  measured_runs: number;
  set: string[]; // NAME=VALUE
  fitted: boolean; // with parameters of a fit
  members: number; // of the band
  kinematics?: { velocity: Slope; spin: Slope };
  drawn: { names: string[]; unit: string; runs: DrawnRun[] };
  engines: ((RestSummary | HorizonSummary) & { engine: string; drawn: DrawnPrediction[] })[];
  lengths?: Lengths;
  nearer?: { one: string; other: string; runs_of_one: number; runs_of_other: number; p: number; nearer: string }[];
}

export interface FitDocument extends OfData {
  format: 'cylon-fit/1';
  runs: number;
  measured_runs: number;
  horizon: number; // [s]
  fits: {
    engine: string;
    failure: string;
    fitted_on: string[];
    judged_on: string[];
    parameters: {
      name: string;
      value: number;
      low: number | null;
      high: number | null;
      low_between_runs: number | null;
      high_between_runs: number | null;
      at_bound: boolean;
    }[];
    cannot_be_told_apart: { weights: number[]; error: number | null }[];
    misfit: number;
    numbers: number;
    misfit_p: number;
    rounds: number;
    settled: boolean;
  }[];
  judged: { engine: string; before?: RestSummary | HorizonSummary; after?: RestSummary | HorizonSummary }[];
  likelier: { one: string; other: string; runs_of_one: number; runs_of_other: number; p: number; likelier: string }[];
}
