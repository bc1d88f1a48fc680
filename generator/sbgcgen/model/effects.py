"""The effects of requests on the board."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sbgcgen.model.bodies import Type
from sbgcgen.model.conditions import Condition


@dataclass(frozen=True)
class EffectKind:
    """A possible effect of a request. It may cause `motion`, or the loss of `data` or of the `line`."""

    word: str
    summary: str
    risk: str = ""


# The effects of every protocol: none, and unknown.
READS = EffectKind("reads", "Reads: changes nothing.")
UNKNOWN = EffectKind("unknown", "Unknown: the specification does not describe the command.")
# The effects of a protocol that does not define others, the most harmless first.
USUAL_EFFECTS: tuple[EffectKind, ...] = (
    READS,
    EffectKind("sets", "Sets temporarily: a restart of the board discards the change."),
    EffectKind("stores", "Writes memory: the change survives a power cycle."),
    EffectKind("moves", "Moves: the camera can move, or the motors gain or lose power.", "motion"),
    EffectKind(
        "restarts",
        "Restarts the board: the motors lose power until it is up again.",
        "motion",
    ),
    EffectKind("erases", "Erases stored data.", "data"),
    EffectKind(
        "disconnects",
        "Disconnects: the line no longer carries the protocol; how to end that is unknown.",
        "line",
    ),
    UNKNOWN,
)


@dataclass(frozen=True)
class EffectCase:
    """The effect of a request for which `when` holds."""

    when: Condition | None
    words: tuple[str, ...]


@dataclass(frozen=True)
class Effect:
    """The effect of a request: the first matching case. The last case always matches."""

    cases: tuple[EffectCase, ...]
    known: tuple[EffectKind, ...] = USUAL_EFFECTS

    @property
    def words(self) -> tuple[str, ...]:
        """The effects of all cases; "reads" only if there is no other."""
        said = {word for case in self.cases for word in case.words}
        if len(said) > 1:
            said.discard(READS.word)
        return tuple(kind.word for kind in self.known if kind.word in said)

    @property
    def is_dangerous(self) -> bool:
        """True if a request can set something in motion, so readers need a warning."""
        return any(kind.risk == "motion" and kind.word in self.words for kind in self.known)

    def having(self, words: Sequence[str]) -> tuple[bool, tuple[Condition, ...]]:
        """Return whether a request has one of these effects, and the conditions for the opposite.

        The conditions of cases do not overlap, see SBGC062.
        """
        has = [not set(words).isdisjoint(case.words) for case in self.cases]
        unless = (case.when for case, one in zip(self.cases, has) if one != has[-1])
        return has[-1], tuple(when for when in unless if when)


@dataclass(frozen=True)
class StopValue:
    """A raw value of a request that stops all motion; of a packed value, the bits in `mask`."""

    path: str
    type: Type
    value: Any
    mask: int = 0
    may_be_missing: bool = False


# The values with which a request stops all motion; without any, it always does.
StopPattern = tuple[StopValue, ...]
