// Starts the designer page.

import { Api, ApiError } from "./api";
import { Designer } from "./designer";
import { button, element } from "./dom";
import { Themes } from "./theme";
import "./theme.css";
import "./layout.css";
import "./form.css";
import "./print.css";

const themes = new Themes();

async function start(): Promise<void> {
  const host = document.getElementById("page")!;
  const api = new Api();
  try {
    const [elements, materials] = await Promise.all([api.elements(), api.materials()]);
    new Designer(host, themes, api, elements, materials);
    document.documentElement.dataset.ready = "true";
  } catch (error) {
    if (!(error instanceof ApiError)) throw error;
    host.replaceChildren(element("div", { class: "refusal", role: "alert" },
      element("h1", {}, "Gearwright"), element("p", {}, error.message), button("Try again", () => void start())));
  }
}

void start();
