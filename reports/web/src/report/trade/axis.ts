// A logarithmic axis of whole decades.

export interface LogAxis {
  place: (value: number) => number; // [px]
  ticks: { value: number; at: number; label: string }[];
}

const pixelsPerTick = 40;

/** From `start` to `end` [px]; `values` are positive. */
export function logAxis(values: number[], start: number, end: number): LogAxis {
  let [least, greatest] = [Infinity, -Infinity];
  for (const value of values) {
    least = Math.min(least, value);
    greatest = Math.max(greatest, value);
  }
  if (!(least > 0 && Number.isFinite(greatest))) [least, greatest] = [0.1, 1];
  const low = Math.floor(Math.log10(least) + 1e-9);
  const high = Math.max(low + 1, Math.ceil(Math.log10(greatest) - 1e-9));
  const place = (value: number) => start + ((Math.log10(value) - low) / (high - low)) * (end - start);
  const every = Math.max(1, Math.ceil(((high - low) * pixelsPerTick) / Math.abs(end - start)));
  const ticks: LogAxis['ticks'] = [];
  for (let power = low; power <= high; power += every)
    ticks.push({ value: 10 ** power, at: place(10 ** power), label: `1e${power}` });
  return { place, ticks };
}
