export function openReport(_root: HTMLElement): void {}
