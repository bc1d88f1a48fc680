"""pkg-config: the flags that it prints are all that a compiler needs.

Every package requires `sbgc`, and `sbgc-client` requires `sbgc-io`.
"""

from __future__ import annotations

import os
import shlex
import shutil
from pathlib import Path

import pytest

from compilers import HERE, HOSTS, PREFIX, run


@pytest.fixture(name="moved", scope="module")
def moved_prefix(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The installed files in another folder than the one for which they were installed."""
    folder = tmp_path_factory.mktemp("moved") / "a folder"
    shutil.copytree(PREFIX, folder, copy_function=os.link)
    return folder


def build(compiler: str, package: str, source: str, moved: Path, *options: str) -> Path:
    """Compiles a program with the flags that pkg-config prints."""
    (folder,) = moved.rglob("pkgconfig")
    flags = run("pkg-config", "--cflags", "--libs", package, PKG_CONFIG_PATH=str(folder))
    assert str(PREFIX) not in flags
    program = moved.parent / f"{source}-{compiler}"
    text = HERE / "consumer" / source
    run(compiler, "-std=c++20", *options, text, *shlex.split(flags), "-o", program)
    return program


@pytest.mark.parametrize(
    "package, source",
    [
        ("sbgc-json", "json.cpp"),
        ("sbgc-any", "any.cpp"),
        ("sbgc-tasks", "tasks.cpp"),
        ("sbgc-analysis", "analysis.cpp"),
        ("sbgc-doctor", "doctor.cpp"),
        ("sbgc-emulator", "emulator.cpp"),
        ("sbgc-client", "client.cpp"),
    ],
)
def test_a_program_with_its_flags(package: str, source: str, moved: Path) -> None:
    run(build(HOSTS[-1], package, source, moved))


def test_asynchronous_functions_with_all_completion_tokens(moved: Path) -> None:
    """With g++ 12, which mishandles temporaries in co_await expressions."""
    run(build("g++", "sbgc-client", "tokens.cpp", moved, "-fsanitize=address"))
