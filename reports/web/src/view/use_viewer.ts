import { useEffect, useState } from 'preact/hooks';

import type { Viewer } from './viewer';

/** Draws a component anew when the viewer has news. */
export function useViewer(viewer: Viewer): void {
  const [, count] = useState(0);
  useEffect(() => viewer.subscribe(() => count((n) => n + 1)), [viewer]);
}
