// How errors, ratios of times, hashes and counts went from run to run.
import { useMemo, useState } from 'preact/hooks';

import type { Index } from '../../shared/documents';
import { go, useAddress } from '../address';
import { count, short } from '../numbers';
import { glob } from '../query/match';
import { visible } from '../visible';
import { type HistorySeries, SeriesPlot } from './series_plot';

const page = 24; // series drawn at a time

type Change = HistorySeries['changes'][number];

function ChangeNote({ change }: { change: Change }) {
  return (
    <li>
      <strong>{visible(change.state)}</strong> at run {change.run} ({visible(change.revision)}):{' '}
      {visible(change.sentence)}
      {change.ratio === undefined ? '' : `, ratio ${short(change.ratio)}`}
      {change.note ? `; note: ${visible(change.note)}` : ''} <span class="note">{visible(change.id)}</span>
    </li>
  );
}

/** What cannot be plotted: the runs at which the text became another. */
function Texts({ of }: { of: HistorySeries }) {
  const turns = of.points.filter((p, i) => i === 0 || p.text !== of.points[i - 1]!.text);
  return (
    <p class="note">
      {turns.slice(-6).map((p, i) => (
        <span key={i}>
          run {p.run}: <code>{visible(p.text ?? 'none')}</code>;{' '}
        </span>
      ))}
      {count(turns.length - 1, 'time')} another over {of.points.length} runs
    </p>
  );
}

function valueText(of: HistorySeries): string {
  const last = of.points[of.points.length - 1];
  if (!last || of.scale === 'text') return '';
  return `last ${short(last.value ?? null)}${of.unit && of.unit !== of.scale ? ` ${of.unit}` : ''}`;
}

const scales: Record<HistorySeries['scale'], string> = {
  ratio: 'ratio to the pinned binary',
  absolute: 'absolute: another machine or load moves it',
  value: 'value',
  text: 'text',
};

function SeriesCard({ of }: { of: HistorySeries }) {
  return (
    <li class="series">
      <h3>
        {visible(of.cell)} <span class="note">{visible(of.metric)}</span>
      </h3>
      {of.scale === 'text' ? <Texts of={of} /> : <SeriesPlot of={of} />}
      <p class="note">{[scales[of.scale], valueText(of)].filter(Boolean).join('; ')}</p>
      {of.changes.length > 0 ? (
        <ul>
          {of.changes.map((change) => (
            <ChangeNote key={change.id} change={change} />
          ))}
        </ul>
      ) : null}
    </li>
  );
}

/** Series that changed first, then ratios, then the rest as stored. */
function ordered(all: HistorySeries[]): HistorySeries[] {
  const weight = (s: HistorySeries) => 2 * Number(s.changes.length > 0) + Number(s.scale === 'ratio');
  return [...all].sort((a, b) => weight(b) - weight(a));
}

export function HistorySection({ index }: { index: Index }) {
  const { series: wanted = '' } = useAddress();
  const [limit, setLimit] = useState(page);
  const all = useMemo(() => ordered(index.histories.flatMap((h) => h.series)), [index]);
  const found = useMemo(() => {
    const matches = glob(`*${wanted}*`);
    return all.filter((s) => matches(`${s.cell} ${s.metric}`));
  }, [all, wanted]);
  const changed = all.filter((s) => s.changes.length > 0).length;
  return (
    <section aria-labelledby="history-heading">
      <h2 id="history-heading">History</h2>
      {all.length === 0 ? (
        <p class="empty">
          This report holds no history. <code>cylon track record</code> adds runs to it,{' '}
          <code>cylon track history --json</code> prints it as JSON; then{' '}
          <code>cylon report FILE… --html REPORT</code>.
        </p>
      ) : (
        <>
          <label>
            Only series that match{' '}
            <input
              type="search"
              value={wanted}
              onInput={(event) => go({ series: event.currentTarget.value })}
              placeholder="spring_*/ode* error:*"
            />
          </label>
          <p role="status">
            {found.length} of {all.length} series; {changed} with change points, which come first
          </p>
        </>
      )}
      <ul class="series-list">
        {found.slice(0, limit).map((s) => (
          <SeriesCard key={s.series} of={s} />
        ))}
      </ul>
      {found.length > limit ? (
        <button type="button" onClick={() => setLimit(limit + page)}>
          show {found.length - limit > page ? `${page} more of ${found.length - limit}` : `${found.length - limit} more`}
        </button>
      ) : null}
    </section>
  );
}
