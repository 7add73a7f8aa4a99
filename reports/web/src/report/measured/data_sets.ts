// The documents of the report by data set: what was predicted of one, and fitted to it.
import type { Index } from '../../shared/documents';
import type { FitDocument, HorizonSummary, Prediction, RestSummary } from '../../shared/measured_documents';

export interface DataSet {
  id: string; // hash
  of: Prediction | FitDocument; // one that says what was measured
  predictions: Prediction[];
  fits: FitDocument[];
}

export function dataSets({ predictions, fits }: Pick<Index, 'predictions' | 'fits'>): DataSet[] {
  const sets = new Map<string, DataSet>();
  const setOf = (of: Prediction | FitDocument): DataSet => {
    const set = sets.get(of.experiment) ?? { id: of.experiment, of, predictions: [], fits: [] };
    sets.set(of.experiment, set);
    return set;
  };
  for (const prediction of predictions) setOf(prediction).predictions.push(prediction);
  for (const fit of fits) setOf(fit).fits.push(fit);
  for (const set of sets.values()) set.predictions.sort((a, b) => Number(a.fitted) - Number(b.fitted)); // before, after
  return [...sets.values()];
}

/** Whose values a prediction takes. */
export function valuesOf({ fitted, set }: Prediction): string {
  if (fitted) return 'after the fit';
  return set.length > 0 ? `with ${set.join(', ')}` : "model's own values";
}

export interface ScoreRow {
  engine: string;
  values: string;
  score: RestSummary | HorizonSummary;
}

/** Every summary of a data set, those of an engine together: predictions first, then what judges the fits. */
export function scoreRows({ predictions, fits }: DataSet): ScoreRow[] {
  const rows: ScoreRow[] = [];
  for (const prediction of predictions)
    for (const score of prediction.engines) rows.push({ engine: score.engine, values: valuesOf(prediction), score });
  for (const { judged } of fits)
    for (const { engine, before, after } of judged) {
      if (before) rows.push({ engine, values: 'before the fit, on its judging runs', score: before });
      if (after) rows.push({ engine, values: 'after the fit, on its judging runs', score: after });
    }
  const engines = [...new Set(rows.map(({ engine }) => engine))];
  return engines.flatMap((engine) => rows.filter((row) => row.engine === engine));
}

export function isRest(score: RestSummary | HorizonSummary): score is RestSummary {
  return 'distance' in score;
}

/** "24.1 [21.1, 27.7]"; null is what is said of a number that is not there. */
export function estimateText(
  of: { value: number | null; low: number | null; high: number | null },
  scale: number,
  digits: number,
  missing = 'not known',
): string {
  const one = (x: number | null) => (x === null ? missing : (scale * x).toFixed(digits));
  if (of.value === null && of.low === null) return missing;
  if (of.low === null && of.high === null) return one(of.value);
  return `${one(of.value)} [${one(of.low)}, ${one(of.high)}]`;
}
