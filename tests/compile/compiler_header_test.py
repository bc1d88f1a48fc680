"""What is peculiar to a compiler or processor is in one header, sbgc/internal/compiler.hpp."""

from __future__ import annotations

import re

import pytest

from compiler import ROOT

HEADER = "runtime/core/include/sbgc/internal/compiler.hpp"
PECULIAR = re.compile(
    r"__builtin|__attribute__|__restrict|\b(?:gnu|clang|msvc)::"
    r"|__(?:GNUC|clang|SSE|x86_64|arm|aarch64|BYTE_ORDER)|_MSC_VER|_WIN32|#pragma (?!once)"
)
# The modules of the site are compiled by one compiler, and export functions to JavaScript.
FREE = {HEADER, "web/modules/exchange.hpp"}


def peculiar_lines(path: str) -> list[str]:
    lines = (ROOT / path).read_text(encoding="utf-8").splitlines()
    # A name that is deprecated is used in the headers themselves.
    lines = [line for line in lines if not line.startswith("#pragma GCC diagnostic ")]
    return [line for line in lines if PECULIAR.search(line.split("//")[0])]


@pytest.mark.parametrize("folder", ["runtime", "generated/include", "emulator", "tools"])
def test_other_files_are_standard_cpp(folder: str) -> None:
    files = [p.relative_to(ROOT).as_posix() for p in (ROOT / folder).rglob("*.[ch]pp")]
    assert files
    found = {path: peculiar_lines(path) for path in files if path not in FREE}
    assert {path: lines for path, lines in found.items() if lines} == {}


def test_the_header_has_them() -> None:
    assert len(peculiar_lines(HEADER)) > 5
