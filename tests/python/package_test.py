"""The package as a whole: what importing it takes, and its description."""

from __future__ import annotations

import importlib
import os
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
