// The live viewer's page.
import './view.css';

import { render } from 'preact';

import { startTheme } from '../shared/theme';
import { App } from './app';
import { Viewer } from './viewer';

export function openViewer(root: HTMLElement): void {
  startTheme();
  const viewer = new Viewer();
  root.replaceChildren();
  render(<App viewer={viewer} />, root);
  viewer.start();
}
