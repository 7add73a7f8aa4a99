// The report's page: unpacks the index and draws it.  Everything else is unpacked when it is looked at.
import './report.css';

import { render } from 'preact';

import { unpackJson } from '../shared/block';
import type { Index, Provenance, Results } from '../shared/documents';
import { startTheme } from '../shared/theme';
import { address, go, startAddress } from './address';
import { App } from './app';
import { fold, type Matrix } from './fold';
import { rememberedColumns } from './matrix/remembered_columns';
import { withColumns } from './query/columns';
import { firstFilled } from './sections';

function Unreadable({ why }: { why: string }) {
  return (
    <main>
      <h1>This report cannot be read</h1>
      <p role="alert">{why}</p>
    </main>
  );
}

const nowhere: Provenance = {
  cylon: '',
  revision: '',
  compiler: '',
  flags: '',
  machine: '',
  os: '',
  date: '',
  command_line: '',
  tolerance_scale: 1,
};

/** A report of sweeps or histories alone has no verdicts. */
function complete(index: Index): Index {
  const results = index.results as Results | null;
  return results ? index : { ...index, results: { schema: 1, provenance: nowhere, verdicts: [] } };
}

/** Puts the columns of the last visit into the address, unless that has a query of its own.  The page opens with the
 * part that it would open with otherwise. */
function restoreColumns(index: Index, { columns }: Matrix): void {
  const { q, section = firstFilled(index)?.id ?? '' } = address();
  const shown = rememberedColumns(columns);
  if (q === undefined && !shown.every(Boolean)) go({ section, q: withColumns('', columns, shown) });
}

export function openReport(root: HTMLElement): void {
  startTheme();
  startAddress();
  unpackJson<Index>(0).then(
    (packed) => {
      const index = complete(packed);
      root.replaceChildren(); // the matrix for readers without script
      const matrix = fold(index.results.verdicts);
      restoreColumns(index, matrix);
      render(<App index={index} matrix={matrix} />, root);
    },
    (error: unknown) => render(<Unreadable why={String(error)} />, root),
  );
}
