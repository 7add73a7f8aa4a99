// The report's page: unpacks the index and draws it.  Everything else is unpacked when it is looked at.
import './report.css';

import { render } from 'preact';

import { unpackJson } from '../shared/block';
import type { Index, Provenance, Results } from '../shared/documents';
import { startTheme } from '../shared/theme';
import { startAddress } from './address';
import { App } from './app';

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

export function openReport(root: HTMLElement): void {
  startTheme();
  startAddress();
  unpackJson<Index>(0).then(
    (packed) => {
      const index = complete(packed);
      root.replaceChildren(); // the matrix for readers without script
      render(<App index={index} />, root);
    },
    (error: unknown) => render(<Unreadable why={String(error)} />, root),
  );
}
