// Traces of the report, unpacked when a cell is opened.  The last few stay unpacked, as engines are compared
// in turns.
import { useEffect, useState } from 'preact/hooks';

import { TraceBlock } from '../../shared/block';
import type { TraceEntry } from '../../shared/documents';
import type { CellName } from '../fold';

const kept = new Map<number, Promise<TraceBlock>>();
const most = 4;

function load(block: number): Promise<TraceBlock> {
  const known = kept.get(block);
  if (known) return known;
  const loading = TraceBlock.of(block);
  kept.set(block, loading);
  const [oldest] = kept.keys();
  if (kept.size > most && oldest !== undefined) kept.delete(oldest);
  return loading;
}

export type Loaded =
  | { state: 'absent' }
  | { state: 'loading' }
  | { state: 'broken'; why: string }
  | { state: 'ready'; block: TraceBlock };

export function useTrace(block: number | null): Loaded {
  const [loaded, set] = useState<{ of: number | null; value: Loaded }>({
    of: null,
    value: { state: 'absent' },
  });
  useEffect(() => {
    if (block === null) return;
    let wanted = true;
    const tell = (value: Loaded) => wanted && set({ of: block, value });
    load(block).then(
      (trace) => tell({ state: 'ready', block: trace }),
      (error: unknown) => tell({ state: 'broken', why: String(error) }),
    );
    return () => void (wanted = false);
  }, [block]);
  if (block === null) return { state: 'absent' };
  return loaded.of === block ? loaded.value : { state: 'loading' };
}

export function entryOf(traces: TraceEntry[], name: CellName): TraceEntry | null {
  const same = (t: TraceEntry) =>
    t.scenario === name.scenario &&
    t.engine === name.engine &&
    t.integrator === name.integrator &&
    t.dt_text === name.dt;
  return traces.find(same) ?? null;
}
