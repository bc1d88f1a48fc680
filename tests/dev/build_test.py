"""The build on a machine without a compiler cache, which reuses precompiled headers."""

from __future__ import annotations

import json
import re
import shlex
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
# Flags that clang++ compares with those of a precompiled header.
COMPARED = re.compile(r"-std=|-fstack-|-fvalidate-|-fPIC|-fno-|-fsanitize|-m|-pthread|-D_GLIBCXX")


@pytest.mark.skipif(not shutil.which("clang++"), reason="needs clang++")
def test_flags_are_those_of_the_headers(tmp_path: Path) -> None:
    options = ["-DSBGC_BUILD_TESTS=ON", "-DSBGC_CCACHE=", "-DCMAKE_CXX_COMPILER_LAUNCHER="]
    subprocess.run(
        ["cmake", "--preset", "debug", "-B", str(tmp_path), *options],
        cwd=ROOT,
        check=True,
        capture_output=True,
    )
    flags: dict[str, dict[str, set[str]]] = {}
    for entry in json.loads((tmp_path / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        found = [Path(word).parent.name for word in words if word.endswith("cmake_pch.hxx.pch")]
        header = found[0] if found else Path(entry["file"]).parent.name
        if found or entry["file"].endswith("cmake_pch.hxx.cxx"):
            compared = {word for word in words if COMPARED.match(word)}
            flags.setdefault(header, {})[entry["file"]] = compared
    assert len(flags) == 2 and all(len(files) > 5 for files in flags.values())
    for header, files in flags.items():
        (own,) = [found for file, found in files.items() if file.endswith("cmake_pch.hxx.cxx")]
        assert "-fvalidate-ast-input-files-content" in own  # headers of packages may be upgraded
        assert {file: found for file, found in files.items() if found != own} == {}, header
