"""The single header, as the only file of the library in a program."""

from __future__ import annotations

from pathlib import Path

import pytest

from compilers import BARE, HERE, HOSTS, STRICT, generate, run

SOURCES = [HERE / "single_header" / name for name in ("main.cpp", "ask.cpp")]


@pytest.fixture(name="header", scope="module")
def single_header(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return generate("single-header", tmp_path_factory.mktemp("single"))


@pytest.mark.parametrize("compiler", HOSTS)
def test_two_files_of_a_program(compiler: str, header: Path, tmp_path: Path) -> None:
    options = ["-std=c++20", *STRICT, f"-I{header.parent}"]
    run(compiler, *options, *SOURCES, "-o", tmp_path / "program")
    assert run(tmp_path / "program") == "the board has answered\n"


@pytest.mark.parametrize("compiler", HOSTS)
def test_freestanding(compiler: str, header: Path, tmp_path: Path) -> None:
    options = ["-std=c++20", *BARE, *STRICT, f"-I{header.parent}"]
    run(compiler, *options, "-c", SOURCES[1], "-o", tmp_path / "ask.o")


def test_it_is_one_header_with_license(header: Path, tmp_path: Path) -> None:
    text = header.read_text(encoding="utf-8")
    assert text.count("#pragma once") == 1
    assert "#include <sbgc/" not in text
    assert "// MIT License\n" in text.partition("#pragma once")[0]
    assert generate("single-header", tmp_path).read_text(encoding="utf-8") == text
