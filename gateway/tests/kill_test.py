"""`kill -9` of a gateway on mosquitto: no command plays its tones twice, and none is without a result.
`./dev test gateway --long` kills 100 times."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from kills import NOTES, kill

ROUNDS = 5


@pytest.mark.parametrize("hangs_at_disk", [False, True])
def test_kills_of_the_gateway(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, hangs_at_disk: bool
) -> None:
    if hangs_at_disk and "SBGC_FAULTS" not in os.environ:
        pytest.skip("there is no library of faults")
    monkeypatch.setattr("gateway.Gateway.hangs_at_disk", hangs_at_disk)
    statuses = kill(tmp_path, ROUNDS)
    assert sum(statuses.values()) == ROUNDS * len(NOTES)
    assert statuses["done"] > 0
