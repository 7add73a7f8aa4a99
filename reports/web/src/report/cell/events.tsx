// What happened when, as a list whose times move the cursor.
import type { Trace } from '../../shared/documents';
import type { TimeCursor } from '../../shared/plot_cursor';
import { short } from '../numbers';
import { useFew } from '../use_few';
import { visible } from '../visible';

export function Events({ events, cursor }: { events: Trace['events']; cursor: TimeCursor }) {
  const { list, button } = useFew(events);
  return (
    <section aria-labelledby="events-heading">
      <h3 id="events-heading">Events</h3>
      {events.length === 0 ? <p class="empty">None was recorded.</p> : null}
      {events.length > 0 ? (
        <table>
          <thead>
            <tr>
              <th scope="col">time</th>
              <th scope="col">kind</th>
              <th scope="col">what</th>
            </tr>
          </thead>
          <tbody>
            {list.map((event, i) => (
              <tr key={i}>
                <td class="number">
                  <button
                    type="button"
                    class="plain-on-paper"
                    onClick={() => (cursor.pin = event.time)}
                    title="move the cursor here"
                  >
                    {short(event.time, 8)} s
                  </button>
                </td>
                <td>{visible(event.kind)}</td>
                <td>{visible(event.what)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      ) : null}
      {button}
    </section>
  );
}
