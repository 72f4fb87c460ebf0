"""Builds the viewer's script from web/ into a wheel, where that is made from a checkout; an installation in place needs
no Node, and shows still pictures until `make web`."""

from __future__ import annotations

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
        npm = shutil.which("npm")
        if npm is not None:
            for words in (["ci", "--no-audit", "--no-fund"], ["run", "build"]):
                subprocess.run([npm, *words], cwd=root / "web", check=True)  # noqa: S603  words of our own
        elif not (root / SCRIPT).is_file():
            raise RuntimeError(
                "a wheel holds the viewer's script, which npm builds, and npm was not found: install Node 20.19+;"
                " `pip install --editable .` does without"
            )
        build_data["force_include"][str(root / SCRIPT)] = "gearwright/web_assets/viewer.js"
