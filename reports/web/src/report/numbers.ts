// Numbers as text, one way everywhere.

/** "+1.0": signed, one decimal; never "-0.0". */
export function digitsText(value: number): string {
  const rounded = Math.round(value * 10) / 10;
  return (rounded < 0 ? '-' : '+') + Math.abs(rounded).toFixed(1);
}

/** The digits of a verdict: "+1.0", "exact" for an error of nothing. */
export function wonText(digits: number): string {
  return digits >= 99 ? 'exact' : digitsText(digits);
}

/** The same in a sentence: "+1.0 digits", "exact". */
export function wonInWords(digits: number): string {
  return digits >= 99 ? 'exact' : `${digitsText(digits)} digits`;
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

export function count(n: number, one: string, many = `${one}s`): string {
  return `${n} ${n === 1 ? one : many}`;
}
