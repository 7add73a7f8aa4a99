// One lane: its picture, or why there is none.
import { useEffect, useRef } from 'preact/hooks';

import type { Lane, LaneState } from '../shared/live';
import { Sample } from '../shared/plot_marks';
import { laneName } from './viewer';
import type { Viewer } from './viewer';

interface Props {
  viewer: Viewer;
  index: number;
  lane: Lane;
  state: LaneState | undefined;
}

export function LaneView({ viewer, index, lane, state }: Props) {
  const host = useRef<HTMLDivElement>(null);
  const name = laneName(lane);
  useEffect(() => viewer.attach(index, host.current!, `Picture of ${name}`), [viewer, index, name]);
  const lanes = viewer.session?.lanes ?? [];
  const broken = state && state.status !== 'running';
  return (
    <figure class={broken ? 'lane broken' : 'lane'}>
      <figcaption>
        <Sample style={index} />
        <span class="name">{name}</span>
        {state?.cpu_per_second != null && (
          <span class="muted number" title="CPU seconds per simulated second">
            {state.cpu_per_second.toPrecision(2)} CPU s/s
          </span>
        )}
        {lanes.length > 1 && (
          <button
            type="button"
            aria-label={`remove ${name}`}
            onClick={() => viewer.send({ do: 'lanes', lanes: lanes.filter((_, i) => i !== index) })}
          >
            ×
          </button>
        )}
      </figcaption>
      <div class="picture" ref={host} />
      {broken && (
        <p class="reason" role="status">
          <strong>{state.status}</strong> {state.reason}
        </p>
      )}
    </figure>
  );
}
