"""`sbgc gateway`: a stop stays pending until it is done, despite silence, a restart and a line that loses bytes;
and a terminal that closes."""

from __future__ import annotations

import signal
import sqlite3
import threading
import time
from contextlib import closing
from typing import Any

import pytest

from bridge import Host, bridge_to
from brokers import Message
from emulated_gimbal import emulated_gimbal
from gateway import eventually, running_gateway
from motion_test import emulated_speed
from safety_test import TURN, Line, Stage, stage_, start_turning
from sbgc_command import run

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
            # The stop ends what the gateway owed before.
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
            assert stop["status"] == "failed", stop
            assert stop["error"]["code"] in ("interrupted", "timeout"), stop  # on a busy machine
            eventually(lambda: "stopping" not in state(stage))


def test_stops_on_a_line_that_loses_bytes(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()):
        start_turning(stage)
        stage.line.loss = 0.02
        stage.result("stop")
        eventually(stage.stands)


def owe_a_stop(stage: Stage) -> None:
    start_turning(stage)
    stage.line.cut()
    eventually(lambda: state(stage)["state"] == "offline")
    assert stage.result("stop")["status"] == "failed"
    assert state(stage)["stopping"]


def await_no_stop(stage: Stage) -> None:
    stage.line.is_up = True
    eventually(lambda: has_event(stage, "stopped"))
    eventually(lambda: state(stage)["state"] == "online" and "stopping" not in state(stage))


def pass_an_hour(stage: Stage) -> None:
    """Opens the journal."""
    with closing(sqlite3.connect(stage.folder / "fleet.db")) as journal, journal:
        journal.execute("UPDATE commands SET received = received - 3600000")


@pytest.mark.parametrize("event", ["a reconnection", "a restart an hour later"])
def test_what_stands_stays_with_rc(stage: Stage, event: str) -> None:
    rc_speed = ("rc_map.pitch=raw:133", "rc.pitch.rc_mode=1")  # API channel 5
    assert run("params", "set", *rc_speed, "--yes", "-p", stage.front.address).status == 0
    with running_gateway(stage.folder, stage.fleet()) as gateway:
        owe_a_stop(stage)
        if event != "a reconnection":
            gateway.kill()
            pass_an_hour(stage)
            gateway.restart()
        assert run("stop", "-p", stage.front.address).status == 0
        assert run("send", "Control", "--yes", "-p", stage.front.address).status == 0
        await_no_stop(stage)
        channels = "val_ch=" + ",".join(["0.9"] * 32)
        run("send", "ApiVirtChControl", channels, "--yes", "-p", stage.front.address)
        eventually(stage.turns)
        assert stage.result("stop")["status"] == "done"
        assert stage.stands()


def test_a_board_that_is_switched_off_and_on_is_owed_nothing(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()), emulated_gimbal() as after:
        owe_a_stop(stage)
        host, port = after.address.removeprefix("tcp:").split(":")
        stage.line.target = (host, int(port))
        await_no_stop(stage)
        stage.front = after
        start_turning(stage)


def test_a_slow_line_with_other_programs_is_not_silent(stage: Stage) -> None:
    with (
        emulated_gimbal("--tcp", "0", "--baud", "9600") as slow,
        bridge_to(slow.address) as bridge,
    ):
        stage.line = Line(bridge.address)
        stage.front = slow
        fleet = stage.fleet().replace("stop-after = 1", "stop-after = 3")
        with running_gateway(stage.folder, fleet):
            stage.motors_on()
            assert stage.result("raw", TURN)["status"] == "done"
            is_over = threading.Event()
            answers: list[int] = []

            def ask() -> None:
                other = Host(bridge.address)
                while not is_over.is_set():
                    other.send(21, b"\0")  # CMD_READ_PARAMS_3, 155 bytes of answer
                    answers.append(other.receive()[0])

            others = [threading.Thread(target=ask) for _ in range(3)]
            for one in others:
                one.start()
            time.sleep(8)
            is_over.set()
            for one in others:
                one.join()
            assert answers.count(21) > 15, "the line was busy"
            assert not has_event(stage, "silent") and stage.online() == 1
            assert stage.turns()


def test_signals_do_not_keep_it_from_stopping(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()) as gateway:
        start_turning(stage)
        for number in (signal.SIGHUP, signal.SIGHUP, signal.SIGTERM, signal.SIGHUP):
            gateway.process.send_signal(number)
            time.sleep(0.01)
        assert gateway.process.wait(60) == 0
        assert stage.stands()


def test_nohup_goes_on(stage: Stage) -> None:
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    with running_gateway(stage.folder, stage.fleet()) as gateway:
        signal.signal(signal.SIGHUP, before)
        eventually(stage.online)
        gateway.process.send_signal(signal.SIGHUP)
        time.sleep(0.5)
        assert gateway.process.poll() is None
        assert gateway.end() == 0
