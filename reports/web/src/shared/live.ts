// What the viewer's page and its server say to each other, on loopback alone.
//
//   GET  /            the page, which holds no secret.  Every other request must bring the token in the header
//                     X-Cylon-Token; the page has it from behind the '#' of the address that `cylon view` printed
//   GET  /api/session a Session
//   GET  /api/stream  messages without end: u32 little-endian length of the header, u32 bytes of the payload, the
//                     header (a Message as JSON), the payload
//   POST /api/command a Command as JSON, at most 64 KiB; 200 {} or 400 {"error": why}
//   POST /api/frame?n=N  a PNG of the view, at most 32 MiB, kept where --record says
import type { Scene, Vector } from './documents';

export interface EngineInfo {
  id: string; // "bullet"
  version: string;
  integrators: string[]; // the first is its default
}

export interface Lane {
  engine: string;
  integrator: string; // "": the engine's default
  dt_text: string; // "1/240"
}

export interface Session {
  scenario: string;
  title: string;
  story: string;
  duration: number; // [s]; the run goes on past it
  scene: Scene; // as it is now: parameters changed while it runs stand in it
  engines: EngineInfo[]; // all that could be added
  lanes: Lane[]; // those that run, side by side
  playing: boolean;
  speed: number; // simulated seconds per second
  recording: string; // folder or file that --record names; "": nothing is kept
}

export interface Contact {
  body: number;
  other: number; // index of a body, or -1: a plane
  point: Vector; // [m]
  normal: Vector; // towards `body`
  impulse: number | null; // over the last step [N s]; null: the engine does not tell
}

export interface LaneState {
  status: 'running' | 'failed' | 'unsupported';
  reason: string; // of a lane that does not run
  energy: number | null; // [J]
  momentum: Vector; // [kg m/s]
  angular_momentum: Vector; // about the origin [kg m^2/s]
  contacts: Contact[];
  cpu_per_second: number | null; // CPU seconds per simulated second, lately
}

/** A state: payload float32 [lane][body][13]: position, orientation (w, x, y, z), velocity, angular velocity. */
export interface StateMessage {
  type: 'state';
  t: number; // [s]
  playing: boolean;
  speed: number;
  lanes: LaneState[];
  pulls: { body: number; pin: Vector }[]; // springs by which somebody pulls, world
}

/** The session changed: lanes, scene, parameters. */
export interface SessionMessage {
  type: 'session';
  session: Session;
}

export type Message = StateMessage | SessionMessage;

export type Command =
  | { do: 'play' }
  | { do: 'pause' }
  | { do: 'step' } // one step of the first lane's dt, then pause
  | { do: 'reset' }
  | { do: 'speed'; value: number } // 0.01 … 100
  | { do: 'kick'; body: number; impulse: Vector; angular_impulse?: Vector } // [N s] at the centre of mass, [N m s] beside it, world axes, in every lane
  | { do: 'pull'; body: number; anchor: Vector; pin: Vector; stiffness: number } // a spring from a point of the body (body axes) to a point of the world; again: moves the pin
  | { do: 'release' }
  | { do: 'lanes'; lanes: Lane[] } // engines, integrators, steps; the state is kept
  | { do: 'set'; key: string; value: number | Vector }; // "gravity", "spring.0.stiffness", "material.0.restitution", "body.ball.mass", …
