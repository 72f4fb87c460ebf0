"""Builds the viewer and the designer page from web/ into a wheel, where that is made from a checkout.

An installation in place needs no Node: views are still pictures there, and `gearwright serve` says how to build its
page, until `make web`. So it is in a wheel that is made where npm is missing or fails, unless GEARWRIGHT_REQUIRE_WEB is
set, as it is for wheels to be handed on.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

ASSETS = "src/gearwright/web_assets"


class WebBuildHook(BuildHookInterface[Any]):
    """Runs npm for wheels that are no installations in place."""

    PLUGIN_NAME = "custom"

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        if self.target_name != "wheel" or version == "editable":
            return
        root = Path(self.root)
        refusal = _built(root / "web")
        if refusal and os.environ.get("GEARWRIGHT_REQUIRE_WEB"):
            raise RuntimeError(f"viewer and designer page were not built: {refusal}")
        if refusal:
            self.app.display_warning(f"without the view that turns and the designer page: {refusal}")
        if (root / ASSETS).is_dir():
            build_data["force_include"][str(root / ASSETS)] = "gearwright/web_assets"


def _built(web: Path) -> str | None:
    """Builds what browsers load; gives why it could not be, None where it was."""
    npm = shutil.which("npm")
    if npm is None:
        return "npm was not found; install Node 20.19 or newer"
    for words in (["ci"], ["run", "build"]):
        done = subprocess.run([npm, *words], cwd=web, check=False, capture_output=True, text=True)  # noqa: S603  our own
        if done.returncode:
            return f"npm {' '.join(words)} failed:\n{done.stdout}{done.stderr}"
    return None
