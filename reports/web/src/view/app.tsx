// The page: what runs, how, the pictures, the numbers, and what can be changed.
import { useEffect, useRef } from 'preact/hooks';

import { HelpDialog } from './help';
import { KickPanel } from './kick_panel';
import { keyboard } from './keyboard';
import { LanePanel } from './lane_panel';
import { LaneView } from './lane_view';
import { ParameterPanel } from './parameter_panel';
import { Plots } from './plots';
import { Readout } from './readout';
import { ShowPanel } from './show_panel';
import { Transport } from './transport';
import { useViewer } from './use_viewer';
import { laneName } from './viewer';
import type { Viewer } from './viewer';

function Banner({ viewer }: { viewer: Viewer }) {
  const { connected, locked, why, notice } = viewer;
  return (
    <div class="banners" role="alert">
      {locked && (
        <p class="banner gone">
          This page lacks the secret of the viewer. Open the address that <code>cylon view</code> printed: it
          holds the secret.
        </p>
      )}
      {!connected && !locked && (
        <p class="banner gone">No connection to the server: {why}. The page tries again by itself.</p>
      )}
      {connected && notice !== '' && (
        <p class="banner notice">
          {notice}
          <button type="button" onClick={() => viewer.tell('')} aria-label="close this message">
            ×
          </button>
        </p>
      )}
    </div>
  );
}

export function App({ viewer }: { viewer: Viewer }) {
  useViewer(viewer);
  const help = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const onKey = keyboard(viewer, () =>
      help.current?.open ? help.current.close() : help.current?.showModal(),
    );
    addEventListener('keydown', onKey);
    return () => removeEventListener('keydown', onKey);
  }, [viewer]);
  const { session, state } = viewer;
  return (
    <>
      <header class="head">
        <h1>{session?.title ?? 'Cylon'}</h1>
        {session && (
          <details class="story">
            <summary>{session.scenario}</summary>
            <p>{session.story}</p>
          </details>
        )}
        <button type="button" onClick={() => help.current?.showModal()}>
          Keys <kbd>?</kbd>
        </button>
      </header>
      <Banner viewer={viewer} />
      {session && (
        <main class="viewer">
          <Transport viewer={viewer} session={session} />
          <section class={`lanes of-${Math.min(session.lanes.length, 4)}`} aria-label="pictures">
            {session.lanes.map((lane, i) => (
              <LaneView
                key={`${i} ${laneName(lane)}`}
                viewer={viewer}
                index={i}
                lane={lane}
                state={state?.lanes[i]}
              />
            ))}
          </section>
          <div class="numbers">
            <Readout viewer={viewer} lanes={session.lanes} />
            <Plots viewer={viewer} lanes={session.lanes} />
          </div>
          <aside class="panels" aria-label="settings">
            <ShowPanel viewer={viewer} />
            <KickPanel viewer={viewer} scene={session.scene} />
            <ParameterPanel viewer={viewer} scene={session.scene} />
            <LanePanel viewer={viewer} session={session} />
          </aside>
        </main>
      )}
      <HelpDialog dialog={help} />
    </>
  );
}
