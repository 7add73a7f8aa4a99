// The page's keys.  Those of a picture with the focus (arrows, plus, minus, Home) are its own.
import type { Viewer } from './viewer';

export const keys: [string, string][] = [
  ['Space', 'play or pause'],
  ['.', 'one step, then pause'],
  ['R', 'reset'],
  ['1 … 9', 'kick body 1 … 9; with Shift the other way'],
  ['[ and ]', 'slower, faster'],
  ['V, M, L', 'arrows of velocity, momentum, angular momentum'],
  ['T, C, J', 'trails, contacts, springs and joints'],
  ['Arrows, + and −', 'turn and zoom the picture with the focus; with Shift move it'],
  ['Home', 'frame all'],
  ['Drag', 'turns the picture; on a body, pulls it by a spring. Shift or right button moves the picture'],
  ['?', 'this list'],
];

/** Where keys write or choose something, they are not the page's. */
function taken(event: KeyboardEvent): boolean {
  const target = event.target as HTMLElement | null;
  if (!target?.matches) return false;
  if (target.matches('input:not([type=checkbox]):not([type=range]), select, textarea')) return true;
  return event.key === ' ' && target.matches('button, input, summary, a');
}

export function keyboard(viewer: Viewer, help: () => void): (event: KeyboardEvent) => void {
  const flip = (name: keyof Viewer['shown']) => (): void => viewer.show({ [name]: !viewer.shown[name] });
  const faster = (factor: number) => (): void =>
    viewer.send({ do: 'speed', value: Math.min(100, Math.max(0.01, viewer.speed * factor)) });
  const actions: Record<string, () => void> = {
    ' ': () => viewer.toggle(),
    '.': () => viewer.send({ do: 'step' }),
    r: () => viewer.send({ do: 'reset' }),
    '[': faster(1 / 1.5),
    ']': faster(1.5),
    v: flip('velocity'),
    m: flip('momentum'),
    l: flip('angular momentum'),
    t: flip('trails'),
    c: flip('contacts'),
    j: flip('links'),
    '?': help,
  };
  return (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented || taken(event)) return;
    const digit = /^(?:Digit|Numpad)([1-9])$/.exec(event.code);
    const action = digit
      ? () => viewer.kick(Number(digit[1]) - 1, event.shiftKey)
      : actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action || (event.repeat && event.key !== '.')) return;
    action();
    event.preventDefault();
  };
}
