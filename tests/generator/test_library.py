"""Tests of the library's headers as files: what follows from their #include lines."""

from __future__ import annotations

from pathlib import Path

import pytest

from sbgcgen import library
from support import PROJECT


def write_headers(project: Path, **texts: str) -> None:
    folder = project / "runtime/core/include/sbgc"
    folder.mkdir(parents=True)
    for name, text in texts.items():
        (folder / f"{name}.hpp").write_text(text, encoding="utf-8")


def names(project: Path, *entries: str) -> list[str]:
    return [part.header for part in library.parts(project, entries)]


def test_a_header_comes_after_those_that_it_includes(tmp_path: Path) -> None:
    write_headers(
        tmp_path,
        a="#include <sbgc/b.hpp>\n#include <sbgc/c.hpp>\n",
        b="#include <sbgc/c.hpp>\n",
        c="int c;\n",
        unused="int unused;\n",
    )
    assert names(tmp_path, "sbgc/a.hpp") == ["sbgc/c.hpp", "sbgc/b.hpp", "sbgc/a.hpp"]
    assert names(tmp_path, "sbgc/b.hpp", "sbgc/a.hpp") == ["sbgc/c.hpp", "sbgc/b.hpp", "sbgc/a.hpp"]


def test_only_includes_without_conditions_are_collected(tmp_path: Path) -> None:
    write_headers(
        tmp_path,
        a="// Generated from spec/\n\n/// About a.\n#pragma once\n\n#include <array>\n"
        "#if defined(__SSE2__)\n#include <emmintrin.h>\n#include <sbgc/b.hpp>\n#endif\n"
        "# include <span>\nint a;\n",
        b="int b;\n",
    )
    b, a = library.parts(tmp_path, ["sbgc/a.hpp"])
    assert (b.header, a.header, a.standard) == ("sbgc/b.hpp", "sbgc/a.hpp", ["array", "span"])
    assert a.body == (
        "/// About a.\n\n#if defined(__SSE2__)\n#include <emmintrin.h>\n#endif\nint a;\n"
    )


def test_a_header_that_is_included_after_code_comes_there(tmp_path: Path) -> None:
    write_headers(
        tmp_path,
        a="/// About a.\n#pragma once\n#include <sbgc/c.hpp>\nint a;\n#include <sbgc/b.hpp>\nint z;\n",
        b="#include <sbgc/a.hpp>\nint b = a;\n",
        c="int c;\n",
    )
    bodies = [part.body for part in library.parts(tmp_path, ["sbgc/a.hpp"])]
    assert bodies == ["int c;\n", "/// About a.\nint a;\n", "int b = a;\n", "int z;\n"]
    assert library.headers(tmp_path, ["sbgc/a.hpp"]) == ["sbgc/a.hpp", "sbgc/b.hpp", "sbgc/c.hpp"]


def test_a_header_of_another_layer_is_an_error(tmp_path: Path) -> None:
    write_headers(tmp_path, a="#include <sbgc/io/open.hpp>\n")
    with pytest.raises(ValueError, match="sbgc/io/open.hpp is not a header of core"):
        library.headers(tmp_path, ["sbgc/a.hpp"])


def test_the_version_is_that_of_its_header(tmp_path: Path) -> None:
    header = tmp_path / library.VERSION_HEADER
    header.parent.mkdir(parents=True)
    numbers = (("MAJOR", 12), ("MINOR", 3), ("PATCH", 4))
    header.write_text("".join(f"#define SBGC_VERSION_{part} {n}\n" for part, n in numbers))
    assert library.version(tmp_path) == "12.3.4"
    header.write_text("#define SBGC_VERSION_MAJOR 12\n")
    with pytest.raises(ValueError, match="defines no version"):
        library.version(tmp_path)


def test_headers_of_the_project() -> None:
    found = names(PROJECT, *library.ENTRIES)
    assert set(library.ENTRIES) < set(found) and len(found) == len(set(found))
    tables = names(PROJECT, *library.ENTRIES, *library.TABLES)
    assert {"sbgc/meta/enums.hpp", "sbgc/field_path.hpp"} <= set(tables) - set(found)
