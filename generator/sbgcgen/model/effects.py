"""What a request does to the board."""

from __future__ import annotations

from dataclasses import dataclass

from sbgcgen.model.bodies import Condition

# Every word of the spec language, the harmless first, with what it means to people.
EFFECTS: dict[str, str] = {
    "reads": "Reads: it changes nothing.",
    "sets": "Sets for now: what it changes is lost when the board restarts.",
    "stores": "Writes memory: what it changes lasts when the power is off.",
    "moves": "Moves: the camera can move, or the motors gain or lose power.",
    "restarts": "Restarts the board: the motors lose power until it is up again.",
    "erases": "Erases what is stored.",
    "unknown": "Not known: the specification only names the command.",
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
