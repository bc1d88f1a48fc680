"""The layers of the code: a library includes no private header of another one (CONTRIBUTING.md says which are
its doors), and the folders of tools/ use each other in one direction."""

from __future__ import annotations

import re
from graphlib import TopologicalSorter
from pathlib import Path

from sbgc_command import ROOT

LIBRARIES = [*ROOT.glob("runtime/*"), ROOT / "emulator"]
FOLDERS = (
    "bench",
    "emulator",
    "examples",
    "fuzz",
    "gateway",
    "generated",
    "python",
    "runtime",
    "tests",
    "tools",
)
PRIVATE = re.compile(r"include/(.*/detail/.*)|src/(.*)|((?:device|physics|line)/.*)")


def library_of(file: Path) -> str:
    """The name of a library, or "tests"."""
    parts = file.relative_to(ROOT).parts
    if parts[0] in ("bench", "fuzz", "tests") or "tests" in parts:
        return "tests"
    if "hosts" in parts or "serving" in parts:
        return "/".join(parts[:-1])
    if parts[0] == "generated":
        return "runtime/core"
    return "/".join(parts[:2]) if parts[0] == "runtime" else parts[0]


def private_headers() -> dict[str, set[str]]:
    """The libraries that have a private header with this name, by what an #include says."""
    found: dict[str, set[str]] = {}
    for library in LIBRARIES:
        for header in library.rglob("*.hpp"):
            if match := PRIVATE.fullmatch(header.relative_to(library).as_posix()):
                found.setdefault(match[match.lastindex or 0], set()).add(library_of(header))
    return found


def test_libraries_use_doors() -> None:
    private = private_headers()
    assert private["sbgc/detail/reader.hpp"] == {"runtime/core"}
    assert private["device/device.hpp"] == {"emulator"}
    wrong = []
    for file in (file for folder in FOLDERS for file in (ROOT / folder).rglob("*.[hc]pp")):
        library = library_of(file)
        for kind, name in re.findall(
            r'^#include ([<"])(.+)[>"]', file.read_text("utf-8"), re.MULTILINE
        ):
            owners = private.get(name, {library})
            # Tests get parts of a library by its target sbgc_..._internal.
            if not (
                library in owners
                or (library == "tests" and kind == '"')
                or (file.parent / name).exists()
            ):
                wrong.append(f"{file.relative_to(ROOT)} includes {name} of {', '.join(owners)}")
    assert not wrong, "\n".join(wrong)


def test_folders_form_no_circle() -> None:
    tools = ROOT / "tools"
    uses: dict[str, set[str]] = {}
    for file in tools.glob("**/*.?pp"):
        folder = file.relative_to(tools).parts[0]
        used = re.findall(r'^#include "(\w+)/', file.read_text("utf-8"), re.MULTILINE)
        uses.setdefault(folder, set()).update(set(used) - {folder})
    assert "board" in uses["parameters"], "the includes are found"
    TopologicalSorter(uses).prepare()  # raises an error that names a circle
