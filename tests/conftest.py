"""Tests marked `long` take minutes: they run only with `./dev test --long`, which sets SBGC_LONG. Programs on
pseudo-terminals see a capable terminal, whatever that of the tests can do."""

from __future__ import annotations

import os

import pytest


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "long: runs only with ./dev test --long")
    os.environ["TERM"] = "xterm"


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if "SBGC_LONG" in os.environ:
        return
    long = [item for item in items if item.get_closest_marker("long")]
    config.hook.pytest_deselected(items=long)
    items[:] = [item for item in items if item not in long]
