"""The package and its users, which these tests are, have no errors for pyright; ./dev check types runs mypy."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import sbgc

HERE = Path(__file__).resolve().parent
PYRIGHT = HERE.parent / "site" / "node_modules" / "pyright" / "index.js"
NODE = shutil.which("node")


@pytest.mark.skipif(NODE is None or not PYRIGHT.exists(), reason="./dev test debug installs it")
def test_pyright_finds_nothing(tmp_path: Path) -> None:
    # Folders of a project, because it does not check those of libraries.
    (tmp_path / "sbgc").symlink_to(Path(sbgc.__file__).parent)
    (tmp_path / "tests").symlink_to(HERE)
    paths = [
        ".",
        "tests",
        *(str(HERE.parents[1] / name) for name in ("examples/python", "generator")),
    ]
    settings = {
        "include": ["sbgc", "tests"],
        "extraPaths": paths,
        "pythonVersion": "3.11",
    }
    (tmp_path / "pyrightconfig.json").write_text(json.dumps(settings))
    command = [str(NODE), str(PYRIGHT), "--warnings", "--pythonpath", sys.executable]
    without = {name: value for name, value in os.environ.items() if name != "LD_PRELOAD"}
    done = subprocess.run(
        command, cwd=tmp_path, env=without, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0 and "0 errors" in done.stdout, done.stdout
