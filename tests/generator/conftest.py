"""Makes the generator importable if pytest is started without generator/python; isolates git."""

from __future__ import annotations

import gc
import os
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "generator"))

# The tests hold whole specs in memory. Searching them for cycles at the default rate takes a quarter of
# the time.
gc.set_threshold(200_000, 20, 50)


@pytest.fixture(autouse=True)
def git_as_it_comes(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ignores the user's git settings, and the repository of a hook that runs the tests."""
    for name in list(os.environ):
        if name.startswith("GIT_"):
            monkeypatch.delenv(name)
    monkeypatch.setenv("GIT_CONFIG_GLOBAL", os.devnull)
    monkeypatch.setenv("GIT_CONFIG_SYSTEM", os.devnull)
