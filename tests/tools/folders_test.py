"""The folders of tools/ use each other in one direction."""

from __future__ import annotations

import re
from graphlib import TopologicalSorter

from sbgc_command import ROOT


def test_folders_form_no_circle() -> None:
    tools = ROOT / "tools"
    uses: dict[str, set[str]] = {}
    for file in tools.glob("**/*.?pp"):
        folder = file.relative_to(tools).parts[0]
        used = re.findall(r'^#include "(\w+)/', file.read_text("utf-8"), re.MULTILINE)
        uses.setdefault(folder, set()).update(set(used) - {folder})
    assert "board" in uses["parameters"], "the includes are found"
    TopologicalSorter(uses).prepare()  # raises an error that names a circle
