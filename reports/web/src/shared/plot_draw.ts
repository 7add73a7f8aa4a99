// What uPlot does not draw by itself: markers along the curves, level lines, first violations, events.
import type uPlot from 'uplot';

import type { Curve } from './plot_data';
import { drawMarker, lookOf } from './plot_marks';
import { color } from './theme';

const markersPerCurve = 7;

function markers(u: uPlot, curves: Curve[], scale: number): void {
  const { left, width } = u.bbox;
  curves.forEach((curve, i) => {
    if (curve.faint) return;
    const column = u.data[i + 1]!;
    for (let k = 0; k < markersPerCurve; ++k) {
      const place = left + (width * (k + (i + 1) / (curves.length + 1))) / markersPerCurve;
      let at = u.posToIdx(place, true);
      while (at < column.length && column[at] == null) ++at; // the next of this curve's own samples
      const value = column[at];
      if (value == null) continue;
      const x = u.valToPos(u.data[0]![at]!, 'x', true);
      if (x <= left + width) drawMarker(u.ctx, curve.style, x, u.valToPos(value, 'y', true), scale);
    }
  });
}

function level(u: uPlot, curve: Curve, scale: number, text: string): void {
  if (curve.allowed == null || !(curve.allowed > 0)) return;
  const { left, width, top, height } = u.bbox;
  const y = u.valToPos(curve.allowed, 'y', true);
  if (y < top || y > top + height) return;
  u.ctx.strokeStyle = u.ctx.fillStyle = color(lookOf(curve.style).color);
  u.ctx.lineWidth = 1.5 * scale;
  u.ctx.setLineDash([3 * scale, 3 * scale]);
  u.ctx.beginPath();
  u.ctx.moveTo(left, y);
  u.ctx.lineTo(left + width, y);
  u.ctx.stroke();
  u.ctx.setLineDash([]);
  u.ctx.font = `${11 * scale}px system-ui, sans-serif`;
  u.ctx.textAlign = 'right';
  u.ctx.fillText(text, left + width - 4 * scale, y - 4 * scale);
}

function violation(u: uPlot, curve: Curve, scale: number): void {
  if (!curve.violation) return;
  const { left, width, top, height } = u.bbox;
  const x = u.valToPos(curve.violation.time, 'x', true);
  if (x < left || x > left + width) return;
  const { value } = curve.violation;
  const y = value === null ? top : Math.min(top + height, Math.max(top, u.valToPos(value, 'y', true)));
  u.ctx.strokeStyle = color('--ink');
  u.ctx.lineWidth = 2 * scale;
  u.ctx.beginPath();
  u.ctx.arc(x, y, 7 * scale, 0, 2 * Math.PI);
  u.ctx.moveTo(x - 4 * scale, y - 4 * scale);
  u.ctx.lineTo(x + 4 * scale, y + 4 * scale);
  u.ctx.moveTo(x - 4 * scale, y + 4 * scale);
  u.ctx.lineTo(x + 4 * scale, y - 4 * scale);
  u.ctx.stroke();
}

/** The shaded ranges around curves; before the curves are drawn. */
export function drawBands(u: uPlot, curves: Curve[]): void {
  const { left, top, width, height } = u.bbox;
  u.ctx.save();
  u.ctx.beginPath();
  u.ctx.rect(left, top, width, height);
  u.ctx.clip();
  for (const { band, time, style } of curves) {
    if (!band || time.length === 0) continue;
    u.ctx.fillStyle = color(lookOf(style).color);
    u.ctx.globalAlpha = 0.22;
    u.ctx.beginPath();
    for (let i = 0; i < time.length; ++i)
      u.ctx.lineTo(u.valToPos(time[i]!, 'x', true), u.valToPos(band.high[i]!, 'y', true));
    for (let i = time.length - 1; i >= 0; --i)
      u.ctx.lineTo(u.valToPos(time[i]!, 'x', true), u.valToPos(band.low[i]!, 'y', true));
    u.ctx.closePath();
    u.ctx.fill();
  }
  u.ctx.restore();
}

/** Level lines that lie on one another are drawn once. */
export function drawExtras(u: uPlot, curves: Curve[], levelText: (allowed: number) => string): void {
  const scale = devicePixelRatio;
  u.ctx.save();
  const drawn = new Set<number>();
  for (const curve of curves) {
    if (curve.allowed == null || drawn.has(curve.allowed)) continue;
    drawn.add(curve.allowed);
    level(u, curve, scale, levelText(curve.allowed));
  }
  markers(u, curves, scale);
  for (const curve of curves) violation(u, curve, scale);
  u.ctx.restore();
}
