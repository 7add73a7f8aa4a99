// Sweeps of `cylon trade` and `cylon matrix`: what tells one from another.
import type { Trade } from '../shared/documents';

/** A table in the address and in the choice of scenarios: "projectile", of several files "projectile (2)". */
export function sweepKey(trades: Trade[], file: number, { scenario }: { scenario: string }): string {
  return trades.length > 1 ? `${scenario} (${file + 1})` : scenario;
}

/** What made the sweep, "cylon matrix"; "" where its command line does not say. */
export function commandOf({ provenance }: Trade): string {
  const command = / (matrix|trade)(?= |$)/.exec(provenance?.command_line ?? '')?.[1];
  return command ? `cylon ${command}` : '';
}
