"""The model of the last release, which is committed: spec/released.json.xz.

It is the model in the form of dump.py, because the YAML of a release may be in an earlier language, and
a source archive has no revisions.
"""

from __future__ import annotations

import json
import lzma
from dataclasses import dataclass
from pathlib import Path

from sbgcgen.compat.dump import dump
from sbgcgen.compat.reading import restore
from sbgcgen.compat.semver import Version, parse
from sbgcgen.model import Layout
from sbgcgen.model.export import export

NAME = "released.json.xz"


@dataclass(frozen=True)
class Release:
    """A release: its version, and the model with the fingerprint that it had at that time."""

    version: Version
    fingerprint: str
    layout: Layout


def fingerprint_of(layout: Layout) -> str:
    """The fingerprint of a model."""
    return str(export(layout)["fingerprint"])


def write(release: Release, path: Path) -> None:
    """Write a release to a file."""
    content = {
        "version": str(release.version),
        "fingerprint": release.fingerprint,
        "objects": dump(release.layout),
    }
    path.write_bytes(lzma.compress(json.dumps(content, separators=(",", ":")).encode()))


def read(path: Path) -> Release:
    """Read a release from a file."""
    content = json.loads(lzma.decompress(path.read_bytes()))
    return Release(parse(content["version"]), content["fingerprint"], restore(content["objects"]))
