"""The `compat` command without a revision, and `record`: the model and the last release."""

from __future__ import annotations

import sys
from pathlib import Path

from sbgcgen import library
from sbgcgen.compat.compare import compare
from sbgcgen.compat.released import NAME, Release, fingerprint_of, read, write
from sbgcgen.compat.report import print_changes
from sbgcgen.compat.revision import Version as Source
from sbgcgen.compat.semver import lowest_version, parse, step_of
from sbgcgen.model import Layout
from sbgcgen.targets import targets


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
