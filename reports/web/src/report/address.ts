// What the reader looks at, kept in the address after "#", so that a link shows the same.
import { useLayoutEffect, useState } from 'preact/hooks';

import type { CellName } from './fold';

export type Address = Record<string, string>;

export function parseAddress(hash: string): Address {
  return Object.fromEntries(new URLSearchParams(hash.replace(/^#/, '')));
}

/** "#section=matrix&q=…"; empty values are left out. */
export function addressText(address: Address): string {
  const kept = Object.entries(address).filter(([, value]) => value !== '');
  return `#${new URLSearchParams(kept).toString()}`;
}

const listeners = new Set<(address: Address) => void>();
let current: Address = {};

function announce(): void {
  for (const listener of listeners) listener(current);
}

export function startAddress(): void {
  current = parseAddress(location.hash);
  addEventListener('hashchange', () => {
    if (addressText(parseAddress(location.hash)) === addressText(current)) return;
    current = parseAddress(location.hash);
    announce();
  });
}

export function address(): Address {
  return current;
}

/** Goes to another address.  `push` makes a step that the browser's back button undoes. */
export function go(change: Address, push = false): void {
  current = Object.fromEntries(Object.entries({ ...current, ...change }).filter(([, value]) => value !== ''));
  const text = addressText(current);
  try {
    if (push) history.pushState(null, '', text);
    else history.replaceState(null, '', text);
  } catch {
    location.hash = text; // some browsers refuse to rewrite the address of a file
  }
  announce();
}

export function useAddress(): Address {
  const [value, set] = useState(current);
  // Before the reader can do anything: what changes ahead of a painted frame is heard as well.
  useLayoutEffect(() => {
    listeners.add(set);
    set(current);
    return () => void listeners.delete(set);
  }, []);
  return value;
}

// Every view's own words are dropped when another is opened.
const ofCell = { cell: '', engine: '', scheme: '', dt: '', other: '', claims: '', t: '' };

export function cellAddress(name: CellName): Address {
  return { ...ofCell, cell: name.scenario, engine: name.engine, scheme: name.integrator, dt: name.dt };
}

export function sectionAddress(section: string): Address {
  return { ...ofCell, section };
}

/** The link to a cell or a section that keeps the rest. */
export function link(change: Address): string {
  return addressText({ ...current, ...change });
}

export function cellOf(a: Address): CellName | null {
  if (a.cell === undefined) return null;
  return { scenario: a.cell, engine: a.engine ?? '', integrator: a.scheme ?? '', dt: a.dt ?? '' };
}
