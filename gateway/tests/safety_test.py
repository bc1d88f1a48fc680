"""`sbgc gateway`: motion caused by commands is stopped, whatever fails, and old commands move nothing."""

from __future__ import annotations

import json
import os
import random
import socket
import subprocess
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, suppress
from pathlib import Path
from typing import Any

import pytest

from broker_test import check
from brokers import Commander, Mosquitto, Subscriber, now, suspended
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from gateway import Gateway, eventually, hanging_disk, running_gateway
from relay import pass_on
from sbgc_command import run
from studio import Conversation, fleet_of, gimbal_of, running_broker

TURN = {
    "message": "Control",
    "fields": {
        "control_mode": 1,  # by speed
        "axes": {"pitch": {"speed": -16}},
    },
}
FAR = {"angles": {"pitch": -80}, "speed": 2, "timeout": 100}


class Line:
    """A TCP line to a gimbal that can be cut."""

    def __init__(self, address: str) -> None:
        host, port = address.removeprefix("tcp:").rsplit(":", 1)
        self.target = (host, int(port))
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.address = f"tcp:127.0.0.1:{self.listener.getsockname()[1]}"
        self.is_up = True
        self.holds = False  # what it has got
        self.loss = 0.0  # of the bytes
        self.random = random.Random(1)
        self.ends: list[socket.socket] = []
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self) -> None:
        while True:
            near, _ = self.listener.accept()
            if not self.is_up:
                near.close()
                continue
            try:
                far = socket.create_connection(self.target)
            except OSError:  # the gimbal has ended before the gateway
                near.close()
                continue
            self.ends += [near, far]
            for source, sink in ((near, far), (far, near)):
                arguments = (source, sink, self._change)
                threading.Thread(target=pass_on, args=arguments, daemon=True).start()

    def _change(self, data: bytes) -> bytes:
        while self.holds:
            time.sleep(0.01)
        return bytes(one for one in data if self.random.random() >= self.loss)

    def cut(self) -> None:
        self.is_up = False
        for end in self.ends:
            with suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)
        self.ends = []


class Stage(Conversation):
    """A broker, a gateway with one gimbal, and a client."""

    def __init__(self, folder: Path, broker: Mosquitto, front: EmulatedGimbal) -> None:
        self.folder = folder
        self.broker = broker
        self.front = front
        self.line = Line(front.address)
        self.seen = Subscriber(broker.port)
        self.say = Commander(broker.port)

    def fleet(self, settings: str = "") -> str:
        allow = "stop move speed motors calibrate get raw"
        effects = 'raw-effects = ["sets", "moves", "restarts"]'
        gimbal = gimbal_of(self.line.address, allow, effects)
        address = f'"127.0.0.1:{self.broker.port}"'
        return fleet_of(address, gimbal, settings=f"stop-after = 1\n{settings}")

    def online(self) -> int:
        """The number of reports that the gimbal is online."""
        states = self.seen.on("sbgc/studio/front/state")
        return len([one for one in states if one.json["state"] == "online"])

    def motors_on(self) -> None:
        eventually(self.online)
        # Motion waits until the barrier is open.
        eventually(self.accepts_motion)

    def accepts_motion(self) -> bool:
        return bool(self.result("motors", {"on": True})["status"] == "done")

    def speed(self) -> float:
        """The speed of the fastest axis, measured without the gateway."""
        state = run("send", "GetAnglesRequest", "-p", self.front.address, "--format", "jsonl")
        axes = state.objects[-1]["fields"]["axes"].values()
        return max(abs(float(axis["rc_speed"])) for axis in axes)

    def turns(self) -> bool:
        return self.speed() > 0

    def stands(self) -> bool:
        return self.speed() == 0


@pytest.fixture(name="stage")
def stage_(tmp_path: Path) -> Iterator[Stage]:
    settings = "allow_anonymous true\nmax_queued_messages 0\n"
    with (
        running_broker(tmp_path, settings) as broker,
        emulated_gimbal("--calibration-time", "100") as front,
    ):
        stage = Stage(tmp_path, broker, front)
        yield stage
        stage.seen.close()


def start_turning(stage: Stage) -> None:
    stage.motors_on()
    assert stage.result("raw", TURN)["status"] == "done"
    eventually(stage.turns)


def test_a_stop_needs_no_room(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet("history = 3\n")):
        start_turning(stage)
        codes = [
            stage.result("get", {"names": ["pitch.p"]}).get("error", {}).get("code")
            for _ in range(8)
        ]
        assert "overload" in codes  # there is no room
        stop = stage.result("stop")
        assert stop["status"] == "done", stop
        assert stage.stands()


def test_a_stop_is_no_repetition(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()):
        for _ in range(2):
            start_turning(stage)
            # Neither a known key nor a deadline matters.
            stage.say.command("front", "stop", key="the same", deadline=9223372036854)
            eventually(stage.stands)


def ignored(stage: Stage) -> int:
    return int(stage.seen.on("sbgc/studio/gateway/heartbeat")[-1].json["ignored"])


@pytest.mark.parametrize(
    "payload, complains",
    [
        ("", False),
        ("{}", False),
        ("stop", True),
        ("\x01\xff", True),
        ('{"version": 2, "key": {}, "deadline": "now", "parameters": {"x": 1}}', True),
        ("9" * 70_000, True),
    ],
)
def test_any_payload_stops(stage: Stage, payload: str, complains: bool) -> None:
    with running_gateway(stage.folder, stage.fleet()):
        start_turning(stage)
        # Nothing is inferred from other topics.
        for topic in ("cmd/move", "cmd/stop/", "cmd/STOP", "raw"):
            stage.say.publish(f"sbgc/studio/front/{topic}", "stop")
        eventually(lambda: len(stage.seen.events("front", "result")) == 3)  # "cmd/stop/" is none
        assert stage.turns()
        stage.say.publish("sbgc/studio/front/cmd/stop", payload)
        event = eventually(lambda: stage.seen.events("front", "result")[3:])[0]
        assert event["result"]["status"] == "done" and stage.stands()
        assert bool(event["result"].get("ignored")) == complains, event
        check("event", event)
        eventually(lambda: ignored(stage) == int(complains))


def test_stops_that_are_refused_or_not_answered(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet('mqtt = "5"\n')):
        start_turning(stage)
        stage.say.publish("sbgc/studio/front/cmd/stop", "stop", "-V", "5", "-r")
        refused = eventually(lambda: stage.seen.events("front", "result"))[0]["result"]
        assert refused["error"]["code"] == "retained" and stage.turns()
        stage.say.remove_retained("sbgc/studio/front/cmd/stop")
        broken = stage.say.publish_many("sbgc/studio/front/cmd/stop", [{"version": 9}] * 2000)
        broken.wait(60)
        eventually(lambda: ignored(stage) == 2000 and stage.accepts_motion())
        answered = len(stage.seen.events("front", "result"))
        heartbeat = stage.seen.on("sbgc/studio/gateway/heartbeat")[-1].json
        assert 500 <= answered < 2000 and heartbeat["dropped"] > 0


def test_garbage_does_not_delay_a_stop(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()):
        start_turning(stage)
        garbage = stage.say.publish_many("sbgc/studio/front/cmd/move", [{"version": 9}] * 3000)
        assert stage.result("stop")["status"] == "done"
        assert stage.stands()
        garbage.wait(60)
        # Only some are answered, because answers would keep the disk busy.
        eventually(stage.accepts_motion)
        assert len(stage.seen.events("front", "result")) < 3000


@pytest.mark.parametrize("task, parameters", [("move", FAR), ("raw", TURN)])
def test_a_line_that_comes_back_stops_the_motion(stage: Stage, task: str, parameters: Any) -> None:
    with running_gateway(stage.folder, stage.fleet()) as gateway:
        stage.motors_on()
        key = stage.say.command("front", task, parameters)
        eventually(stage.turns)
        before = stage.online()
        stage.line.cut()
        if task == "move":
            assert stage.seen.result(key)["status"] == "failed"
        assert stage.turns()
        stage.line.is_up = True
        eventually(lambda: stage.online() > before)
        eventually(stage.stands)
        stopped = eventually(lambda: stage.seen.events("front", "stopped"))[0]
        assert "line was lost" in stopped["message"]
        assert gateway.end() == 0


def test_a_broker_that_is_gone_while_the_line_is_lost(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()):
        start_turning(stage)
        stage.line.cut()
        stage.broker.kill()
        time.sleep(2)  # longer than stop-after
        stage.broker.start()
        assert stage.turns()
        stage.line.is_up = True
        eventually(stage.stands)


def test_a_gateway_that_was_killed_stops_the_motion(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()) as gateway:
        start_turning(stage)
        gateway.kill()
        assert stage.turns()
        gateway.restart()
        eventually(stage.stands)
        message = eventually(lambda: stage.seen.events("front", "stopped"))[0]["message"]
        assert "the gateway ended" in message


def test_a_motion_that_has_ended_is_not_stopped_later(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()) as gateway:
        stage.motors_on()
        stage.moved(3)
        assert stage.result("raw", TURN)["status"] == "done"
        assert stage.result("stop")["status"] == "done"
        time.sleep(0.5)  # what is at rest is recorded after the result
        gateway.kill()
        before = stage.online()
        gateway.restart()
        eventually(lambda: stage.online() > before)
        assert stage.result("get", {"names": ["pitch.p"]})["status"] == "done"
        assert not stage.seen.events("front", "stopped")


def test_a_speed_that_waited_is_refused(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()):
        stage.motors_on()
        calibration = stage.say.command("front", "calibrate", {"calibration": "gyro"})
        speed = stage.result("speed", {"speeds": {"pitch": 20}})
        assert speed["error"]["code"] == "expired", speed
        assert stage.seen.result(calibration)["status"] == "done"


def test_motors_off_does_not_wait(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()):
        stage.motors_on()
        move = stage.say.command("front", "move", FAR)
        waits = stage.say.command("front", "move", FAR)
        eventually(stage.turns)
        assert stage.result("motors", {"on": False})["status"] == "done"
        assert stage.seen.result(move)["status"] == "failed"
        assert stage.seen.result(waits)["error"]["code"] == "superseded"


def test_a_restart_that_waited_at_the_broker_is_refused(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()) as gateway:
        stage.motors_on()
        gateway.end()
        key = stage.say.command("front", "raw", {"message": "ResetRequest"})
        gateway.restart()
        assert stage.seen.result(key)["error"]["code"] == "queued"


def test_a_speed_does_not_stop_what_comes_after_it(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()):
        stage.motors_on()
        time.sleep(0.5)  # after the connection, speeds are refused
        for _ in range(3):
            assert stage.result("speed", {"speeds": {"pitch": 3}})["status"] == "done"
            assert stage.result("raw", TURN)["status"] == "done"
            time.sleep(1)  # longer than the speed lasts
            assert stage.turns()
            assert stage.result("stop")["status"] == "done"


def test_a_command_that_is_to_be_retained_is_refused(stage: Stage) -> None:
    """MQTT 5 shows retained messages. Otherwise, a broker would move the camera after each connection."""
    with running_gateway(stage.folder, stage.fleet('mqtt = "5"\n')):
        stage.motors_on()
        key = stage.say.command("front", "move", FAR, options=("-V", "5", "-r"))
        assert stage.seen.result(key)["error"]["code"] == "retained"
        stage.say.remove_retained("sbgc/studio/front/cmd/move")


def test_what_has_come_with_a_stop_does_not_begin_after_it(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()) as gateway:
        stage.motors_on()
        with suspended(gateway.process):
            move = stage.say.command("front", "move", FAR)
            stop = stage.say.command("front", "stop")
        assert stage.seen.result(stop)["status"] == "done"
        assert stage.seen.result(move)["error"]["code"] == "superseded"
        assert stage.stands()


@pytest.mark.skipif("SBGC_FAULTS" not in os.environ, reason="there is no library of faults")
@pytest.mark.parametrize("version", ["3.1.1", "5"])
def test_a_stop_does_not_wait_for_the_disk(
    stage: Stage, monkeypatch: pytest.MonkeyPatch, version: str
) -> None:
    monkeypatch.setattr("gateway.Gateway.hangs_at_disk", True)
    # Nothing else may stop the camera.
    fleet = stage.fleet(f'mqtt = "{version}"\n').replace("stop-after = 1", "stop-after = 60")
    with running_gateway(stage.folder, fleet):
        start_turning(stage)
        # Mosquitto sends 20 with MQTT 3.1.1.
        count, padding = (15, 0) if version == "3.1.1" else (160, 60_000)
        waits = [stage.say.payload(FAR) for _ in range(count)]
        with hanging_disk(stage.folder):
            stage.say.command("front", "get", {"names": ["pitch.p"]})
            stage.say.publish_many("sbgc/studio/front/cmd/move", waits, padding).wait(60)
            stop = stage.say.command("front", "stop")
            eventually(stage.stands)
            time.sleep(1)
            assert stage.stands() and not stage.seen.results()[2:]
        assert stage.seen.result(stop)["status"] == "done"
        codes = {stage.seen.result(one["key"])["error"]["code"] for one in waits[:120]}
        assert codes == {"superseded"}
        if version == "5":
            assert stage.seen.result(waits[-1]["key"])["error"]["code"] == "overload"
        assert stage.stands()
        stage.moved(3)


@contextmanager
def held(line: Line) -> Iterator[None]:
    line.holds = True
    yield
    line.holds = False


@pytest.mark.parametrize("version", ["3.1.1", pytest.param("5", marks=pytest.mark.long)])
@pytest.mark.parametrize("part", ["gateway", "broker", "path"])
def test_no_speed_comes_late(stage: Stage, part: str, version: str) -> None:
    chance = random.Random(f"{part} {version}")
    path = Line(f"tcp:127.0.0.1:{stage.broker.port}")
    fleet = stage.fleet(f'mqtt = "{version}"\nstop-after = 60\n').replace("stop-after = 1\n", "")
    fleet = fleet.replace(f":{stage.broker.port}", path.address.removeprefix("tcp:127.0.0.1"))
    topic = "sbgc/studio/front/cmd/speed"
    published: dict[str, int] = {}
    with running_gateway(stage.folder, fleet) as gateway, subprocess.Popen(
        [*stage.say.base, "-t", topic, "-l"], stdin=subprocess.PIPE, text=True
    ) as sender:

        def publish(seconds: float) -> None:
            assert sender.stdin is not None
            end = time.monotonic() + seconds
            while time.monotonic() < end:
                # The clocks of senders differ, also between messages of one sender.
                payload = stage.say.payload({"speeds": {"pitch": 1}})
                payload["sent"] += chance.choice([-900, 0, 900])
                published[payload["key"]] = now()
                sender.stdin.write(json.dumps(payload) + "\n")
                sender.stdin.flush()
                time.sleep(0.04)

        stage.motors_on()
        publish(1)
        suspension: dict[str, Callable[[], AbstractContextManager[None]]] = {
            "gateway": lambda: suspended(gateway.process),
            "broker": lambda: suspended(stage.broker.process),
            "path": lambda: held(path),
        }
        with suspension[part]():
            publish(chance.uniform(0.6, 4))
        publish(0.2)
        with suspension[part]():  # again, while what has waited still comes
            publish(1.5)
        resumed = now()
        publish(3)
        results = {key: stage.seen.result(key) for key in published}
        begun = {key: one["time"] for key, one in results.items() if one["status"] == "done"}
        late = {key: time - published[key] for key, time in begun.items()}
        assert max(late.values()) <= 1000
        assert {one["error"]["code"] for one in results.values() if "error" in one} == {"expired"}
        assert max(published[key] for key in begun) > resumed + 1500
        sender.terminate()


@pytest.mark.parametrize("ago, code", [(900, None), (2500, "expired")])
def test_a_speed_that_was_sent_too_long_ago(stage: Stage, ago: int, code: str | None) -> None:
    with running_gateway(stage.folder, stage.fleet("clock-skew = 1\n")):
        stage.motors_on()
        time.sleep(3)  # `sent` must be after the connection, too
        speed = stage.result("speed", {"speeds": {"pitch": 1}}, sent=now() - ago)
        assert speed.get("error", {}).get("code") == code
