"""Renders the site once for all tests."""

from __future__ import annotations

import gc
import sys
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "generator"))
sys.path.append(str(PROJECT / "tests/random_schemas"))

from sbgcgen.build import load_protocol  # noqa: E402
from sbgcgen.model import Layout  # noqa: E402
from sbgcgen.targets import target  # noqa: E402

from pages import Page, read  # noqa: E402

# The tests hold all pages in memory, whose elements refer to each other. Searching them for cycles at the
# default rate takes long.
gc.set_threshold(200_000, 20, 50)


LAYOUT = load_protocol(PROJECT / "spec").layout


@pytest.fixture(scope="session")
def layout() -> Layout:
    return LAYOUT


@pytest.fixture(scope="session")
def files(layout: Layout) -> dict[str, bytes]:
    """All files of the site by path."""
    return dict(target("site").files(layout, PROJECT))


@pytest.fixture(scope="session")
def pages(files: dict[str, bytes]) -> dict[str, Page]:
    """All pages by path."""
    return {
        path: read(path, content.decode())
        for path, content in files.items()
        if path.endswith(".html")
    }
