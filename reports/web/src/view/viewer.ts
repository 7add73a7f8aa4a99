// What the page knows and does: session, newest state, pictures, commands.  The elements on the page ask it.
import type { Vector } from '../shared/documents';
import { stepInWords } from '../shared/durations';
import type { Command, Lane, Session, StateMessage } from '../shared/live';
import type { CameraState } from '../shared/scene3d/index';
import { Commands } from './commands';
import { Connection } from './connection';
import { Film, wantsPictures } from './film';
import { FrameRate } from './frame_rate';
import { History } from './history';
import { kick, pullStiffness, spin } from './kick';
import { LanePicture } from './lane_picture';
import type { Hands, Shown } from './lane_picture';
import type { Packet } from './packets';
import { seen } from './parameters';
import { ArrowScale } from './poses';
import { Reach } from './reach';

const few = 200; // bodies whose contacts are marked without being asked for
const refresh = 125; // [ms] between read-outs: faster is not read

export const laneName = (lane: Lane): string =>
  [lane.engine, lane.integrator, `step ${stepInWords(lane.dt_text)}`].filter((part) => part).join(' · ');

export class Viewer {
  session: Session | null = null;
  state: StateMessage | null = null;
  connected = false;
  why = 'connecting'; // why not
  locked = false; // for good: the page has no secret
  notice = ''; // the last refusal
  shown: Shown = {
    velocity: false,
    momentum: false,
    'angular momentum': false,
    trails: false,
    contacts: true,
    links: true,
  };
  kickSpeed = 1; // [m/s]
  kickSpin = 0; // [rad/s]
  pullFrequency = 1; // [Hz]
  readonly history = new History();
  readonly scale = new ArrowScale();
  readonly rate = new FrameRate();
  private readonly pictures = new Map<number, LanePicture>();
  private readonly listeners = new Set<() => void>();
  private readonly anchors = new Map<number, Vector>();
  private readonly connection = new Connection({
    session: (session) => this.take(session),
    packet: (packet) => this.packet(packet),
    connected: (is, why) => this.setConnected(is, why),
    locked: () => {
      this.locked = true;
      this.changed();
    },
  });
  private readonly commands = new Commands(
    (command) => this.connection.command(command),
    (why) => this.tell(why),
  );
  private readonly film = new Film(
    (n, picture) => this.connection.frame(n, picture),
    (why) => this.tell(why),
    () => {
      this.send({ do: 'speed', value: Math.max(0.01, this.speed / 1.5) });
      this.tell(
        'Pictures were missed: the motion was slowed down for the recording. Reset records from the start.',
      );
    },
  );
  private fresh = false; // a state that is not drawn yet
  private payload: Float32Array | null = null; // of `state`
  private reach: Reach | null = null;
  private looks = '';
  private camera: CameraState | null = null;
  private grabbed: { body: number; anchor: Vector } | null = null;
  private told = 0;

  start(): void {
    void this.connection.run();
    const loop = (now: number): void => {
      this.frame(now);
      requestAnimationFrame(loop);
    };
    requestAnimationFrame(loop);
  }

  subscribe(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  changed(): void {
    for (const listener of this.listeners) listener();
  }

  tell(notice: string): void {
    this.notice = notice;
    this.changed();
  }

  private setConnected(is: boolean, why: string): void {
    this.connected = is;
    this.why = why;
    if (!is) this.commands.clear();
    else this.notice = '';
    this.changed();
  }

  private take(session: Session): void {
    const before = this.session;
    this.session = session;
    // Marks of a thousand contacts hide more than they show, and take half of the frames: C brings them.
    if (!before) this.shown = { ...this.shown, contacts: session.scene.body.length <= few };
    document.title = `${session.title} — Cylon`;
    const looks = seen(session.scene);
    const other = looks !== this.looks;
    this.looks = looks;
    if (other) this.reach = new Reach(session.scene, session.duration);
    for (const picture of this.pictures.values()) picture.setScene(session.scene, other && before !== null);
    if (before && before.lanes.map(laneName).join('\n') !== session.lanes.map(laneName).join('\n'))
      this.history.clear();
    this.changed();
  }

  private packet(packet: Packet): void {
    const { message } = packet;
    if (message.type === 'session') {
      this.take(message.session);
      this.payload = null; // its lanes are others
      return;
    }
    if (this.state && message.t < this.state.t) this.restarted();
    this.state = message;
    this.payload = packet.payload;
    for (const [lane, picture] of this.pictures)
      if (message.lanes[lane]?.status === 'running' && picture.read(message.t, packet.payload, lane))
        this.hold(picture.position);
    for (const lane of message.lanes) this.scale.see(lane.contacts);
    this.history.add(message.t, message.lanes);
    this.fresh = true;
  }

  /** Keeps bodies in sight of all cameras that nobody has taken. */
  private hold(position: Float32Array): void {
    if (!this.reach?.include(position)) return;
    for (const picture of this.pictures.values()) picture.picture.frameOn(this.reach.bounds);
  }

  private restarted(): void {
    this.history.clear();
    this.scale.clear();
    this.film.reset();
  }

  private frame(now: number): void {
    this.rate.tick(now);
    this.commands.flush();
    const { fresh } = this;
    this.fresh = false;
    if (fresh) this.draw(); // older states that were not drawn are dropped
    for (const picture of this.pictures.values()) picture.picture.render();
    const { session, state } = this;
    if (fresh && session && state?.playing && wantsPictures(session)) {
      const order = [...this.pictures.keys()].sort((a, b) => a - b);
      this.film.take(
        state.t,
        now,
        order.map((lane) => this.pictures.get(lane)!.picture),
        order.map((lane) => (session.lanes[lane] ? laneName(session.lanes[lane]) : '')),
      );
    }
    if (now - this.told > refresh) {
      this.told = now;
      this.changed();
    }
  }

  /** Gives the newest state to the pictures. */
  private draw(): void {
    const { state } = this;
    if (!state) return;
    for (const [lane, picture] of this.pictures) {
      const of = state.lanes[lane];
      if (of) picture.update(state, of, this.shown, this.scale, this.anchors);
    }
  }

  show(change: Partial<Shown>): void {
    this.shown = { ...this.shown, ...change };
    this.draw();
    this.changed();
  }

  // ---- Pictures of lanes, made and removed by the page's elements ----

  attach(lane: number, host: HTMLElement, label: string): () => void {
    const picture = new LanePicture(host, this.session!.scene, label, this.hands);
    if (this.camera) picture.picture.camera = this.camera;
    if (this.reach) picture.picture.frameOn(this.reach.bounds);
    this.pictures.set(lane, picture);
    if (this.state?.lanes[lane]?.status === 'running' && this.payload)
      picture.read(this.state.t, this.payload, lane);
    this.fresh = true;
    return () => {
      if (this.pictures.get(lane) === picture) this.pictures.delete(lane);
      picture.dispose();
    };
  }

  private readonly hands: Hands = {
    camera: (state, from) => {
      this.camera = state;
      for (const picture of this.pictures.values()) if (picture !== from) picture.picture.camera = state;
    },
    frameAll: () => {
      this.camera = null;
      for (const picture of this.pictures.values()) picture.picture.frameAll();
    },
    grab: ({ body, anchor, point }) => {
      this.grabbed = { body, anchor };
      this.anchors.set(body, anchor);
      this.pull(point);
    },
    pull: (point) => this.pull(point),
    release: () => {
      this.grabbed = null;
      this.send({ do: 'release' });
    },
  };

  private pull(pin: Vector): void {
    if (!this.grabbed || !this.session) return;
    const mass = this.session.scene.body[this.grabbed.body]?.mass ?? 1;
    this.send({ do: 'pull', ...this.grabbed, pin, stiffness: pullStiffness(mass, this.pullFrequency) });
  }

  // ---- Commands ----

  send(command: Command): void {
    this.notice = '';
    this.commands.put(command);
  }

  kick(body: number, reverse: boolean): void {
    const sign = reverse ? -1 : 1;
    const impulse = this.session && kick(this.session.scene, body, sign * this.kickSpeed);
    const angular = this.session && spin(this.session.scene, body, sign * this.kickSpin);
    if (impulse) this.send({ do: 'kick', body, impulse, ...(angular && { angular_impulse: angular }) });
    else if (this.session && body < this.session.scene.body.length)
      this.tell(`${this.session.scene.body[body]!.name} cannot be kicked: it is locked`);
  }

  get playing(): boolean {
    return this.state?.playing ?? this.session?.playing ?? false;
  }

  toggle(): void {
    this.send({ do: this.playing ? 'pause' : 'play' });
  }

  get speed(): number {
    return this.state?.speed ?? this.session?.speed ?? 1;
  }
}
