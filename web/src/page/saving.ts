// Gives somebody a file that the page itself has made, or one that the server has.

import { element } from "./dom";

export function saved(name: string, type: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  fetched(name, address);
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

export function fetched(name: string, address: string): void {
  const link = element("a", { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
}
