"""`kill -9` of a gateway on mosquitto: no command plays its tones twice, and none is without a result.
`./dev test gateway --long` kills 100 times."""

from __future__ import annotations

from pathlib import Path

from kills import NOTES, kill

ROUNDS = 5


def test_kills_of_the_gateway(tmp_path: Path) -> None:
    statuses = kill(tmp_path, ROUNDS)
    assert sum(statuses.values()) == ROUNDS * len(NOTES)
    assert statuses["done"] > 0
