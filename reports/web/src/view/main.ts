export function openViewer(_root: HTMLElement): void {}
