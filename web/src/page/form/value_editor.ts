// The editor that a parameter's kind asks for.

import type { Parameter } from "../protocol";
import { choiceEditor } from "./choice_editor";
import type { Changed, Context, Editor } from "./editor";
import { formsEditor } from "./forms_editor";
import { bothEditor, componentsEditor, eachEditor } from "./members_editor";
import { type Naming, numberEditor } from "./number_editor";

export function valueEditor(parameter: Parameter, naming: Naming, context: Context, changed: Changed): Editor {
  if (parameter.kind === "form") return formsEditor(parameter.forms, naming, context, changed, valueEditor);
  const one = (inner: Naming, tell: Changed, component?: number): Editor => {
    if (parameter.kind === "choice") return choiceEditor(parameter, inner, tell);
    const usual = Array.isArray(parameter.default) && component !== undefined ? parameter.default[component]! : parameter.default;
    return numberEditor({ ...parameter, default: usual }, inner, context, tell);
  };
  if (parameter.components.length) return componentsEditor(parameter, naming, context, one, changed);
  if (parameter.members === "each") return eachEditor(parameter, naming, context, one, changed);
  if (parameter.members === "both") return bothEditor(parameter, naming, context, one, changed);
  return one(naming, changed);
}
