// Pictures and curves of a run, with the time cursor that they share.
import { useEffect, useMemo, useRef } from 'preact/hooks';

import type { Frames, TraceBlock } from '../../shared/block';
import type { Index, ScenarioView, TraceEntry } from '../../shared/documents';
import { TimeCursor } from '../../shared/plot_cursor';
import { address, go, useAddress } from '../address';
import type { Cell } from '../fold';
import { short, withUnit } from '../numbers';
import { compare } from '../status';
import { Foreign } from '../text';
import { visible } from '../visible';
import type { ClaimRow } from './claims';
import { extent, framed, parting } from './divergence';
import { ErrorCurves } from './error_curves';
import { Events } from './events';
import { entryKey, type Side, SideBySide, sideOf } from './side_by_side';
import { type Divergence, Timeline } from './timeline';
import { TotalCurves } from './total_curves';
import { useTrace } from './use_trace';

/** The other engine that is shown at first: the in-house one, beside that a foreign one, at the same step if
 * it is there. */
function suggested(choices: TraceEntry[], own: Cell): TraceEntry | null {
  const inHouse = (engine: string) => engine.startsWith('in-house');
  const wanted = (t: TraceEntry) => (inHouse(own.engine) ? !inHouse(t.engine) : t.engine === 'in-house');
  const sameStep = choices.filter((t) => t.dt_text === own.dt);
  return sameStep.find(wanted) ?? choices.find(wanted) ?? sameStep[0] ?? choices[0] ?? null;
}

/** Of the worst claim that was violated at a known time; else where the engines shown part. */
function firstDivergence(
  cell: Cell,
  block: TraceBlock,
  own: Side,
  other: Side | null,
  view: ScenarioView | undefined,
  size: number,
): Divergence | null {
  for (const verdict of [...cell.verdicts].sort((a, b) => compare(b, a))) {
    const first = block.trace.errors.find((e) => e.claim === verdict.claim)?.first_violation;
    if (!first) continue;
    return {
      time: first.time,
      what: `first violation of '${visible(verdict.claim)}' (${verdict.status}), step ${first.step}`,
    };
  }
  if (!other || !(size > 0)) return null;
  const found = parting(own.frames, other.frames, 0.01 * size);
  if (!found) return null;
  const body = view?.scene.body[found.body]?.name ?? `body ${found.body + 1}`;
  const gap = Number.isFinite(found.distance)
    ? withUnit(found.distance, 'm')
    : 'a distance that is not finite';
  const who = `${visible(body)} of ${visible(own.title)} and of ${visible(other.title)}`;
  const limit = `over 1 % of the scene's extent of ${short(size)} m`;
  const what = `no first violation is recorded; ${who} part by ${gap}, ${limit}`;
  return { time: found.time, what };
}

function wholeTime(frames: Frames, block: TraceBlock, duration: number): [number, number] {
  const ends = [duration, frames.time[frames.time.length - 1] ?? 0];
  for (const curve of block.trace.errors) ends.push(curve.first_violation?.time ?? 0);
  const end = Math.max(...ends.filter(Number.isFinite));
  return [0, end > 0 ? end : 1];
}

/** The cursor's time is kept in the address when it rests, and follows a link to another time. */
function usePinInAddress(cursor: TimeCursor): void {
  const { t = '0' } = useAddress();
  const written = useRef(t);
  useEffect(() => {
    if (t === written.current) return;
    written.current = t;
    cursor.pin = Number(t) || 0;
  }, [t, cursor]);
  useEffect(() => {
    let waiting = 0;
    const stop = cursor.listen(() => {
      clearTimeout(waiting);
      waiting = window.setTimeout(() => {
        const now = String(Number(cursor.pin.toPrecision(6)));
        if (now === written.current) return;
        written.current = now;
        go({ t: now === '0' ? '' : now });
      }, 300);
    });
    return () => {
      stop();
      clearTimeout(waiting);
    };
  }, [cursor]);
}

interface MotionProps {
  index: Index;
  cell: Cell;
  view: ScenarioView | undefined;
  block: TraceBlock;
  rows: ClaimRow[]; // whose curves are shown
}

export function Motion({ index, cell, view, block, rows }: MotionProps) {
  const { other: wanted } = useAddress();
  const title = entryKey({
    scenario: cell.scenario,
    engine: cell.engine,
    integrator: cell.integrator,
    dt_text: cell.dt,
    block: 0,
  });
  const choices = useMemo(
    () => index.traces.filter((t) => t.scenario === cell.scenario && entryKey(t) !== title),
    [index, cell, title],
  );
  const chosen =
    wanted === '-' ? null : (choices.find((t) => entryKey(t) === wanted) ?? suggested(choices, cell));
  const loaded = useTrace(chosen?.block ?? null);

  const own = useMemo(() => sideOf(title, block), [title, block]);
  const otherBlock = loaded.state === 'ready' ? loaded.block : null;
  const other = useMemo(
    () => (otherBlock && chosen ? sideOf(entryKey(chosen), otherBlock) : null),
    [otherBlock, chosen],
  );
  const bounds = useMemo(() => framed(own.ghost, [own.frames, other?.frames ?? null]), [own, other]);
  const cursor = useMemo(
    () => new TimeCursor(wholeTime(own.frames, block, view?.duration ?? 0), Number(address().t ?? 0) || 0),
    [own, block, view],
  );
  usePinInAddress(cursor);
  const divergence = useMemo(
    () => firstDivergence(cell, block, own, other, view, bounds ? extent(bounds) : 0),
    [cell, block, own, other, view, bounds],
  );
  const compared = useMemo(
    () => (other && chosen ? { engine: chosen.engine, block: other.block } : null),
    [other, chosen],
  );
  const { remarks } = block.trace;

  return (
    <>
      <Timeline cursor={cursor} frames={own.frames.time} divergence={divergence} />
      {view ? (
        <SideBySide
          scene={view.scene}
          own={own}
          other={other}
          choices={choices}
          chosen={chosen ? entryKey(chosen) : ''}
          bounds={bounds}
          cursor={cursor}
          trouble={loaded.state === 'broken' ? `The other trace cannot be read: ${loaded.why}` : ''}
        />
      ) : null}
      <ErrorCurves rows={rows} block={block} other={compared} cursor={cursor} />
      <TotalCurves block={block} other={compared} cursor={cursor} />
      <Events events={block.trace.events} cursor={cursor} />
      {remarks.length > 0 ? (
        <section aria-labelledby="remarks-heading">
          <h3 id="remarks-heading">Remarks of the harness</h3>
          <ul>
            {remarks.map((text, i) => (
              <li key={i}>
                <Foreign text={text} />
              </li>
            ))}
          </ul>
        </section>
      ) : null}
    </>
  );
}
