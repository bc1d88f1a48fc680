"""A compiler that reads the headers of many small programs once."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
INCLUDES = [*ROOT.glob("runtime/*/include"), ROOT / "generated/include"]
COMPILERS = [name for name in ("g++", "clang++") if shutil.which(name)]
# For tests that compile much, or many programs: compilers seldom differ in them, and only the long run has both.
LAST_COMPILER = [
    pytest.param(name, marks=[] if name == COMPILERS[-1] else [pytest.mark.long])
    for name in COMPILERS
]


def cross_compilers() -> dict[str, list[str]]:
    """The commands of the compilers for microcontrollers, with the flags of the example's toolchain file."""
    toolchain = (ROOT / "examples/cortex-m/toolchain.cmake").read_text(encoding="utf-8")
    (name,) = re.findall(r"set\(CMAKE_CXX_COMPILER (.*)\)", toolchain)
    flags = dict(re.findall(r'set\(flags_(\w+) "(.*)"\)', toolchain))
    assert {"m0plus", "m4f", "m7"} <= flags.keys()
    if not shutil.which(name):
        return {}
    return {core: [name, "-mthumb", *flags[core].split()] for core in flags}


class Compiler:
    """Checks source text that follows `head`, with warnings, without writing anything."""

    def __init__(self, name: str, head: str, folder: Path, options: Sequence[str] = ()) -> None:
        header = folder / "head.hpp"
        header.write_text(head, encoding="utf-8")
        is_clang = name == "clang++"
        flags = ["-std=c++20", "-Wall", "-Wextra", *(f"-I{path}" for path in INCLUDES)]
        flags += [*options, *(["-fno-color-diagnostics"] if is_clang else [])]
        compiled = header.with_suffix(".hpp.pch" if is_clang else ".hpp.gch")
        subprocess.run([name, *flags, "-x", "c++-header", header, "-o", compiled], check=True)
        included = ["-include-pch", str(compiled)] if is_clang else ["-include", str(header)]
        self.command = [name, *flags, *included, "-fsyntax-only", "-x", "c++", "-"]

    def compile(self, source: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            self.command, input=source, capture_output=True, text=True, check=False
        )
