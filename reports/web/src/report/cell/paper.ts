// A 3D picture on paper: nothing waits there for the next frame, and what WebGL drew is lost after it.

function copyOnto(target: HTMLCanvasElement, layers: Iterable<HTMLCanvasElement>): void {
  const context = target.getContext('2d');
  [...layers].forEach((layer, i) => {
    if (i === 0) [target.width, target.height] = [layer.width, layer.height];
    if (layer.width > 0 && layer.height > 0) context?.drawImage(layer, 0, 0);
  });
}

/** Puts a copy of the host's canvases after it while the page is printed.  `update` marks the picture as to
 * be drawn, `draw` draws it.  Returns how to stop. */
export function onPaper(host: HTMLElement, update: () => void, draw: () => void): () => void {
  const paper = document.createElement('canvas');
  paper.className = 'pane-paper';
  const to = () => {
    update();
    queueMicrotask(() => {
      draw(); // after the picture has seen the colours change
      copyOnto(paper, host.querySelectorAll('canvas'));
      host.after(paper);
    });
  };
  const from = () => paper.remove();
  addEventListener('beforeprint', to);
  addEventListener('afterprint', from);
  return () => {
    removeEventListener('beforeprint', to);
    removeEventListener('afterprint', from);
    from();
  };
}
