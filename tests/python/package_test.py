"""The package as a whole: what importing it takes, and its description."""

from __future__ import annotations

import subprocess
import sys
from importlib.metadata import metadata

import sbgc

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
    assert described.get_all("Provides-Extra") == ["numpy", "pandas"]
    assert 'pandas; extra == "pandas"' in (described.get_all("Requires-Dist") or [])
    text = described.get_payload()  # type: ignore[attr-defined]
    assert isinstance(text, str) and text.startswith("# sbgc\n")
