// Foreign text (names, stories, engines' output) with everything invisible made visible, so that it cannot
// hide or reorder what a reader sees.

const hidden = new RegExp(
  [
    '[\\u0000-\\u001f\\u007f-\\u009f]', // controls
    '[\\u00ad\\u061c\\u180e\\u200b-\\u200f\\u2028-\\u202e\\u2060-\\u2069\\ufeff\\ufff9-\\ufffb]', // no width
    '[\\ud800-\\udbff](?![\\udc00-\\udfff])|(?<![\\ud800-\\udbff])[\\udc00-\\udfff]', // halves of pairs
  ].join('|'),
  'g',
);

function sign(character: string): string {
  return `\\u${character.charCodeAt(0).toString(16).padStart(4, '0')}`; // few fonts have pictures of controls
}

/** One line: a line feed is shown as \\u000a, like every other control character. */
export function visible(text: string): string {
  return text.replace(hidden, sign);
}

/** Several lines: line feeds and tabs stay, a carriage return before a line feed goes. */
export function visibleLines(text: string): string {
  return text.replace(/\r\n/g, '\n').replace(hidden, (c) => (c === '\n' || c === '\t' ? c : sign(c)));
}
