// What a report holds: the documents that Cylon's commands write, as they are, and traces of the runs.
// The program packs them; nothing here is computed twice.
import type { FitDocument, Prediction } from './measured_documents';

export type Vector = [number, number, number];
export type Quaternion = [number, number, number, number]; // (w, x, y, z), active, body to world

export type Status =
  | 'pass'
  | 'low-quality'
  | 'fail'
  | 'undecided'
  | 'unsupported'
  | 'crash'
  | 'timeout'
  | 'non-finite'
  | 'protocol';

/** How a run that is measured and not judged came to its end. */
export type Ending = 'ran' | Exclude<Status, 'pass'>;

/** What an engine says of how a part of the scene went; one matter each. */
export interface Diagnostic {
  kind: string;
  bodies: string[]; // the first of the part's
  body_count: number;
  method: string;
  order: number; // 0: none
  since: number | null; // [s]
  until: number | null; // [s]
  count: number;
  limit: number | null; // what was asked for, or the cap that was hit
  limit_unit: string;
  reached: number | null; // the worst that came of it
  unit: string;
  text: string;
}

/** A row of `cylon run --json`.  A null number was not finite. */
export interface Verdict {
  scenario: string;
  scenario_hash: string;
  engine: string;
  version: string;
  precision: string;
  path: string;
  gyroscopic: string;
  settings: Record<string, string>;
  unforceable: string[];
  integrator: string;
  dt: number; // [s]
  dt_text: string;
  sampling: string;
  claim: string;
  observable: string;
  evidence: string; // verified, validated
  measured: number | null;
  interval: [number, number] | null; // 95 %, where the truth was measured
  first_bad_step: number | null;
  allowed: number | null;
  unit: string;
  truth_error: number | null;
  status: Status;
  expected: Status;
  expected_size: number | null;
  expected_within: number; // a factor
  as_expected: boolean;
  expected_reason: string;
  reason: string; // the tolerance's
  detail: string;
  diagnostics: Diagnostic[];
  stderr: string; // its end
  version_listed: boolean;
  closed_form: boolean; // the engine takes no steps
  substeps?: number; // parts of each step, each with gravity; absent in older reports: 1
  tolerance_scale: number;
  spread: number | null;
  cpu_seconds: number;
  cpu_verified?: boolean; // whether the CPU time of the engine's process confirms it; absent in older reports
  body_steps: number;
  reproduce: string;
}

export interface Provenance {
  cylon: string;
  revision: string;
  compiler: string;
  flags: string;
  machine: string;
  os: string;
  date: string;
  command_line: string;
  tolerance_scale: number;
}

export interface Results {
  schema: 1;
  provenance: Provenance;
  verdicts: Verdict[];
}

/** Geometry in body axes, about the centre of mass, axis of revolution along y [m]. */
export type Shape =
  | { type: 'sphere'; radius: number }
  | { type: 'box'; half_extents: Vector }
  | { type: 'capsule' | 'cylinder' | 'cone'; radius: number; length: number }
  | { type: 'rod'; length: number }
  | { type: 'disc'; radius: number }
  | { type: 'hull'; vertices: Vector[] }
  | { type: 'mesh'; vertices: Vector[]; faces: [number, number, number][] }
  | { type: 'compound'; parts: { shape: Shape | null; mass: number; position: Vector; orientation: Quaternion }[] };

/** A scene as workers get it (docs/protocol.md): every default written out, bodies referred to by name. */
export interface Scene {
  gravity: Vector;
  body: {
    name: string;
    mass: number; // [kg]
    inertia: number[]; // 9, body axes [kg m^2]
    position: Vector;
    orientation: Quaternion;
    velocity: Vector;
    angular_velocity: Vector;
    shape?: Shape; // absent: a point, or a bare rigid body
    locked: boolean;
    gravity?: Vector; // absent: that of the scene [m/s^2]
    collide: boolean;
    collision_groups?: string[]; // absent: in "default"
    collision_mask?: string[]; // absent: all groups
    color: string; // "#rrggbb" or ""
  }[];
  joint: { type: 'ball' | 'hinge' | 'distance' | 'fixed'; body: string; to?: string; point?: Vector; axis?: Vector; length?: number }[];
  spring: { body: string; anchor: Vector; to?: string; to_anchor?: Vector; pin?: Vector; stiffness: number; rest_length: number; damping: number }[];
  plane: { name: string; normal: Vector; offset: number; collision_groups?: string[]; collision_mask?: string[] }[];
  water: { level: number; wave: number; speed: number; buoyancy: number; drag: number; mode: 'volume' | 'step' }[];
  [other: string]: unknown;
}

/** What a scenario is about, for people, and its scene for pictures. */
export interface ScenarioView {
  name: string;
  hash: string;
  title: string;
  story: string;
  tags: string[];
  duration: number; // [s]
  step: number; // nominal [s]
  bodies: number;
  claims: {
    label: string;
    observable: string;
    follows: string; // the truth's name; "": it must keep its initial value
    source: string; // where the truth comes from
    truth_error: number | null;
    unit: string;
    until: number | null; // horizon [s]; null: the whole duration
    at_least?: number | null; // least change that is claimed, in the unit; null or absent: none is
    absolute: number; // in the unit
    relative: number; // of the largest |truth|
    tolerance_reason: string;
  }[];
  scene: Scene;
}

/** Which block holds the trace of a cell. */
export interface TraceEntry {
  scenario: string;
  engine: string;
  integrator: string;
  dt_text: string;
  block: number;
}

/** Documents of other commands, where the report was given them: trade, compare, track history, hunt, predict and fit,
 * --json. */
export interface Index {
  kind: 'report';
  title: string;
  results: Results;
  scenarios: ScenarioView[];
  traces: TraceEntry[];
  omitted_traces: string; // why some runs have none, one sentence; "": all have
  baseline: Results | null; // an earlier run to say what changed since
  trades: Trade[];
  comparisons: Comparisons[];
  histories: History[];
  hunts: Hunt[];
  predictions: Prediction[];
  fits: FitDocument[];
}

// ---- Traces: a block of their own each ---------------------------------------------------------------------

/** float32 at `offset` bytes after the header, `count` of them. */
export interface Floats {
  offset: number;
  count: number;
}

/** Frames x channels numbers as whole numbers k: 0 is NaN, else min + step (k - 1); per channel the differences of k
 * from frame to frame (the first from 0), zigzag, in LEB128 bytes, channel after channel. */
export interface Steps {
  offset: number;
  bytes: number;
  frames: number;
  min: number[]; // per channel
  step: number[];
}

export interface Motion {
  time: Floats; // [s], one per frame
  position: Steps; // channels 3 b, 3 b + 1, 3 b + 2 of body b [m]
  orientation: Steps; // channels 4 b … 4 b + 3: w, x, y, z
}

export interface ErrorCurve {
  claim: string;
  unit: string;
  allowed: number | null;
  time: Floats;
  value: Floats; // deviation; of several samples that share a place the largest
  first_violation: { time: number; step: number; value: number | null } | null;
}

export interface TotalCurve {
  name: 'energy' | 'kinetic energy' | 'momentum' | 'angular momentum';
  unit: string;
  component: '' | 'x' | 'y' | 'z';
  time: Floats;
  value: Floats;
}

export interface Trace {
  bodies: number;
  motion: Motion;
  ghost: (Motion & { follows: string; source: string }) | null; // of the truth
  errors: ErrorCurve[];
  totals: TotalCurve[];
  events: { time: number; kind: string; what: string }[];
  remarks: string[];
}

// ---- Documents of other commands (only what the report reads of them) ---------------------------------------

export interface Trade {
  format: 'cylon-trade/1';
  provenance: Provenance;
  tables: {
    scenario: string;
    scenario_hash: string;
    duration: number;
    bodies: number;
    truth: string;
    by: string | null;
    measures: { name: string; unit: string; scale: number | null; against: string; resolution: number }[];
    series: {
      engine: string;
      integrator: string;
      version: string;
      precision: string;
      path: string;
      gyroscopic: string;
      adaptive: boolean;
      closed_form?: boolean; // the engine takes no steps
      substeps?: number; // parts of each step; absent: 1
      declared_order: number;
      observed_order: number | null;
      floor: number | null;
      floor_is_rounding: boolean;
      reason: string;
      points: { steps: number; dt: number; dt_text: string; tolerance: number | null; status: Ending; reason: string; errors: Record<string, number | null> }[];
    }[];
    /** One per engine: which step it needs (harness/results/step_matrix.h). */
    cells?: {
      series: number;
      refusal: string; // why the engine does not run the scene; "": it does
      avoidable: string; // engines that can, "bullet, ode"
      reach: { error: number; point: number | null; coarsest_tried: boolean; why: string }[];
    }[];
  }[];
  /** Costs, apart from what repeats bit for bit. */
  times: {
    scenario: string;
    engine: string;
    integrator: string;
    dt_text: string;
    tolerance: number | null;
    step_seconds: number | null;
    cpu_seconds_per_second: number | null;
    seconds_per_body_step: number | null;
    on_front: boolean;
    dominated_by: string;
  }[];
}

export interface Comparisons {
  schema: 1;
  baseline: string;
  candidate: string;
  tau: number;
  alpha: number;
  gate: boolean;
  reliable: boolean;
  notes: string[];
  cells: {
    scenario: string;
    engine: string;
    dt_text: string;
    finding: string;
    reason: string;
    time: null | { finding: string; ratio: number | null; low: number | null; high: number | null; confidence: number | null; pairs: number; p: number | null; adjusted_p: number | null; baseline_seconds: number | null; candidate_seconds: number | null; what: string };
    untimed: string;
    metrics: { name: string; finding: string; sentence: string }[];
    reproduce: string;
  }[];
  [other: string]: unknown;
}

export interface History {
  schema: 1;
  series: {
    series: string;
    cell: string;
    scenario: string;
    engine: string;
    dt: number;
    metric: string;
    kind: string;
    unit: string;
    scale: 'ratio' | 'absolute' | 'value' | 'text';
    points: { run: number; revision: string; date: string; version: string; value?: number | null; text?: string }[];
    versions?: string[]; // of the engine
    changes: { id: string; index: number; run: number; revision: string; outcome: string; state: string; note: string; found: string; sentence: string; ratio?: number; p?: number }[];
    [other: string]: unknown;
  }[];
}

export interface Hunt {
  format: 'cylon-hunt/1';
  asked?: { engine: string; scenes: number; refused: number; faulty: number }[]; // absent in older documents
  cards: {
    name: string;
    engine: string;
    version: string;
    signature: string; // "energy: 1 body, gravity, hinge"
    oracle: string;
    kind: string; // at which steps
    says: string; // what must hold
    reason: string; // why it is no truncation
    detail: string; // what an engine that did not end said; "": errors are measured
    by_time: boolean;
    measured: { dt: number; error: number | null }[];
    allowed: number;
    unit: string;
    hits: number;
    found_in: string;
    opinions: { engine: string; says: string }[];
    scenario: string; // TOML
    command: string;
    no_program: string;
    program?: { file: string; text: string; command: string; prints: number; unit: string };
  }[];
}
