"""The command is built with the options of sbgcHardening.cmake."""

from __future__ import annotations

import os
import re
import subprocess

from sbgc_command import PROGRAM


def readelf(*options: str) -> str:
    return subprocess.run(
        ["readelf", "--wide", *options, PROGRAM], capture_output=True, text=True, check=True
    ).stdout


def test_the_linker_protects_it() -> None:
    assert re.search(r"Type:\s+DYN \(Position-Independent Executable", readelf("--file-header"))
    segments = readelf("--program-headers")
    assert "GNU_RELRO" in segments
    assert re.search(r"GNU_STACK .* RW +0", segments)
    assert re.search(r"FLAGS_1.* NOW", readelf("--dynamic"))


def test_the_compiler_protects_it() -> None:
    names = readelf("--dyn-syms")
    assert "__stack_chk_fail" in names
    is_checked = re.search(r" __(memcpy|vsnprintf|read|longjmp|poll|fprintf|memset)_chk\b", names)
    # Sanitizers bring such functions with them.
    assert is_checked or os.environ["SBGC_FORTIFIED"] != "1"
