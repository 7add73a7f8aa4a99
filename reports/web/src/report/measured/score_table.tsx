// How well each engine predicts, before and after its fit.
import { visible } from '../visible';
import { estimateText, isRest, type ScoreRow } from './data_sets';

const degrees = 180 / Math.PI;

const restHeads = ['distance at rest [mm]', 'angle [deg]', 'same side up [%]', 'first touch, off by [ms]', 'its place, off by [mm]', 'energy lost, off by [%]'];
const horizonHeads = ['within 0.1 rad for [s]', 'to the end', 'by the start alone [s]', 'exponent [1/s]'];

function cells({ score }: ScoreRow): string[] {
  if (isRest(score))
    return [
      estimateText(score.distance, 1000, 1),
      estimateText(score.angle, degrees, 1),
      estimateText(score.same_side, 100, 1),
      estimateText(score.impact, 1000, 2),
      score.place ? estimateText(score.place, 1000, 1) : '',
      estimateText(score.loss, 100, 1),
    ];
  return [
    estimateText(score.held, 1, 3, 'the end'),
    `${score.to_the_end} of ${score.runs - score.failed}`,
    estimateText(score.expected, 1, 3, 'the end'),
    estimateText(score.exponent, 1, 2),
  ];
}

function Row({ row, width }: { row: ScoreRow; width: number }) {
  const { score } = row;
  const none = score.failed === score.runs;
  return (
    <tr>
      <th scope="row">{visible(row.engine)}</th>
      <td>{visible(row.values)}</td>
      <td class="number">{score.runs - score.failed}</td>
      {none ? (
        <td colSpan={width + 2}>no prediction: {visible(score.first_failure)}</td>
      ) : (
        <>
          {cells(row).map((cell, i) => (
            <td key={i} class="number">
              {cell}
            </td>
          ))}
          <td class="number">{score.covered.runs > 0 ? estimateText(score.covered, 100, 1) : ''}</td>
          <td>{score.covered.runs > 0 ? score.band : ''}</td>
        </>
      )}
    </tr>
  );
}

export function ScoreTable({ rows, title }: { rows: ScoreRow[]; title: string }) {
  const first = rows[0];
  if (!first) return null;
  const heads = isRest(first.score) ? restHeads : horizonHeads;
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label={`Scores of ${visible(title)}`}>
      <table>
        <caption>Predictions from the first frame; medians over runs with intervals of 95 %</caption>
        <thead>
          <tr>
            {['engine', 'values', 'runs', ...heads, 'inside the band [%]', '90 to 98 %'].map((head) => (
              <th key={head} scope="col">
                {head}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map((row, i) => (
            <Row key={i} row={row} width={heads.length} />
          ))}
        </tbody>
      </table>
    </div>
  );
}
