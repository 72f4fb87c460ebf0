"""Builds the viewer's script from web/ into a wheel, where that is made from a checkout.

An installation in place needs no Node, and shows still pictures until `make web`; so does a wheel that is made where
npm is missing or fails, unless GEARWRIGHT_REQUIRE_VIEWER is set, as it is for wheels to be handed on.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

SCRIPT = "src/gearwright/web_assets/viewer.js"


class ViewerBuildHook(BuildHookInterface[Any]):
    """Runs npm for wheels that are no installations in place."""

    PLUGIN_NAME = "custom"

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        if self.target_name != "wheel" or version == "editable":
            return
        root = Path(self.root)
        refusal = _built(root / "web")
        if refusal and os.environ.get("GEARWRIGHT_REQUIRE_VIEWER"):
            raise RuntimeError(f"the viewer's script was not built: {refusal}")
        if refusal:
            self.app.display_warning(f"without the view that turns, since its script was not built: {refusal}")
        if (root / SCRIPT).is_file():
            build_data["force_include"][str(root / SCRIPT)] = "gearwright/web_assets/viewer.js"


def _built(web: Path) -> str | None:
    """Builds the script; gives why it could not be, None where it was."""
    npm = shutil.which("npm")
    if npm is None:
        return "npm was not found; install Node 20.19 or newer"
    for words in (["ci"], ["run", "build"]):
        done = subprocess.run([npm, *words], cwd=web, check=False, capture_output=True, text=True)  # noqa: S603  our own
        if done.returncode:
            return f"npm {' '.join(words)} failed:\n{done.stdout}{done.stderr}"
    return None
