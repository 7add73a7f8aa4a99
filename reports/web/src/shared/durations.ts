// Durations and steps as a person reads them, one way everywhere.

const prefixes: [number, string][] = [
  [1, ''],
  [1e-3, 'm'],
  [1e-6, 'µ'],
  [1e-9, 'n'],
  [1e-12, 'p'],
];

/** Three significant digits, and no power of ten. */
function rounded(value: number): number {
  return Math.abs(value) < 1000 ? Number(value.toPrecision(3)) : Math.round(value);
}

/** Seconds with the largest prefix of which they are a tenth or more: 12.3 µs, 0.125 ms; as harness/results/duration.h. */
export function duration(seconds: number | null | undefined): string {
  if (seconds === null || seconds === undefined || !Number.isFinite(seconds)) return 'not measured';
  const [scale, prefix] = prefixes.find(([s]) => Math.abs(seconds) >= 0.1 * s) ?? [1e-12, 'p'];
  return seconds === 0 ? '0 s' : `${rounded(seconds / scale)} ${prefix}s`;
}

/** A step that was asked for, exactly: as a duration where three digits say it, else as it was asked for: "1/60 s", "0.5 ms".
 * Another text is left as it is. */
export function stepInWords(asked: string): string {
  const number = '(\\d+(?:\\.\\d*)?|\\.\\d+)(?:e[-+]?\\d+)?';
  if (!new RegExp(`^${number}(?:/${number})?$`, 'i').test(asked)) return asked;
  const [top = 0, bottom = 1] = asked.split('/').map(Number);
  const seconds = top / bottom;
  if (!Number.isFinite(seconds)) return asked;
  const shown = Number(seconds.toPrecision(3));
  return Math.abs(shown - seconds) <= 1e-12 * seconds ? duration(seconds) : `${asked} s`;
}
