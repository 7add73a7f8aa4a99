// Speed against accuracy: the work-precision plot of a scenario.
import { useMemo } from 'preact/hooks';

import type { Index, Trade, Verdict } from '../../shared/documents';
import { go, useAddress } from '../address';
import { buildOf } from '../builds';
import { count, short } from '../numbers';
import { sweepKey } from '../sweeps';
import { Numbers } from '../text';
import { visible } from '../visible';
import { buildsOf, isDrawn, join, type Measure, type Series, type Table } from './join';
import { Legend, SettingsTable } from './tables';
import { TradePlot } from './trade_plot';

interface Entry {
  key: string;
  trade: Trade;
  table: Table;
}

function entries(trades: Trade[]): Entry[] {
  return trades.flatMap((trade, i) =>
    trade.tables.map((table) => ({
      key: sweepKey(trades, i, table),
      trade,
      table,
    })),
  );
}

/** What the strictest claim about this quantity allows, in the measure's unit; null where none is about it.
 * */
function allowed(verdicts: Verdict[], table: Table, measure: Measure): number | null {
  if (measure.scale === null) return null;
  const levels = verdicts
    .filter(
      (v) =>
        v.scenario === table.scenario &&
        v.scenario_hash === table.scenario_hash &&
        v.observable === measure.name,
    )
    .flatMap((v) => (v.allowed !== null && v.allowed > 0 && v.unit === measure.unit ? [v.allowed] : []));
  return levels.length > 0 ? Math.min(...levels) / measure.scale : null;
}

function axisText(m: Measure): string {
  const over = m.scale === null ? '' : `, over ${short(m.scale)} ${m.unit}`;
  return `error of ${m.name}${over}, against ${m.against}`;
}

function describe(list: Series[]): string {
  const best = list.map((s) => {
    const least = Math.min(...s.points.filter(isDrawn).map((p) => p.error!));
    return `${s.label}: ${Number.isFinite(least) ? `least error ${short(least)}` : 'no finite error'}`;
  });
  return `Error against cost. ${best.join('. ')}.`;
}

function frontCaption(build: string): string {
  return build === ''
    ? 'Pareto front: no other setting is both faster and more accurate'
    : `Pareto front of ${visible(build)}: none of these is both faster and more accurate`;
}

function Plot({ index, entry }: { index: Index; entry: Entry }) {
  const { measure: wanted, hide = '' } = useAddress();
  const { trade, table } = entry;
  const measure =
    table.measures.find((m) => m.name === wanted) ??
    table.measures.find((m) => m.name === table.by) ??
    table.measures[0];
  const list = useMemo(() => join(trade, table, measure?.name ?? ''), [trade, table, measure]);
  const hidden = useMemo(() => new Set(hide.split(',').filter(Boolean).map(Number)), [hide]);
  if (!measure) return <p class="empty">This sweep measured no errors.</p>;
  const toggle = (series: number) => {
    const next = new Set(hidden);
    if (!next.delete(series)) next.add(series);
    go({ hide: [...next].join(',') });
  };
  const points = list.flatMap((s) => s.points).sort((a, b) => (a.cost ?? Infinity) - (b.cost ?? Infinity));
  const lost = points.filter((p) => !isDrawn(p));
  const builds = buildsOf(list);
  return (
    <>
      <label>
        measure{' '}
        <select value={measure.name} onChange={(event) => go({ measure: event.currentTarget.value })}>
          {table.measures.map((m) => (
            <option key={m.name} value={m.name}>
              {visible(m.name)}
            </option>
          ))}
        </select>
      </label>
      <p class="note">
        <Numbers text={`${axisText(measure)}; the reference itself is known to ${short(measure.resolution)}.`} /> Truth:{' '}
        <Numbers text={`${table.truth || 'none'}; ${short(table.duration)} s`} />, {count(table.bodies, 'body', 'bodies')}.
        Ringed (the Pareto front): no other setting is both faster and more accurate
        {measure.name === table.by ? '' : ' by this measure'}
        {builds.length > 1 ? ', of those that are run by the same; costs of others do not compare.' : '.'}
        {lost.length > 0
          ? ` ${count(lost.length, 'setting')} cannot be drawn, because the error is 0 or not finite, or because no ` +
            'time was measured. The last table lists them.'
          : ''}
      </p>
      <TradePlot
        list={list}
        hidden={hidden}
        error={axisText(measure)}
        level={allowed(index.results.verdicts, table, measure)}
        label={describe(list)}
      />
      <Legend list={list} hidden={hidden} toggle={toggle} />
      {builds.map((build) => (
        <SettingsTable
          key={build}
          list={list}
          points={points.filter(
            (p) => isDrawn(p) && p.onFront && buildOf(list[p.series]!.of.version) === build,
          )}
          caption={frontCaption(build)}
        />
      ))}
      <SettingsTable
        list={list}
        points={points.filter((p) => isDrawn(p) && !p.onFront)}
        caption="Other settings, each with one that is both faster and more accurate"
      />
      <SettingsTable list={list} points={lost} caption="Not drawn" />
    </>
  );
}

export function TradeSection({ index }: { index: Index }) {
  const { trade: wanted } = useAddress();
  const list = useMemo(() => entries(index.trades), [index]);
  const entry = list.find((e) => e.key === wanted) ?? list[0];
  return (
    <section aria-labelledby="trade-heading">
      <h2 id="trade-heading">Speed against accuracy</h2>
      {entry ? (
        <>
          <label>
            scenario{' '}
            <select
              value={entry.key}
              onChange={(event) => go({ trade: event.currentTarget.value, measure: '', hide: '' })}
            >
              {list.map(({ key }) => (
                <option key={key} value={key}>
                  {visible(key)}
                </option>
              ))}
            </select>
          </label>{' '}
          <Plot key={entry.key} index={index} entry={entry} />
        </>
      ) : (
        <p class="empty">
          This report holds no sweep. <code>cylon trade SCENARIO --json FILE</code> makes one; then{' '}
          <code>cylon report FILE… --html REPORT</code>.
        </p>
      )}
    </section>
  );
}
