// The cards of `cylon hunt`: one fault each, its least scene, and a program that shows it.
import type { Hunt, Index } from '../../shared/documents';
import { count, short } from '../numbers';
import { Foreign, ForeignLines } from '../text';
import { visible } from '../visible';

type Card = Hunt['cards'][number];

function Errors({ of }: { of: Card }) {
  if (of.detail || of.measured.length === 0) return <ForeignLines text={of.detail} label="What the engine said" />;
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label={`Error of ${visible(of.name)} at each step`}>
      <table>
        <caption>
          Error at each step; allowed {short(of.allowed)} {visible(of.unit)}
        </caption>
        <thead>
          <tr>
            <th scope="col">step [s]</th>
            <th scope="col">error [{visible(of.unit)}]</th>
          </tr>
        </thead>
        <tbody>
          {of.measured.map(({ dt, error }) => (
            <tr key={dt}>
              <td class="number">{short(dt)}</td>
              <td class="number">{short(error)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function CardView({ of }: { of: Card }) {
  return (
    <article aria-label={visible(of.name)}>
      <h3>
        {visible(of.engine)} {visible(of.version)}: {visible(of.signature)}
      </h3>
      <p>
        What should happen: <Foreign text={of.says} />. {of.reason} Seen in {of.hits}{' '}
        {of.hits === 1 ? 'scene' : 'scenes'}; first in {visible(of.found_in)}.
      </p>
      <Errors of={of} />
      {of.opinions.length > 0 ? (
        <p>Other engines: {of.opinions.map((o) => `${visible(o.engine)}: ${visible(o.says)}`).join('; ')}.</p>
      ) : null}
      <details>
        <summary>The least scene</summary>
        <ForeignLines text={`${of.command}\n\n${of.scenario}`} label={`Scene of ${visible(of.name)}`} />
      </details>
      {of.program ? (
        <details>
          <summary>
            A program that shows it without Cylon; it prints {short(of.program.prints)} {visible(of.program.unit)}
          </summary>
          <ForeignLines
            text={`${of.program.command}\n\n${of.program.text}`}
            label={`Program of ${visible(of.name)}`}
          />
        </details>
      ) : (
        <p class="note">
          There is no program against the engine's own API: <Foreign text={of.no_program} />.
        </p>
      )}
    </article>
  );
}

/** What each engine was asked, which a hunt without a fault says too. */
function Asked({ of }: { of: Hunt }) {
  if (!of.asked || of.asked.length === 0) return of.cards.length > 0 ? null : <p>No fault.</p>;
  return (
    <ul>
      {of.asked.map(({ engine, scenes, refused, faulty }, i) => (
        <li key={i}>
          {visible(engine)}: {count(scenes, 'scene')}, {refused} refused, {faulty === 0 ? 'no fault' : `${faulty} with a fault`}
        </li>
      ))}
    </ul>
  );
}

export function FaultsSection({ index }: { index: Index }) {
  return (
    <section aria-labelledby="faults-heading">
      <h2 id="faults-heading">Faults that were found</h2>
      {index.hunts.length === 0 ? (
        <p class="empty">
          This report holds no hunt. <code>cylon hunt --engine ENGINE --count N --json FILE</code> makes one; then{' '}
          <code>cylon report FILE… --html REPORT</code>.
        </p>
      ) : null}
      {index.hunts.map((hunt, i) => (
        <Asked key={i} of={hunt} />
      ))}
      {index.hunts.flatMap((hunt, i) => hunt.cards.map((card) => <CardView key={`${i} ${card.name}`} of={card} />))}
    </section>
  );
}
