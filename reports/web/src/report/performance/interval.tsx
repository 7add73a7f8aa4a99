// A ratio with its interval as a bar, on a logarithmic axis around 1, with the threshold shaded.

const width = 180;
const height = 18;

interface IntervalProps {
  ratio: number;
  low: number;
  high: number;
  tau: number; // ratios within 1 + tau are the same
}

/** The axis reaches three thresholds, or as far as the interval does. */
export function Interval({ ratio, low, high, tau }: IntervalProps) {
  const edge = Math.log1p(tau);
  const reach = Math.max(
    3 * edge,
    ...[low, high, ratio].filter((x) => x > 0 && Number.isFinite(x)).map((x) => 1.1 * Math.abs(Math.log(x))),
  );
  const at = (x: number) => (width / 2) * (1 + Math.max(-1, Math.min(1, Math.log(x) / reach)));
  const [from, to] = [at(Math.exp(-edge)), at(Math.exp(edge))];
  return (
    <svg class="interval" width={width} height={height} aria-hidden="true">
      <rect class="same" x={from} width={to - from} y="0" height={height} />
      <line class="one" x1={width / 2} x2={width / 2} y1="0" y2={height} />
      <line class="range" x1={at(low)} x2={at(high)} y1={height / 2} y2={height / 2} />
      <circle cx={at(ratio)} cy={height / 2} r="4" />
    </svg>
  );
}
