"""Rules for the effects of requests, applied if there are no other findings."""

from __future__ import annotations

from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.model import READS, UNKNOWN, Effect, Layout, Message


def lint_effects(layout: Layout, found: Diagnostics) -> None:
    """Check the effect of every message; findings go into `found`."""
    undocumented = {command.name for command in layout.commands if command.undocumented}
    for message in layout.messages:
        text, hint = "", ""
        if message.direction == "from_board":
            if message.preparation:
                text = (
                    f"nothing needs to be prepared for {message.name}, which comes from the board"
                )
                hint = "'preparation' belongs to 'to_board'"
            elif message.stops:
                text = f"{message.name} comes from the board, so it stops no motion"
                hint = "'stops' belongs to 'to_board'"
            elif message.effect is not None:
                text = f"{message.name} comes from the board, so it has no effect on it"
                hint = "'effect' belongs to 'to_board'"
        elif message.effect is None:
            text = f"{message.name} does not state its effect on the board"
            hint = f"say 'effect:' with one or more of: {', '.join(kind.word for kind in layout.effects)}"
        else:
            text, hint = _problem(message, message.effect, message.command in undocumented)
        if text:
            found.add(message.at, "SBGC062", text, hint)


def _problem(message: Message, effect: Effect, is_undocumented: bool) -> tuple[str, str]:
    """The problem of an effect and a hint; two empty texts if there is none."""
    for index, case in enumerate(effect.cases):
        is_last = index == len(effect.cases) - 1
        if is_last and case.when is not None:
            text = f"the last case of the effect of {message.name} has a condition"
            return text, "the last case applies if no other does"
        if not is_last and case.when is None:
            text = f"a case of the effect of {message.name} has no condition"
            return text, "every case but the last needs a 'when'"
        for word in (READS.word, UNKNOWN.word):
            if word in case.words and len(case.words) > 1:
                text = f"{message.name} combines '{word}' with another effect"
                return text, f"'{word}' excludes all others"
    if _overlap(effect):
        text = f"cases of the effect of {message.name} overlap"
        return text, "several cases need different values of one field"
    if message.stops and not effect.is_dangerous:
        text = f"{message.name} stops all motion, but its effect has no 'risk: motion'"
        return text, "what stops the motors moves them"
    if UNKNOWN.word in effect.words and not is_undocumented:
        text = f"{message.name} is described, so its effect is known"
        return text, "'unknown' is for commands with 'undocumented: true'"
    return "", ""


def _overlap(effect: Effect) -> bool:
    """True if the conditions of two cases may hold for the same request."""
    conditions = [case.when for case in effect.cases if case.when]
    if len(conditions) < 2:
        return False
    numbers = [number for when in conditions for number in when.numbers]
    are_values = all(when.is_on_values for when in conditions)
    is_one_field = len({when.subject for when in conditions}) == 1
    return not (are_values and is_one_field and len(numbers) == len(set(numbers)))
