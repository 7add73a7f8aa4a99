// The parts of the report, in their order.  The page opens with the first that holds anything.
import type { ComponentType } from 'preact';

import type { Index } from '../shared/documents';
import { FaultsSection } from './faults/faults_section';
import { HistorySection } from './history/history_section';
import { dataSets } from './measured/data_sets';
import { MeasuredSection } from './measured/measured_section';
import { PerformanceSection } from './performance/performance_section';
import { ProvenanceSection } from './provenance';
import { stepScenarios } from './steps/fold_steps';
import { StepsSection } from './steps/steps_section';
import { TradeSection } from './trade/trade_section';

export interface Section {
  id: string;
  label: string;
  view: ComponentType<{ index: Index }> | null; // null: the matrix, which stays on the page
  size: (index: Index) => number | null; // entries, shown beside the label
  holds?: (index: Index) => boolean; // whether there is anything to say; where absent, whether there are entries
}

const sum = (list: { length: number }[]) => list.reduce((n, { length }) => n + length, 0);

export const sections: Section[] = [
  {
    id: 'steps',
    label: 'Steps',
    view: StepsSection,
    size: (index) => stepScenarios(index.trades),
  },
  { id: 'matrix', label: 'Verdicts', view: null, size: (index) => index.results.verdicts.length },
  {
    id: 'trade',
    label: 'Speed against accuracy',
    view: TradeSection,
    size: (index) => sum(index.trades.map((t) => t.tables)),
  },
  {
    id: 'performance',
    label: 'Performance',
    view: PerformanceSection,
    size: (index) => sum(index.comparisons.map((c) => c.cells)),
  },
  {
    id: 'history',
    label: 'History',
    view: HistorySection,
    size: (index) => sum(index.histories.map((h) => h.series)),
  },
  {
    id: 'faults',
    label: 'Faults',
    view: FaultsSection,
    size: (index) => (index.hunts.length > 0 ? sum(index.hunts.map((h) => h.cards)) : null),
    holds: (index) => index.hunts.length > 0, // with a fault or without
  },
  {
    id: 'measured',
    label: 'Measured motions',
    view: MeasuredSection,
    size: (index) => dataSets(index).length,
  },
  { id: 'provenance', label: 'Provenance', view: ProvenanceSection, size: () => null },
];

/** The part that the page opens with, where the address names none. */
export function firstFilled(index: Index): Section | undefined {
  return sections.find(({ size, holds }) => holds?.(index) ?? size(index) !== 0);
}
