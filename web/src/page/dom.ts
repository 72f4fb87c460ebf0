// Elements of the page: native ones, with their labels, so that keys and screen readers know them.

export type Child = Node | string | null;

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Record<string, string> = {}, ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children.filter((child) => child !== null));
  return made;
}

// label: what it does, where its text alone does not say it
export function button(text: string, pressed: () => void, label = "", kind = ""): HTMLButtonElement {
  const made = element("button", { type: "button" }, text);
  if (label) {
    made.setAttribute("aria-label", label);
    made.title = label;
  }
  if (kind) made.className = kind;
  made.addEventListener("click", pressed);
  return made;
}

export function options(select: HTMLSelectElement, words: [value: string, text: string][]): HTMLSelectElement {
  select.append(...words.map(([value, text]) => element("option", { value }, text)));
  return select;
}

let count = 0;

// An id that no other element of the page has.
export const unique = (word: string) => `${word}-${++count}`;

// A textbook's symbol: what follows "_" stands lower, up to a star.
export function symbol(text: string): HTMLElement {
  const [, head = "", foot = "", rest = ""] = /^([^_]*)(?:_([^*]*))?(.*)$/.exec(text) ?? [];
  return element("i", { class: "symbol" }, head, foot ? element("sub", {}, foot) : null, rest);
}

// A parameter's name as words.
export const words = (name: string) => name.replaceAll("_", " ");

export const capital = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);
