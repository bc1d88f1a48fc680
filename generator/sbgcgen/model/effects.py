"""The effects of requests on the board."""

from __future__ import annotations

from dataclasses import dataclass

from sbgcgen.model.bodies import Condition

# Every effect of the spec language, the most harmless first, with its description.
EFFECTS: dict[str, str] = {
    "reads": "Reads: changes nothing.",
    "sets": "Sets temporarily: a restart of the board discards the change.",
    "stores": "Writes memory: the change survives a power cycle.",
    "moves": "Moves: the camera can move, or the motors gain or lose power.",
    "restarts": "Restarts the board: the motors lose power until it is up again.",
    "erases": "Erases stored data.",
    "unknown": "Unknown: the specification does not describe the command.",
}


@dataclass(frozen=True)
class EffectCase:
    """The effect of a request for which `when` holds."""

    when: Condition | None
    words: tuple[str, ...]


@dataclass(frozen=True)
class Effect:
    """The effect of a request: the first case that holds. The last case always holds."""

    cases: tuple[EffectCase, ...]

    @property
    def words(self) -> tuple[str, ...]:
        """The effects of all cases; "reads" only if there is no other."""
        said = {word for case in self.cases for word in case.words}
        if len(said) > 1:
            said.discard("reads")
        return tuple(word for word in EFFECTS if word in said)
