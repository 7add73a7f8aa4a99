// Light or dark: what the system prefers unless the reader says otherwise; always light on paper.

export type Theme = 'auto' | 'light' | 'dark';

const key = 'cylon-theme';
const listeners = new Set<() => void>();
const dark = matchMedia('(prefers-color-scheme: dark)');
let chosen: Theme = remembered();
let printing = false;

function remembered(): Theme {
  try {
    const text = localStorage.getItem(key);
    return text === 'light' || text === 'dark' ? text : 'auto';
  } catch {
    return 'auto'; // pages from a file may have no storage
  }
}

function apply(): void {
  const isDark = !printing && (chosen === 'dark' || (chosen === 'auto' && dark.matches));
  document.documentElement.dataset.theme = isDark ? 'dark' : 'light';
  for (const listener of listeners) listener();
}

export function theme(): Theme {
  return chosen;
}

export function setTheme(next: Theme): void {
  chosen = next;
  try {
    localStorage.setItem(key, next);
  } catch {
    // It then holds for this visit.
  }
  apply();
}

/** Calls back after every change of colours, for what is drawn and not styled; returns how to stop. */
export function onTheme(listener: () => void): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

/** The value of a colour of theme.css, such as "--ink". */
export function color(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** To be called once, before anything is drawn. */
export function startTheme(): void {
  dark.addEventListener('change', apply);
  addEventListener('beforeprint', () => ((printing = true), apply()));
  addEventListener('afterprint', () => ((printing = false), apply()));
  apply();
}
