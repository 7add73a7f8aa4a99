// Rolling plots of the totals, a line per lane.
import 'uplot/dist/uPlot.min.css';

import { useEffect, useRef, useState } from 'preact/hooks';
import uPlot from 'uplot';

import type { Lane } from '../shared/live';
import { lookOf } from '../shared/plot_marks';
import { color, onTheme } from '../shared/theme';
import { components, digits, quantities, roomy, units } from './history';
import type { Component, Quantity } from './history';
import { laneName } from './viewer';
import type { Viewer } from './viewer';

const height = 170; // [px]

function options(width: number, lanes: Lane[], unit: string): uPlot.Options {
  const axis = {
    stroke: () => color('--ink'),
    grid: { stroke: () => color('--line'), width: 1 },
    ticks: { stroke: () => color('--line'), width: 1 },
    font: '12px system-ui, sans-serif',
    labelFont: '12px system-ui, sans-serif',
    labelSize: 16,
    labelGap: 0,
  };
  return {
    width,
    height,
    legend: { show: false },
    cursor: { show: false },
    scales: { x: { time: false }, y: { range: (_, least, most) => roomy(least, most) } },
    axes: [
      { ...axis, label: 'time [s]', size: 30 },
      {
        ...axis,
        label: `[${unit}]`,
        size: (_, values) => 30 + 7 * Math.max(3, ...(values ?? []).map((text) => text.length)),
        values: (_, splits) => splits.map((v) => String(Number(v.toPrecision(7)))),
      },
    ],
    series: [
      {},
      ...lanes.map((_, i) => ({
        stroke: () => color(lookOf(i).color),
        dash: lookOf(i).dash,
        width: 2,
        points: { show: false },
      })),
    ],
  };
}

interface Props {
  viewer: Viewer;
  lanes: Lane[];
  quantity: Quantity;
}

function RollingPlot({ viewer, lanes, quantity }: Props) {
  const host = useRef<HTMLDivElement>(null);
  const [component, setComponent] = useState<Component>('size');
  const names = lanes.map(laneName).join('\n');
  useEffect(() => {
    const node = host.current!;
    const plot = new uPlot(
      options(Math.max(node.clientWidth, 160), lanes, units[quantity]),
      [[], ...lanes.map(() => [])],
      node,
    );
    let drawn: unknown = null;
    const update = (): void => {
      const { samples } = viewer.history;
      const newest = samples[samples.length - 1];
      if (newest === drawn && samples.length > 0) return;
      drawn = newest;
      plot.setData([
        viewer.history.times(),
        ...lanes.map((_, i) => viewer.history.series(i, quantity, component)),
      ]);
    };
    update();
    const stop = [viewer.subscribe(update), onTheme(() => plot.redraw())];
    const resized = new ResizeObserver(() =>
      plot.setSize({ width: Math.max(node.clientWidth, 160), height }),
    );
    resized.observe(node);
    return () => {
      for (const end of stop) end();
      resized.disconnect();
      plot.destroy();
    };
  }, [viewer, names, quantity, component]);
  const sample = viewer.history.samples[viewer.history.samples.length - 1];
  const latest = (lane: number): string =>
    sample?.lanes[lane] ? digits(viewer.history.series(lane, quantity, component).at(-1)) : '';
  const series = lanes.map((lane, i) => `${laneName(lane)} ${latest(i)}`);
  return (
    <figure class="rolling">
      <figcaption>
        {quantity}
        {quantity !== 'energy' && (
          <select
            aria-label={`component of ${quantity}`}
            value={component}
            onChange={(event) => setComponent(event.currentTarget.value as Component)}
          >
            {components.map((name) => (
              <option key={name} value={name}>
                {name}
              </option>
            ))}
          </select>
        )}
      </figcaption>
      <div ref={host} role="img" aria-label={`${quantity} over time: ${series.join(', ')}`} />
    </figure>
  );
}

export function Plots({ viewer, lanes }: { viewer: Viewer; lanes: Lane[] }) {
  return (
    <div class="plots">
      {quantities.map((quantity) => (
        <RollingPlot key={quantity} viewer={viewer} lanes={lanes} quantity={quantity} />
      ))}
    </div>
  );
}
