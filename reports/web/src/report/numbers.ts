// Numbers as text, one way everywhere.

/** "+1.0": signed, one decimal; never "-0.0". */
export function digitsText(value: number): string {
  const rounded = Math.round(value * 10) / 10;
  return (rounded < 0 ? '-' : '+') + Math.abs(rounded).toFixed(1);
}

/** Significant digits as C's %.4g: 1.554e-15, 0.0025, 12. */
export function short(value: number | null | undefined, significant = 4): string {
  if (value === null || value === undefined) return 'not finite';
  if (!Number.isFinite(value)) return Number.isNaN(value) ? 'NaN' : value > 0 ? 'inf' : '-inf';
  if (value === 0) return '0';
  const [mantissa = '0', power = '0'] = value.toExponential(significant - 1).split('e');
  const exponent = Number(power);
  if (exponent < -4 || exponent >= significant) return `${trimmed(mantissa)}e${exponent}`;
  return trimmed(value.toFixed(Math.max(0, significant - 1 - exponent)));
}

function trimmed(text: string): string {
  return text.includes('.') ? text.replace(/\.?0+$/, '') : text;
}

export function withUnit(value: number | string | null | undefined, unit: string, significant = 4): string {
  const text = typeof value === 'string' ? value : short(value, significant);
  return unit ? `${text} ${unit}` : text;
}

/** "0.013 rad", and where an interval is known: "0.013 [0.008, 0.018] rad". */
export function withInterval(v: {
  measured: number | null;
  interval: [number, number] | null;
  unit: string;
}): string {
  if (!v.interval) return withUnit(v.measured, v.unit);
  return withUnit(`${short(v.measured)} [${short(v.interval[0])}, ${short(v.interval[1])}]`, v.unit);
}

const prefixes: [number, string][] = [
  [1, ''],
  [1e-3, 'm'],
  [1e-6, 'µ'],
  [1e-9, 'n'],
  [1e-12, 'p'],
];

/** Seconds with a prefix: 12.3 µs. */
export function duration(seconds: number | null | undefined): string {
  if (seconds === null || seconds === undefined || !Number.isFinite(seconds)) return 'not measured';
  const [scale, prefix] = prefixes.find(([s]) => Math.abs(seconds) >= s) ?? [1e-12, 'p'];
  return seconds === 0 ? '0 s' : `${short(seconds / scale, 3)} ${prefix}s`;
}

/** Seconds in a sentence of the program as durations: "about 4.9e-05 s" to "about 49 \u00b5s". */
export function withDurations(text: string): string {
  return text.replace(/(?<![\w.+-])(\d{1,20}(?:\.\d{1,20})?(?:e[-+]\d{1,3})?) s(?![\w/^])/g, (_, seconds: string) =>
    duration(Number(seconds)),
  );
}

export function count(n: number, one: string, many = `${one}s`): string {
  return `${n} ${n === 1 ? one : many}`;
}
