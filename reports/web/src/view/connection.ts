// The server: its stream, read for as long as the page is open, and requests to it.
import type { Command, Session } from '../shared/live';
import { PacketReader } from './packets';
import type { Packet } from './packets';
import { hasSecret, secret } from './secret';

export interface Listener {
  session(session: Session): void;
  packet(packet: Packet): void;
  connected(is: boolean, why: string): void;
  /** The page has no secret, and nothing is asked. */
  locked(): void;
}

const pause = (seconds: number, signal: AbortSignal): Promise<void> =>
  new Promise((resolve) => {
    const timer = setTimeout(resolve, 1000 * seconds);
    signal.addEventListener('abort', () => (clearTimeout(timer), resolve()), { once: true });
  });

export class Connection {
  private readonly token = secret(window);
  private readonly stop = new AbortController();

  constructor(private readonly listener: Listener) {}

  /** Reads until `close`; after a failure again, a little later each time. */
  async run(): Promise<void> {
    // The address with the secret may be put into the tab of a page without it, or of an earlier server.
    const look = (): void => void (hasSecret(location.hash) && location.reload());
    addEventListener('hashchange', look, { signal: this.stop.signal });
    if (this.token === '') return this.listener.locked();
    let wait = 0.25; // [s]
    while (!this.stop.signal.aborted) {
      try {
        const session = (await (await this.ask('/api/session')).json()) as Session;
        const stream = await this.ask('/api/stream');
        this.listener.session(session);
        this.listener.connected(true, '');
        wait = 0.25;
        await this.read(stream);
        this.listener.connected(false, 'the server closed the stream');
      } catch (error) {
        if (this.stop.signal.aborted) return;
        this.listener.connected(false, error instanceof Error ? error.message : String(error));
      }
      await pause(wait, this.stop.signal);
      wait = Math.min(2 * wait, 4);
    }
  }

  private async read(response: Response): Promise<void> {
    const reader = response.body!.getReader();
    const packets = new PacketReader();
    try {
      for (;;) {
        const { done, value } = await reader.read();
        if (done) return;
        for (const packet of packets.push(value)) this.listener.packet(packet);
      }
    } finally {
      reader.cancel().catch(() => {}); // it has ended already where this fails
    }
  }

  private async ask(path: string, body?: BodyInit, type = 'application/json'): Promise<Response> {
    const headers: Record<string, string> = { 'X-Cylon-Token': this.token };
    if (body !== undefined) headers['Content-Type'] = type;
    const response = await fetch(path, {
      method: body === undefined ? 'GET' : 'POST',
      headers,
      body,
      signal: this.stop.signal,
      cache: 'no-store',
    });
    if (response.ok) return response;
    if (response.status === 403)
      throw new Error('another server answers here than the one of this page; open the address that `cylon view` printed last');
    const text = await response.text();
    let why = text.slice(0, 400);
    try {
      why = (JSON.parse(text) as { error?: string }).error ?? why;
    } catch {
      // Not JSON: the text itself says what there is to say.
    }
    throw new Error(why || `${path}: ${response.status}`);
  }

  async command(command: Command): Promise<void> {
    await this.ask('/api/command', JSON.stringify(command));
  }

  async frame(n: number, picture: Blob): Promise<void> {
    await this.ask(`/api/frame?n=${n}`, picture, 'image/png');
  }

  close(): void {
    this.stop.abort();
  }
}
