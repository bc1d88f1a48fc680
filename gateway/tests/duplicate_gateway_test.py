"""Two `sbgc gateway` of one fleet, as on two machines."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest

from brokers import Commander, Mosquitto, Subscriber
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from gateway import eventually, running_gateway
from studio import fleet_of, gimbal_of, running_broker, running_studio


def text_of(broker: Mosquitto, front: EmulatedGimbal, mqtt: str) -> str:
    address = f'"127.0.0.1:{broker.port}"'
    return fleet_of(address, gimbal_of(front.address, "raw"), settings=f'mqtt = "{mqtt}"')


def wait_for_answer(seen: Subscriber, say: Commander) -> None:
    """Also that a gimbal is not online yet is one."""
    seen.result(say.command("front", "raw", {"message": "GetAnglesRequest"}))


@pytest.mark.parametrize("mqtt", ["3.1.1", "5"])
def test_the_later_one_gives_way(tmp_path: Path, mqtt: str) -> None:
    folders = [tmp_path / "first", tmp_path / "second"]
    for folder in folders:
        folder.mkdir()
    with (
        running_broker(tmp_path) as broker,
        closing(Subscriber(broker.port)) as seen,
        emulated_gimbal() as one,
        emulated_gimbal() as other,
        running_gateway(folders[0], text_of(broker, one, mqtt)) as first,
    ):
        say = Commander(broker.port)
        seen.wait_for()
        wait_for_answer(seen, say)
        with running_gateway(folders[1], text_of(broker, other, mqtt)) as second:
            assert second.process.wait(timeout=30) == 2
            assert "another gateway of this fleet" in second.log.read_text()
        wait_for_answer(seen, say)
        states = "sbgc/studio/gateway/state"
        eventually(lambda: '"online"' in seen.on(states)[-1].text)
        assert first.end() == 0


def test_a_gateway_is_no_rival_of_its_earlier_self(tmp_path: Path) -> None:
    with running_studio(tmp_path, 'mqtt = "3.1.1"') as studio:
        for _ in range(5):
            wait_for_answer(studio.seen, studio.say)
            studio.gateway.kill()
            studio.gateway.restart()
        wait_for_answer(studio.seen, studio.say)
        assert studio.gateway.end() == 0
