"""The package as a whole: what importing it takes, its description, and its types. Pyright finds no errors in it
and in its users, which these tests are; ./dev check types runs mypy."""

from __future__ import annotations

import importlib
import json
import os
import shutil
import subprocess
import sys
from importlib.metadata import metadata
from pathlib import Path

import pytest

import sbgc


sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))

IMPORTS = """
import sys
import sbgc
assert not {"asyncio", "numpy", "importlib.metadata"} & sys.modules.keys()
assert sbgc.aio.connect and "asyncio" in sys.modules
assert not hasattr(sbgc, "aoi")
"""


def test_asyncio_is_imported_when_it_is_used() -> None:
    subprocess.run([sys.executable, "-W", "error", "-c", IMPORTS], check=True)


def test_the_package_describes_itself() -> None:
    described = metadata("sbgc")
    assert sbgc.__version__ == described["Version"]
    assert described.get_all("Provides-Extra") == ["mavlink", "numpy", "pandas"]
    assert 'pandas; extra == "pandas"' in (described.get_all("Requires-Dist") or [])
    text = described.get_payload()  # type: ignore[attr-defined]
    assert isinstance(text, str) and text.startswith("# sbgc\n")


def test_the_installation_is_described_as_by_the_command() -> None:
    def said(*command: str) -> str:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout

    assert said(sys.executable, "-m", "sbgc").startswith(said(os.environ["SBGC"], "--version"))


def test_each_missing_package_is_named_before_compiling(monkeypatch: pytest.MonkeyPatch) -> None:
    backend = importlib.import_module("build_backend")
    assert backend.missing_packages() == []
    monkeypatch.setitem(backend.HEADERS, "some-dev", "some/header.h")
    monkeypatch.setenv("PATH", "/usr/bin")
    monkeypatch.setitem(backend.PROGRAMS, "builder", "no-such-program")
    with pytest.raises(SystemExit, match="apt-get install builder some-dev"):
        backend.build_wheel("")


HERE = Path(__file__).resolve().parent
PYRIGHT = HERE.parent / "site" / "node_modules" / "pyright" / "index.js"
NODE = shutil.which("node")


@pytest.mark.long
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
