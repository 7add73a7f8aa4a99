// One script serves both pages; the page says which it is.
import './shared/theme.css';

import { openReport } from './report/main';
import { openViewer } from './view/main';

const pages: Record<string, (root: HTMLElement) => void> = { report: openReport, view: openViewer };
const root = document.getElementById('app');
const page = pages[document.documentElement.dataset.page ?? ''];
if (root && page) page(root);
