"""Finds the requests that a message answers."""

from __future__ import annotations

from sbgcgen.model import Layout, Message


def confirmation(layout: Layout) -> Message | None:
    """The confirmation message; None if the protocol has none."""
    return next(iter(layout.having_role("confirmation")), None)


def asked_by(layout: Layout) -> dict[str, list[Message]]:
    """The requests that each message answers or confirms, by the message's name."""
    found: dict[str, list[Message]] = {}
    for message in layout.messages:
        if message.answer is None:
            continue
        series = {case.series for case in message.answer.cases if case.series}
        for name in (*message.answer.messages, *sorted(series)):
            found.setdefault(name, []).append(message)
        if message.answer.confirm != "never":
            for confirming in layout.having_role("confirmation"):
                found.setdefault(confirming.name, []).append(message)
    return found
