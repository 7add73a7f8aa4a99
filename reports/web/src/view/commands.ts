// Commands on their way to the server: one request at a time, without what a later one makes pointless.
import type { Command } from '../shared/live';

/** Commands of which only the last counts have the same topic. */
export function topic(command: Command): string | null {
  switch (command.do) {
    case 'pull':
    case 'speed':
      return command.do;
    case 'set':
      return `set ${command.key}`;
    default:
      return null;
  }
}

export class Commands {
  private readonly waiting: Command[] = [];
  private busy = false;

  constructor(
    private readonly post: (command: Command) => Promise<void>,
    private readonly failed: (why: string) => void,
  ) {}

  put(command: Command): void {
    const last = this.waiting[this.waiting.length - 1];
    const name = topic(command);
    if (last && name !== null && topic(last) === name) this.waiting.pop();
    this.waiting.push(command);
  }

  /** Sends the next one, unless an answer is awaited; once per animation frame. */
  flush(): void {
    if (this.busy) return;
    const next = this.waiting.shift();
    if (!next) return;
    this.busy = true;
    this.post(next)
      .catch((error: unknown) => this.failed(error instanceof Error ? error.message : String(error)))
      .finally(() => (this.busy = false));
  }

  clear(): void {
    this.waiting.length = 0;
  }
}
