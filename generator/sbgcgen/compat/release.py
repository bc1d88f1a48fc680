"""The model and the last release: the version that changes require (semantic versioning, see CONTRIBUTING.md),
the recorded model, the `compat` command without a revision, and `record`."""

from __future__ import annotations

import enum
import json
import lzma
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple, Optional

from sbgcgen import library
from sbgcgen.compat.changes import Change, Level
from sbgcgen.compat.severities import compare
from sbgcgen.compat.dump import dump
from sbgcgen.compat.reading import restore
from sbgcgen.compat.report import print_changes
from sbgcgen.compat.revision import Version as Source
from sbgcgen.model import Layout
from sbgcgen.model.export import export
from sbgcgen.targets import targets


class Version(NamedTuple):
    """A version of three numbers, compared in this order."""

    major: int
    minor: int
    patch: int

    def __str__(self) -> str:
        return ".".join(map(str, self))


def parse(text: str) -> Version:
    """The version written as 1.2.3. Raises ValueError for other texts."""
    major, minor, patch = map(int, text.split("."))
    return Version(major, minor, patch)


class Step(enum.Enum):
    """The consequences of changes since a release for its users, the worst first."""

    BREAK = "break"
    ADDITION = "extend"
    PROSE = "do not affect"


# The number of the version that a step increments, before version 1.0.0 and afterwards.
_INCREASES: dict[Step, tuple[Optional[str], Optional[str]]] = {
    Step.BREAK: ("minor", "major"),
    Step.ADDITION: ("patch", "minor"),
    Step.PROSE: (None, None),
}


def step_of(changes: Iterable[Change], same_fingerprint: bool) -> Step:
    """The step that changes of the model require; if the fingerprint is unchanged, only prose differs."""
    if any(change.level is not Level.COMPATIBLE for change in changes):
        return Step.BREAK
    return Step.PROSE if same_fingerprint else Step.ADDITION


def lowest_version(released: Version, step: Step) -> Version:
    """The lowest version that may follow a release with these changes."""
    part = _INCREASES[step][released.major > 0]
    if part is None:
        return released
    kept = Version._fields.index(part)
    numbers = [*released[:kept], released[kept] + 1, 0, 0]
    return Version(*numbers[:3])


# In the format of dump.py, because the YAML of a release may use an earlier language, and a source archive has
# no revisions.
NAME = "released.json.xz"


@dataclass(frozen=True)
class Release:
    """A release: its version, and the model with its fingerprint at that time."""

    version: Version
    fingerprint: str
    layout: Layout


def fingerprint_of(layout: Layout) -> str:
    return str(export(layout)["fingerprint"])


def write(release: Release, path: Path) -> None:
    content = {
        "version": str(release.version),
        "fingerprint": release.fingerprint,
        "objects": dump(release.layout),
    }
    path.write_bytes(lzma.compress(json.dumps(content, separators=(",", ":")).encode()))


def read(path: Path) -> Release:
    content = json.loads(lzma.decompress(path.read_bytes()))
    return Release(parse(content["version"]), content["fingerprint"], restore(content["objects"]))


def check(layout: Layout, project: Path, spec_dir: Path) -> int:
    """List the changes since the last release; returns 1 if the version is too low for them."""
    path = spec_dir / NAME
    if not path.is_file():
        print("no release is recorded: nothing to compare")
        return 0
    last = read(path)
    changes = compare(last.layout, layout)
    old = Source(spec_dir, f"{last.version}:{spec_dir.name}/")
    print_changes(changes, old, Source(spec_dir, f"{spec_dir.name}/"))
    fingerprint = fingerprint_of(layout)
    if fingerprint != last.fingerprint:
        print(f"fingerprint: {last.fingerprint} → {fingerprint}")
    step = step_of(changes, fingerprint == last.fingerprint)
    version, lowest = parse(library.version(project)), lowest_version(last.version, step)
    if version >= lowest:
        return 0
    print(
        f"The changes since the release of {last.version} {step.value} what its users rely on, but "
        f"the version is {version}.\nSet it to {lowest} or higher in {library.VERSION_HEADER} and describe "
        "the changes in CHANGELOG.md, or undo them.",
        file=sys.stderr,
    )
    return 1


def record(layout: Layout, project: Path, spec_dir: Path) -> int:
    """Record the model as that of the release of this version; returns 1 if the version is too low.

    A recorded release is not replaced by another model of the same version.
    """
    if (status := check(layout, project, spec_dir)) != 0:
        return status
    path, version = spec_dir / NAME, parse(library.version(project))
    if path.is_file() and read(path).version == version:
        return 0
    write(Release(version, fingerprint_of(layout), layout), path)
    print(f"{spec_dir.name}/{NAME} is now the model of {version}")
    for target in targets():
        target.record(layout, project, str(version))
    return 0
