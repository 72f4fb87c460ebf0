// The data sheet that is printed: title, parameters as given, the picture; the tables follow from the page.

import { unitWord } from "./amounts";
import { unitOf } from "./design";
import { capital, element, symbol, words } from "./dom";
import { shown } from "./form/quantity";
import type { Design, Kind, Parameter, Value } from "./protocol";

export class Sheet {
  readonly element = element("section", { class: "sheet", "aria-hidden": "true" });

  // note: what is to be known of it, such as that it is of an earlier design
  show(kind: Kind, design: Design, title: string, picture: string | null, note: string): void {
    const given = kind.parameters.filter((parameter) => design[parameter.name] !== undefined);
    const rows = given.map((parameter) => element("tr", {},
      element("th", { scope: "row" }, capital(words(parameter.name)), " ", parameter.symbol ? symbol(parameter.symbol) : null),
      element("td", {}, text(design[parameter.name]!, parameter)),
      element("td", {}, unitWord(parameter.unit, unitOf(design)))));
    const image = element("img", { alt: "" });
    if (picture) image.src = picture;
    this.element.replaceChildren(
      element("h1", {}, capital(title || kind.name)),
      note ? element("p", { class: "sheet-note" }, note) : "",
      element("div", { class: "sheet-columns" },
        element("table", {}, element("caption", {}, "Parameters as given"), element("tbody", {}, ...rows)),
        ...(picture ? [image] : [])));
  }
}

function text(value: Value, parameter: Parameter): string {
  if (typeof value === "number") return shown(value);
  if (typeof value === "string") return value.startsWith("upload:") ? value.replace(/^.*\//, "") : value;
  if (Array.isArray(value) && parameter.kind !== "form") return value.map((one) => (one === null ? "–" : text(one, parameter))).join(" / ");
  const json = JSON.stringify(value);
  return json.length > 240 ? `${json.slice(0, 240)} …` : json;
}
