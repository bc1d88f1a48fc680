"""Semantic versioning: the version that changes of the model require. See CONTRIBUTING.md."""

from __future__ import annotations

import enum
from collections.abc import Iterable
from typing import NamedTuple, Optional

from sbgcgen.compat.changes import Change, Level


class Version(NamedTuple):
    """A version of three numbers, which compare in this order."""

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


# The number of the version that a step increases, before version 1.0.0 and from then on.
_INCREASES: dict[Step, tuple[Optional[str], Optional[str]]] = {
    Step.BREAK: ("minor", "major"),
    Step.ADDITION: ("patch", "minor"),
    Step.PROSE: (None, None),
}


def step_of(changes: Iterable[Change], same_fingerprint: bool) -> Step:
    """The step that changes of the model make; those that keep its fingerprint change prose only."""
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
