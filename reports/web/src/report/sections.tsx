// The parts of the report, in their order.
import type { ComponentType } from 'preact';

import type { Index } from '../shared/documents';
import { ProvenanceSection } from './provenance';

export interface Section {
  id: string;
  label: string;
  view: ComponentType<{ index: Index }> | null; // null: the matrix, which stays on the page
  size: (index: Index) => number | null; // entries, shown beside the label
}

export const sections: Section[] = [
  { id: 'matrix', label: 'Verdicts', view: null, size: (index) => index.results.verdicts.length },
  { id: 'provenance', label: 'Provenance', view: ProvenanceSection, size: () => null },
];
