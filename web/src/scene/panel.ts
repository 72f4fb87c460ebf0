// What is operated: native inputs, each with its label, so that keys and screen readers know them.

export interface Slider {
  row: HTMLElement;
  value(): number;
  set(value: number): void;
  limit(least: number, most: number): void;
}

type Child = Node | string;

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Record<string, string> = {}, ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

export function button(text: string, label: string, pressed: () => void): HTMLButtonElement {
  const made = element("button", { type: "button", "aria-label": label, title: label }, text);
  made.addEventListener("click", pressed);
  return made;
}

export function check(text: Child[], label: string, checked: boolean, changed: (on: boolean) => void): HTMLElement {
  const box = element("input", { type: "checkbox", "aria-label": label });
  box.checked = checked;
  box.addEventListener("change", () => changed(box.checked));
  return element("label", { class: "check", title: label }, box, ...text);
}

export function choice(label: string, options: Record<string, string>, changed: (value: string) => void): HTMLElement {
  const made = element("select", { "aria-label": label });
  for (const [value, text] of Object.entries(options)) made.append(element("option", { value }, text));
  made.addEventListener("change", () => changed(made.value));
  return made;
}

// told: the value as a person reads it
export function slider(label: string, told: (value: number) => string, changed: (value: number) => void): Slider {
  const input = element("input", { type: "range", "aria-label": label });
  const output = element("output", { "aria-live": "off" }); // the slider itself says its value
  const tell = () => {
    output.textContent = told(input.valueAsNumber);
    input.setAttribute("aria-valuetext", told(input.valueAsNumber));
  };
  input.addEventListener("input", () => {
    tell();
    changed(input.valueAsNumber);
  });
  return {
    row: element("span", { class: "slider" }, input, output),
    value: () => input.valueAsNumber,
    set(value) {
      input.value = `${value}`;
      tell();
    },
    limit(least, most) {
      Object.assign(input, { min: `${least}`, max: `${most}`, step: `${(most - least) / 720}` });
      tell();
    },
  };
}
