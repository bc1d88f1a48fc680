"""What a request does to the board."""

from __future__ import annotations

from dataclasses import dataclass

from sbgcgen.model.bodies import Condition

# Every word of the spec language, the harmless first, with what it means to people.
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
    """What a request does, if `when` holds for it."""

    when: Condition | None
    words: tuple[str, ...]


@dataclass(frozen=True)
class Effect:
    """What a request does: the first case that holds; the last one always does."""

    cases: tuple[EffectCase, ...]

    @property
    def words(self) -> tuple[str, ...]:
        """Whatever any case does; that one of them changes nothing is left out."""
        said = {word for case in self.cases for word in case.words}
        if len(said) > 1:
            said.discard("reads")
        return tuple(word for word in EFFECTS if word in said)
