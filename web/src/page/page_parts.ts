// Where everything of the page stands.

import { element } from "./dom";

export interface Parts {
  form: HTMLElement;
  views: HTMLElement;
  strip: HTMLElement;
  main: HTMLElement;
}

export function arranged(host: HTMLElement, header: HTMLElement, results: HTMLElement, others: HTMLElement[]): Parts {
  const form = element("section", { class: "form", id: "form", "aria-label": "Parameters", tabindex: "-1" });
  const views = element("div", { class: "views-side" });
  const strip = element("output", { class: "strip", "aria-live": "off" });
  const middle = element("div", { class: "middle" }, views, strip);
  const main = element("main", {}, middle, form, results);
  const skip = element("a", { class: "skip", href: "#form" }, "Skip to the parameters");
  skip.addEventListener("click", (event) => {
    event.preventDefault(); // the address holds the design
    (form.querySelector<HTMLElement>("input, select, textarea") ?? form).focus();
  });
  host.replaceChildren(skip, header, main, ...others);
  return { form, views, strip, main };
}
