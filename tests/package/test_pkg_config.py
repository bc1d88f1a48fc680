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


@pytest.mark.parametrize(
    "package, source",
    [
        ("sbgc-json", "json.cpp"),
        ("sbgc-emulator", "emulator.cpp"),
        ("sbgc-client", "client.cpp"),
    ],
)
def test_a_program_with_its_flags(package: str, source: str, moved: Path, tmp_path: Path) -> None:
    (folder,) = moved.rglob("pkgconfig")
    flags = run("pkg-config", "--cflags", "--libs", package, PKG_CONFIG_PATH=str(folder))
    assert str(PREFIX) not in flags
    program = tmp_path / "program"
    text = HERE / "consumer" / source
    run(HOSTS[-1], "-std=c++20", text, *shlex.split(flags), "-o", program)
    run(program)
