// What is slower or less accurate than another build, and what every run cost.
import type { Index } from '../../shared/documents';
import { Comparison } from './comparison';
import { Costs } from './costs';

export function PerformanceSection({ index }: { index: Index }) {
  return (
    <section aria-labelledby="performance-heading">
      <h2 id="performance-heading">Performance</h2>
      {index.comparisons.length === 0 ? (
        <p class="empty">
          This report holds no comparison of builds.{' '}
          <code>cylon track compare --baseline WHAT --json FILE</code> makes one; then{' '}
          <code>cylon report FILE… --html REPORT</code>.
        </p>
      ) : null}
      {index.comparisons.map((of, i) => (
        <Comparison key={i} of={of} nth={i} />
      ))}
      <Costs verdicts={index.results.verdicts} />
    </section>
  );
}
