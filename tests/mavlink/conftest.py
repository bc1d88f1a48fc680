"""Finds pymavlink, which ./dev installs in peers/; without it, there is nothing to test."""

from __future__ import annotations

import os
import site
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

for folder in Path(__file__).parents[2].glob("build/venv/lib/python3*/site-packages"):
    site.addsitedir(str(folder))
    os.environ["PYTHONPATH"] = f"{os.environ.get('PYTHONPATH', '')}:{folder}"  # of the program
collect_ignore_glob = [] if find_spec("pymavlink") else ["*_test.py"]


def pytest_report_header() -> str:
    return "skipped: pymavlink is missing" if collect_ignore_glob else ""


@pytest.fixture
def rig() -> Iterator[Any]:
    from drone import started

    with started() as made:
        yield made


@pytest.fixture
def autopilot(rig: Any) -> Any:
    return rig.autopilot


@pytest.fixture
def gimbal(rig: Any) -> Any:
    return rig.gimbal
