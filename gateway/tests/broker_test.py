"""`sbgc gateway` on an MQTT broker: its reports, and the commands it executes or refuses."""

from __future__ import annotations

import functools
import json
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from brokers import Subscriber, now, suspended
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from gateway import eventually
from sbgc_command import run
from studio import Studio, gimbal_of, running_studio

ALLOWED = "stop move speed motors home menu get set raw"
MORE = 'raw-effects = ["sets"]\ntelemetry = ["RealtimeData4 50"]\nunits = "yes"\n'


def refusal(studio: Studio, *arguments: Any, **members: Any) -> str:
    result = studio.result(*arguments, **members)
    assert result["status"] == "refused", result
    return str(result["error"]["code"])


def speed_of(gimbal: EmulatedGimbal) -> float:
    """The speed of the pitch axis, measured without the gateway."""
    state = run("send", "GetAnglesRequest", "-p", gimbal.address, "--format", "jsonl").objects[-1]
    return abs(float(state["fields"]["axes"]["pitch"]["rc_speed"]))


@pytest.fixture(scope="module", name="studio")
def studio_(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    folder = tmp_path_factory.mktemp("studio")
    with emulated_gimbal() as rear:
        more = MORE + gimbal_of(rear.address, name="rear") + '[metrics]\nlisten = "LISTEN"\n'
        with running_studio(folder, "stop-after = 1\n", allow=ALLOWED, more=more) as studio:
            studio.seen.wait_for("rear")
            assert studio.result("motors", {"on": True})["status"] == "done"
            yield studio
            assert studio.gateway.end() == 0, studio.gateway.log.read_text()
            topic = "sbgc/studio/gateway/state"
            eventually(lambda: '"offline"' in studio.seen.on(topic)[-1].text)


@functools.cache
def gateway_schema() -> Any:
    schema = json.loads(run("gateway", "--schema").out)
    jsonschema.Draft202012Validator.check_schema(schema)
    return schema


def check(kind: str, value: Any) -> None:
    """Checks a payload against the schema of the gateway."""
    schema = gateway_schema()
    validator = jsonschema.Draft202012Validator(
        {"$ref": f"#/$defs/{kind}", "$defs": schema["$defs"]}
    )
    for error in validator.iter_errors(value):
        raise error


def test_what_is_published_fits_the_schema(studio: Studio) -> None:
    assert studio.result("raw", {"message": "BoardInfoRequest"})["status"] == "done"
    assert studio.result("move", {"angles": {"yaw": 1}, "speed": -1})["status"] == "refused"
    eventually(lambda: studio.seen.on("sbgc/studio/front/telemetry/RealtimeData4"))
    sample = studio.seen.on("sbgc/studio/front/telemetry/RealtimeData4")[-1].json
    volts = {"real": sample["fields"]["bat_level"] / 100, "unit": "V"}
    assert sample["units"]["bat_level"] == pytest.approx(volts)
    assert sample["units"]["angle.pitch"]["unit"] == "deg"
    kinds = {
        "state": "state",
        "event": "event",
        "RealtimeData4": "telemetry.RealtimeData4",
        "test": "result",
    }
    checked = set()
    for one in list(studio.seen.messages)[-60:]:
        levels = one.topic.split("/")
        if levels[2] == "gateway":
            if levels[3] in ("state", "heartbeat"):
                check("gateway_state", one.json)
        elif levels[-1] in kinds:
            check(kinds[levels[-1]], one.json)
            checked.add(levels[-1])
    assert {"RealtimeData4", "test"} <= checked
    for task, parameters in [
        ("move", {"angles": {"pitch": 3}}),
        ("speed", {"speeds": {"yaw": 1}}),
        ("raw", {"message": "BoardInfoRequest", "fields": {}}),
        ("set", {"values": {"pitch.p": 15}}),
        ("home", None),
    ]:
        check(f"command.{task}", studio.say.payload(parameters))
    for task, parameters in [("move", {"angles": {"pan": 3}}), ("speed", None), ("raw", {})]:
        with pytest.raises(jsonschema.ValidationError):
            check(f"command.{task}", studio.say.payload(parameters))


def test_states_are_retained(studio: Studio) -> None:
    with closing(Subscriber(studio.broker.port, ["sbgc/studio/+/state"])) as late:
        eventually(lambda: len(late.messages) == 3)
        states = {one.topic.split("/")[2]: one for one in late.messages}
        assert all(one.is_retained for one in late.messages)
        front = states["front"].json
        assert front["state"] == "online" and front["firmware"] == "2.59"
        assert states["gateway"].json["state"] == "online"


def test_move(studio: Studio) -> None:
    result = studio.moved(8, correlation="c7")
    assert result["correlation"] == "c7"
    assert result["gimbal"] == "front" and result["task"] == "move"
    assert result["result"]["angles"]["pitch"] == pytest.approx(8, abs=1)


def test_parameters(studio: Studio) -> None:
    before = studio.result("get", {"names": ["pitch.p"], "profile": 2})["result"]
    assert before["profile"] == 2 and before["parameters"][0]["path"] == "axes.pitch.p"
    wanted = before["parameters"][0]["value"] + 1
    written = studio.result("set", {"values": {"pitch.p": wanted}, "profile": 2})
    assert written["status"] == "done", written
    assert written["result"]["changes"][0]["path"] == "axes.pitch.p"
    after = studio.result("get", {"names": ["pitch.p"], "profile": 2})["result"]
    assert after["parameters"][0]["value"] == wanted


def test_commands_are_refused(studio: Studio) -> None:
    angles = {"angles": {"pitch": 1}}
    assert refusal(studio, "calibrate", {"calibration": "gyro"}) == "not_allowed"
    assert refusal(studio, "fly") == "not_allowed"
    assert refusal(studio, "raw", {"message": "ResetRequest"}) == "not_allowed"
    assert refusal(studio, "raw", {"message": "MotorsOn"}) == "not_allowed"
    assert refusal(studio, "move", {"angles": {"pitch": 9000}}) == "invalid"
    assert refusal(studio, "move", {"angle": {"pitch": 1}}) == "invalid"
    assert refusal(studio, "menu", {"action": "dance"}) == "invalid"
    assert refusal(studio, "menu", {"action": "calib_gyro"}) == "invalid", "it is calibrate"
    assert refusal(studio, "raw", {"message": "GetAngles"}) == "invalid"
    assert refusal(studio, "move", angles, deadline=None) == "invalid"
    assert refusal(studio, "move", angles, sent=None) == "invalid"
    assert refusal(studio, "move", angles, sent=now() - 600_000) == "queued"
    assert refusal(studio, "move", angles, sent=now() + 600_000) == "sent_in_future"
    assert refusal(studio, "move", angles, deadline=now() - 60_000) == "expired"
    assert refusal(studio, "move", angles, deadline=now() + 600_000) == "deadline_too_far"
    assert refusal(studio, "move", angles, version=2) == "version"
    key = studio.say.command("rear", "stop")
    assert studio.seen.result(key)["error"]["code"] == "not_allowed"
    key = studio.say.command("roof", "stop")
    assert studio.seen.result(key)["error"]["code"] == "unknown_gimbal"


def codes(studio: Studio) -> list[str]:
    """The reasons of all refusals so far."""
    return [one["error"]["code"] for one in studio.seen.results() if "error" in one]


def test_a_key_is_carried_out_once(studio: Studio) -> None:
    fields = {"mode": "BEEPER_MODE_CLICK"}
    first = studio.result("raw", {"message": "BeepSound", "fields": fields}, key="beep")
    assert first["status"] == "done", first
    seen = len(studio.seen.results())
    studio.say.command("front", "raw", {"message": "BeepSound", "fields": fields}, key="beep")
    eventually(lambda: len(studio.seen.results()) > seen)
    again = studio.seen.results()[-1]
    assert again["repeated"] is True and again["time"] == first["time"]
    studio.say.command("front", "home", key="beep")
    eventually(lambda: "key_reused" in codes(studio))


def test_results_without_an_address_are_events(studio: Studio) -> None:
    key = studio.say.command("front", "raw", {"message": "GetAnglesRequest"}, reply=None)
    eventually(
        lambda: [
            one for one in studio.seen.events("front", "result") if one["result"].get("key") == key
        ]
    )
    studio.say.publish("sbgc/studio/front/cmd/move", "no JSON")
    eventually(
        lambda: [
            one
            for one in studio.seen.events("front", "result")
            if one["result"].get("error", {}).get("code") == "invalid"
        ]
    )


def test_a_speed_has_a_dead_man(studio: Studio) -> None:
    count = len(studio.seen.events("front", "speed_ended"))
    assert studio.result("speed", {"speeds": {"pitch": 5}})["status"] == "done"
    eventually(lambda: len(studio.seen.events("front", "speed_ended")) > count)
    assert speed_of(studio.front) == 0


def test_without_the_broker_a_gimbal_stops_and_results_wait(studio: Studio) -> None:
    far = {"angles": {"pitch": -80}, "speed": 2, "timeout": 60}
    key = studio.say.command("front", "move", far)
    eventually(lambda: speed_of(studio.front) > 0)
    with suspended(studio.broker.process):
        eventually(lambda: speed_of(studio.front) == 0)
    result = studio.seen.result(key)
    assert result["error"]["code"] == "cancelled", result
    eventually(lambda: studio.seen.events("front", "stopped"))


def test_telemetry_is_thinned_for_a_slow_broker(studio: Studio) -> None:
    """The sockets buffer seconds of telemetry, so the broker sleeps until samples are dropped."""

    def thinned() -> float:
        return studio.gateway.metrics()["sbgc_broker_thinned_samples_total"]

    before = thinned()
    with suspended(studio.broker.process):
        eventually(lambda: thinned() > before, 90)
    assert studio.result("raw", {"message": "GetAnglesRequest"})["status"] == "done"
    topic = "sbgc/studio/gateway/heartbeat"
    eventually(lambda: any(one.json["thinned"] > before for one in studio.seen.on(topic)))


def test_what_waited_at_the_broker_does_not_move_the_camera(studio: Studio) -> None:
    studio.gateway.end()
    moves = studio.say.command("front", "move", {"angles": {"pitch": 20}})
    reads = studio.say.command("front", "raw", {"message": "GetAnglesRequest"})
    retained = json.dumps(studio.say.payload(key="retained"))
    studio.say.publish("sbgc/studio/front/cmd/home", retained, "-r")
    studio.gateway.restart()
    assert studio.seen.result(moves)["error"]["code"] == "queued"
    # The gimbal may not be there yet.
    assert studio.seen.result(reads)["status"] in ("done", "failed")
    # Once as a message that waited, and once as a retained one.
    eventually(lambda: "retained" in codes(studio))
    studio.say.remove_retained("sbgc/studio/front/cmd/home")
    eventually(lambda: studio.result("home")["status"] == "done")


def test_a_gimbal_that_hangs_does_not_delay_another(tmp_path: Path) -> None:
    with emulated_gimbal() as rear:
        more = gimbal_of(rear.address, "raw", 'attempt-time = "60s"', name="rear")
        with running_studio(tmp_path, more=more) as studio:
            seen, say = studio.seen, studio.say
            seen.wait_for("rear")
            asks = {"message": "GetAnglesRequest"}
            with suspended(rear.process):
                slow = [say.command("rear", "raw", asks) for _ in range(5)]
                quick = [say.command("front", "raw", asks) for _ in range(20)]
                for key in quick:
                    assert seen.result(key)["status"] == "done"
                assert all(one["gimbal"] == "front" for one in seen.results()[:20])
            for key in slow:
                assert seen.result(key)["status"] in ("done", "failed", "refused")


def test_results_wait_while_the_broker_is_away(tmp_path: Path) -> None:
    with running_studio(tmp_path) as studio:
        broker, front = studio.broker, studio.front
        studio.seen.close()
        # The result arrives when the broker is gone: the camera needs seconds.
        key = studio.say.command("front", "move", {"angles": {"pitch": -30}, "speed": 3})
        eventually(lambda: speed_of(front) > 0)
        broker.kill()
        eventually(lambda: speed_of(front) == 0)
        # This also holds across the end of the gateway.
        studio.gateway.end()
        broker.start()
        with closing(Subscriber(broker.port)) as seen:
            studio.gateway.restart()
            assert seen.result(key)["error"]["code"] == "cancelled"
