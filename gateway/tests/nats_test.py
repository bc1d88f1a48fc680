"""`sbgc gateway` on a cluster of NATS servers that speak MQTT 3.1.1; one of them is killed."""

from __future__ import annotations

import json
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest

from brokers import Commander, Nats, Subscriber, now
from emulated_gimbal import emulated_gimbal
from gateway import eventually, running_gateway
from sbgc_command import free_port
from studio import fleet_of, gimbal_of

BEFORE = 20
AFTER = 20
DEADLINE_MS = 60_000
# Without commands: NATS 2.9 loses some if another client also reads them with quality 1.
RESULTS = [f"sbgc/studio/{topic}" for topic in ("+/state", "+/event", "+/telemetry/+", "reply/#")]


def wait_for_sessions(server: Nats) -> None:
    """The servers accept no clients until they have found each other."""
    probe = Commander(server.port)
    eventually(lambda: probe.publish("probe", "x", check=False) == 0, 120)


def keeps_for_an_hour(server: Nats) -> bool:
    """Creates the stream of messages, which would otherwise delete acknowledged ones."""
    stream = {
        "name": "$MQTT_msgs",
        "subjects": ["$MQTT.msgs.>"],
        "retention": "limits",
        "max_age": 3600 * 10**9,
        "storage": "file",
        "num_replicas": 3,
    }
    text = json.dumps(stream)
    request = f"PUB $JS.API.STREAM.CREATE.$MQTT_msgs answer {len(text)}\r\n{text}\r\n"
    with socket.create_connection(("127.0.0.1", server.own_port), 5) as link:
        link.sendall(f'CONNECT {{"verbose": false}}\r\nSUB answer 1\r\n{request}'.encode())
        try:
            return any(b'"config"' in line for line in link.makefile("rb"))
        except TimeoutError:  # the servers have not found each other
            return False


@pytest.fixture(name="servers")
def servers_(tmp_path: Path) -> Iterator[list[Nats]]:
    routes = [free_port() for _ in range(3)]
    servers = [Nats(tmp_path / f"n{number}", number, routes) for number in range(3)]
    for server in servers:
        server.start()
    try:
        yield servers
    finally:
        for server in servers:
            server.kill()


def is_home(seen: Subscriber, say: Commander) -> bool:
    return bool(seen.result(say.command("front", "home"), 60)["status"] == "done")


def ask(say: Commander, key: str) -> None:
    """Repeats a command until a server has acknowledged it, as all senders must, and not again."""

    def is_published() -> bool:
        payload = say.payload(
            {"message": "GetAnglesRequest"}, key=key, deadline=now() + DEADLINE_MS
        )
        text = json.dumps(payload)
        return say.publish("sbgc/studio/front/raw", text, check=False) == 0

    eventually(is_published, 60)


@pytest.mark.long  # on a busy machine, a cluster takes minutes to find its leader
@pytest.mark.parametrize("topics", [RESULTS, ["sbgc/#"]], ids=["one reader", "two readers"])
def test_one_of_three_servers_is_killed(
    servers: list[Nats], tmp_path: Path, topics: list[str]
) -> None:
    if topics != RESULTS:
        eventually(lambda: keeps_for_an_hour(servers[0]), 120)
    for server in servers:
        wait_for_sessions(server)
    addresses = ", ".join(f'"127.0.0.1:{server.port}"' for server in servers)
    seen = Subscriber(servers[1].port, topics, "-c", "-i", "observer")
    say = Commander(servers[2].port)
    with emulated_gimbal() as gimbal:
        telemetry = 'telemetry = ["RealtimeData4 10"]'
        text = fleet_of(f"[{addresses}]", gimbal_of(gimbal.address, "raw stop home", telemetry))
        with running_gateway(tmp_path, text) as gateway:
            seen.wait_for()
            eventually(lambda: seen.on("sbgc/studio/front/telemetry/RealtimeData4"))
            keys = [f"ask-{number}" for number in range(BEFORE + AFTER)]
            for key in keys[:BEFORE]:
                ask(say, key)
            servers[0].kill()  # the gateway is connected to it
            for key in keys[BEFORE:]:
                ask(say, key)
            for key in keys:
                result = seen.result(key, 120)
                # More commands may have waited together than a gimbal can queue.
                assert result["status"] == "done" or result["error"]["code"] == "overload", result
            eventually(lambda: "connected to the broker" in gateway.log.read_text())
            # Motion works again, so nothing is queued before it.
            eventually(lambda: is_home(seen, say), 120)
            assert gateway.end() == 0
        eventually(lambda: '"offline"' in seen.on("sbgc/studio/gateway/state")[-1].text, 60)
    seen.close()
