// What the browser keeps for the next time. Storage may be switched off; the page works without.

export function recalled(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

export function keep(key: string, text: string): void {
  try {
    localStorage.setItem(key, text);
  } catch {
    // nothing is kept then
  }
}
