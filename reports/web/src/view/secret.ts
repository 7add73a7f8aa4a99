// The secret that lets this page in: `cylon view` prints it behind the '#' of its address, which a browser sends to nobody.
// It leaves the address bar at once, and the tab keeps it, so that the page can be reloaded.
const key = 'cylon-token';

/** What a browser gives the page; tests give others. */
export interface Place {
  location: { pathname: string; search: string; hash: string };
  history: { state: unknown; replaceState(state: unknown, title: string, url: string): void };
  sessionStorage?: { getItem(key: string): string | null; setItem(key: string, value: string): void };
}

const partsOf = (hash: string): string[] => hash.replace(/^#/, '').split('&');
const isToken = (part: string): boolean => part.startsWith('token=');

export const hasSecret = (hash: string): boolean => partsOf(hash).some(isToken);

/** The token of the address, which is taken out of it. */
function takenFrom({ location, history }: Place): string {
  const parts = partsOf(location.hash);
  const own = parts.find(isToken);
  if (own === undefined) return '';
  const rest = parts.filter((part) => part !== own).join('&');
  history.replaceState(history.state, '', location.pathname + location.search + (rest && `#${rest}`));
  return own.slice('token='.length);
}

/** The token of the address, else of this tab; '' where there is none. */
export function secret(place: Place): string {
  const token = takenFrom(place);
  try {
    if (token === '') return place.sessionStorage?.getItem(key) ?? '';
    place.sessionStorage?.setItem(key, token);
  } catch {
    // Some browsers keep nothing: the page works until it is reloaded.
  }
  return token;
}
