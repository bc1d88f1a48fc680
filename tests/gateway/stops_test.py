"""`sbgc gateway`: a stop stays owed until it is done, over silence, a restart and a line that loses bytes."""

from __future__ import annotations

import time
from typing import Any

import pytest

from brokers import Message
from gateway import eventually, running_gateway
from motion_test import emulated_speed
from safety_test import TURN, Stage, stage_, start_turning

__all__ = ["stage_"]
STATE = "sbgc/studio/front/state"


def state(stage: Stage) -> Any:
    return stage.seen.on(STATE)[-1].json


def has_event(stage: Stage, kind: str) -> bool:
    events: list[Message] = stage.seen.on("sbgc/studio/front/event")
    return any(one.json.get("event") == kind for one in events)


def test_a_stop_is_repeated_over_silence(stage: Stage) -> None:
    fleet = stage.fleet() + '[metrics]\nlisten = "LISTEN"\n'
    with running_gateway(stage.folder, fleet) as gateway:
        start_turning(stage)
        stage.line.loss = 1
        stop = stage.result("stop")
        assert stop["status"] == "failed" and "still trying" in stop["error"]["message"]
        eventually(lambda: state(stage).get("stopping"))
        assert gateway.metric('sbgc_gimbal_stopping{gimbal="front"}') == 1
        assert has_event(stage, "stopping")
        refused = stage.result("raw", TURN)
        assert refused["error"]["code"] in ("stopping", "not_connected")
        assert stage.turns()
        stage.line.loss = 0
        eventually(stage.stands)
        eventually(lambda: "stopping" not in state(stage))
        eventually(lambda: has_event(stage, "stopped"))


def test_silence_stops_what_moves(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()):
        start_turning(stage)
        stage.line.loss = 1
        eventually(lambda: has_event(stage, "silent"))
        eventually(lambda: state(stage)["state"] == "offline")
        assert stage.turns()
        stage.line.loss = 0
        eventually(stage.stands)


def test_a_gateway_that_ends_names_what_may_turn(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()) as gateway:
        start_turning(stage)
        stage.line.loss = 1
        begun = time.monotonic()
        assert gateway.end() == 1
        assert time.monotonic() - begun < 20
        assert "front may still turn" in gateway.log.read_text()
        stage.line.loss = 0
        gateway.restart()
        eventually(stage.stands)


@pytest.mark.parametrize("turned_by", ["gateway", "another program"])
def test_a_stop_of_a_gateway_that_is_killed(stage: Stage, turned_by: str) -> None:
    with running_gateway(stage.folder, stage.fleet()) as gateway:
        start_turning(stage)
        if turned_by != "gateway":
            # The stop ends what the gateway owes before.
            assert stage.result("stop")["status"] == "done"
            with emulated_speed(stage.front):
                eventually(stage.turns)
        stage.line.loss = 1
        reply = stage.say.command("front", "stop")
        time.sleep(0.5)
        gateway.kill()
        stage.line.loss = 0
        gateway.restart()
        assert stage.seen.result(reply)["status"] in ("unknown", "done")
        eventually(stage.stands)


def test_what_another_program_turns_is_not_owed_a_stop(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()):
        stage.motors_on()
        with emulated_speed(stage.front):
            stop = stage.result("stop")
            assert stop["status"] == "failed" and stop["error"]["code"] == "interrupted", stop
            assert "stopping" not in state(stage)


def test_stops_on_a_line_that_loses_bytes(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()):
        start_turning(stage)
        stage.line.loss = 0.02
        stage.result("stop")
        eventually(stage.stands)
