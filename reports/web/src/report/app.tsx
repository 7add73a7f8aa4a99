// The page: verdict line, the parts of the report, an open cell.
import { useEffect, useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';

import type { Index } from '../shared/documents';
import { stepInWords } from '../shared/durations';
import { setTheme, theme, type Theme } from '../shared/theme';
import { cellOf, link, sectionAddress, useAddress } from './address';
import { CellPage } from './cell/cell_page';
import { find, type Matrix } from './fold';
import { MatrixSection } from './matrix/matrix_section';
import { Overview, VerdictLine } from './overview';
import { firstFilled, sections } from './sections';
import { visible } from './visible';

const themes: Record<Theme, { next: Theme; label: string }> = {
  auto: { next: 'light', label: 'Colours: as the system' },
  light: { next: 'dark', label: 'Colours: light' },
  dark: { next: 'auto', label: 'Colours: dark' },
};

function ThemeButton() {
  const [now, set] = useState(theme());
  const turn = () => {
    setTheme(themes[now].next);
    set(themes[now].next);
  };
  return (
    <button type="button" class="theme" onClick={turn}>
      {themes[now].label}
    </button>
  );
}

function Navigation({ index, open }: { index: Index; open: string }) {
  return (
    <nav aria-label="Parts of the report">
      <ul>
        {sections.map(({ id, label, size }) => {
          const n = size(index);
          return (
            <li key={id}>
              <a href={link(sectionAddress(id))} aria-current={id === open ? 'page' : undefined}>
                {label}
                {n === null ? '' : ` (${n})`}
              </a>
            </li>
          );
        })}
      </ul>
    </nav>
  );
}

export function App({ index, matrix }: { index: Index; matrix: Matrix }) {
  const address = useAddress();
  const views = useMemo(() => new Map(index.scenarios.map((view) => [view.name, view])), [index]);
  const filled = firstFilled(index);
  // A filter is one of verdicts.
  const unnamed = address.q === undefined && filled ? filled.id : 'matrix'; // of an address that names no part
  const section = [address.section, unnamed].flatMap((wanted) => sections.find(({ id }) => id === wanted) ?? [])[0]!;
  const name = cellOf(address);
  const View = section.view;
  const cell = useMemo(
    () => (name ? find(matrix, name) : null),
    [matrix, name?.scenario, name?.engine, name?.integrator, name?.dt],
  );
  const content = useRef<HTMLElement>(null);
  const what = name ? `${name.scenario} / ${name.engine}` : section.label;
  useEffect(() => {
    document.title = visible(`${what} - ${index.title}`);
  }, [what, index]);
  const wasOpen = useRef(false);
  useLayoutEffect(() => {
    // Who comes back from a cell goes on where he left the matrix.
    if (wasOpen.current && !name && !View)
      document.querySelector<HTMLElement>('.matrix [tabindex="0"]')?.focus();
    wasOpen.current = name !== null;
  });
  return (
    <>
      <header>
        <a
          class="skip"
          href="#content"
          onClick={(event) => {
            event.preventDefault(); // the address keeps what is shown
            content.current?.focus();
          }}
        >
          Skip to the content
        </a>
        <h1>{visible(index.title)}</h1>
        <ThemeButton />
        <VerdictLine index={index} matrix={matrix} />
        <Navigation index={index} open={name ? '' : section.id} />
      </header>
      <main id="content" ref={content} tabIndex={-1}>
        <div class={name || View ? 'paper-only' : undefined}>
          <Overview index={index} />
          <MatrixSection matrix={matrix} views={views} />
        </div>
        {!name && View ? <View index={index} /> : null}
        {name && cell ? (
          <CellPage index={index} matrix={matrix} cell={cell} view={views.get(cell.scenario)} />
        ) : null}
        {name && !cell ? (
          <p role="alert">
            The report has no run of {visible(name.scenario)} by {visible(name.engine)}{' '}
            {visible(name.integrator)} at {visible(stepInWords(name.dt))}.{' '}
            <a href={link(sectionAddress('matrix'))}>All runs</a>
          </p>
        ) : null}
      </main>
    </>
  );
}
