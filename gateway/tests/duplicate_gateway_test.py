"""Two `sbgc gateway` of one fleet, as on two machines."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from broker_test import wait_for_gimbal
from brokers import Commander, Mosquitto, Subscriber
from emulated_gimbal import emulated_gimbal
from gateway import eventually, running_gateway

FLEET = """[fleet]
name = "studio"
[broker]
address = "127.0.0.1:{port}"
mqtt = "{mqtt}"
journal = "fleet.db"
[gimbal.front]
port = "{address}"
allow = ["raw"]
"""


@pytest.fixture(name="broker")
def broker_(tmp_path: Path) -> Iterator[Mosquitto]:
    broker = Mosquitto(tmp_path / "broker")
    broker.start()
    yield broker
    broker.kill()


def wait_for_answer(seen: Subscriber, say: Commander) -> None:
    """Also that a gimbal is not online yet is one."""
    seen.result(say.command("front", "raw", {"message": "GetAnglesRequest"}))


@pytest.mark.parametrize("mqtt", ["3.1.1", "5"])
def test_the_later_one_gives_way(broker: Mosquitto, tmp_path: Path, mqtt: str) -> None:
    folders = [tmp_path / "first", tmp_path / "second"]
    for folder in folders:
        folder.mkdir()
    seen = Subscriber(broker.port)
    say = Commander(broker.port)
    with emulated_gimbal() as one, emulated_gimbal() as other:
        texts = [
            FLEET.format(port=broker.port, mqtt=mqtt, address=gimbal.address)
            for gimbal in (one, other)
        ]
        with running_gateway(folders[0], texts[0]) as first:
            wait_for_gimbal(seen)
            wait_for_answer(seen, say)
            with running_gateway(folders[1], texts[1]) as second:
                assert second.process.wait(timeout=30) == 2
                assert "another gateway of this fleet" in second.log.read_text()
            wait_for_answer(seen, say)
            states = "sbgc/studio/gateway/state"
            eventually(lambda: '"online"' in seen.on(states)[-1].text)
            assert first.end() == 0
    seen.close()


def test_a_gateway_is_no_rival_of_its_earlier_self(broker: Mosquitto, tmp_path: Path) -> None:
    seen = Subscriber(broker.port)
    say = Commander(broker.port)
    with emulated_gimbal() as front:
        text = FLEET.format(port=broker.port, mqtt="3.1.1", address=front.address)
        with running_gateway(tmp_path, text) as gateway:
            wait_for_gimbal(seen)
            for _ in range(5):
                wait_for_answer(seen, say)
                gateway.kill()
                gateway.restart()
            wait_for_answer(seen, say)
            assert gateway.end() == 0
    seen.close()
