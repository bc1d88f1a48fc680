"""Hosts that send anything to `sbgc emulate` and `sbgc bridge`; another host is served meanwhile."""

from __future__ import annotations

import random
import socket
import struct
import time
from collections.abc import Callable

import pytest

from bridge import DATA_STREAM_INTERVAL, Bridge, Host, shared_gimbal, stream_request
from emulated_gimbal import emulated_gimbal
from sbgc_command import frame, run
from web_socket import WebSocket

BOARD_INFO = 86
CONTROL = 67
TOKEN = "0123456789abcdef"
ROUNDS = 60
PLACES = 32


def anything(chance: random.Random) -> bytes:
    """Bytes that are no request for a restart: noise, parts of frames, frames with any bodies, HTTP."""
    noise = chance.randbytes(chance.choice((1, 5, 300, 20_000)))
    whole = frame(chance.choice((BOARD_INFO, 21, 73, 250)), chance.randbytes(chance.randrange(200)))
    return chance.choice(
        (noise, whole, whole[: chance.randrange(len(whole))], b">" * 300, b"GET / HTTP/1.1\r\n")
    )


def _place(address: str) -> tuple[str, int]:
    place = address.split("//")[-1].removeprefix("tcp:").removeprefix("udp:").split("/")[0]
    host, port = place.rsplit(":", 1)
    return host, int(port)


def _send_and_leave(connection: socket.socket, data: bytes, chance: random.Random) -> None:
    """Sends the bytes in pieces and leaves, perhaps with a reset."""
    connection.settimeout(0.2)
    try:
        while data:
            size = chance.choice((1, 7, 1000, 100_000))
            connection.sendall(data[:size])
            data = data[size:]
        if chance.random() < 0.3:
            connection.shutdown(socket.SHUT_WR)
            connection.recv(10_000)
    except OSError:
        pass  # it was thrown out, or the board is slower
    if chance.random() < 0.3:
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    connection.close()


def over_tcp(address: str, chance: random.Random) -> None:
    connection = socket.create_connection(_place(address), timeout=20)
    _send_and_leave(connection, anything(chance)[:3000], chance)


def over_udp(address: str, chance: random.Random) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        for _ in range(chance.randrange(4)):
            sender.sendto(anything(chance)[: chance.choice((0, 1400, 60_000))], _place(address))


def over_web_socket(address: str, chance: random.Random) -> None:
    if chance.random() < 0.3:
        return over_tcp(address, chance)
    page = WebSocket(address, f"?token={TOKEN}")
    if page.status != 101:  # the places of those who have just left
        return page.close()
    data = anything(chance)[:3000]
    if chance.random() < 0.5:
        page.send(data, chance.choice((0, 1, 2, 2, 2, 8, 9, 15)))
        data = b""
    page.stream.close()
    _send_and_leave(page.socket, data, chance)
    return None


def serve_meanwhile(host: Host, attacks: list[tuple[Callable[..., None], str]], seed: int) -> None:
    chance = random.Random(seed)
    answer = host.ask(BOARD_INFO)
    for _ in range(ROUNDS):
        for attack, address in attacks:
            attack(address, chance)
        assert host.ask(BOARD_INFO) == answer


@pytest.mark.parametrize("seed", [1, 2])
def test_the_emulator_serves_others(seed: int) -> None:
    with emulated_gimbal("--tcp", "0", "--udp", "0") as gimbal:
        assert gimbal.process.stdout is not None
        other = gimbal.process.stdout.readline().split(": ", 1)[1].split()[0]
        host = Host(gimbal.address)
        serve_meanwhile(host, [(over_tcp, gimbal.address), (over_udp, other)], seed)
        host.close()
        assert gimbal.process.poll() is None


@pytest.mark.parametrize("seed", [1, 2])
def test_the_bridge_serves_others(seed: int) -> None:
    places = ("--tcp", "0", "--udp", "0", "--ws", "0", "--token", TOKEN)
    with shared_gimbal(*places) as bridge:
        host = Host(bridge.address)
        attacks = [over_tcp, over_udp, over_web_socket]
        serve_meanwhile(host, list(zip(attacks, bridge.addresses)), seed)
        host.close()


def hosts_that(do: str, bridge: Bridge) -> list[Host]:
    """Takes all places: of silent hosts, and of one that gets a stream."""
    hosts = [Host(bridge.address) for _ in range(PLACES)]
    streaming = hosts if do == "stream" else hosts[:1]
    for host in streaming:
        host.send(DATA_STREAM_INTERVAL, stream_request(200))
    for host in streaming:
        host.receive_samples(1)
    for host in hosts[1:] if do == "send a frame" else ():
        assert host.ask(BOARD_INFO)
    return hosts


@pytest.mark.parametrize("do", ["stay silent", "send a frame", "stream"])
def test_a_stop_gets_through_when_all_places_are_taken(do: str) -> None:
    with shared_gimbal() as bridge:
        hosts = hosts_that(do, bridge)
        for _ in range(2):
            stopped = run("stop", "-p", bridge.address)
            assert stopped.status == 0, stopped.error
        hosts[0].receive_samples(10)
        for host in hosts:
            host.close()


def test_silent_web_sockets_and_senders_of_datagrams_are_replaced() -> None:
    with shared_gimbal("--tcp", "0", "--udp", "0", "--ws", "0", "--token", TOKEN) as bridge:
        pages = [WebSocket(bridge.addresses[2], f"?token={TOKEN}") for _ in range(PLACES // 2)]
        senders = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(PLACES // 2)]
        for sender in senders:
            sender.sendto(b"silence", _place(bridge.addresses[1]))
        bridge.wait_for(f"is host {PLACES - 1}")
        time.sleep(2.1)
        hosts = hosts_that("stream", bridge)
        assert all(page.receive()[0] == 8 for page in pages)
        for one in [*hosts, *senders, *pages]:
            one.close()


def test_the_command_says_that_all_places_are_taken() -> None:
    with shared_gimbal() as bridge:
        hosts = hosts_that("stream", bridge)
        hosts.append(Host(bridge.address))
        hosts[-1].send(CONTROL, bytes([1]) + bytes(12))  # a stop, so it keeps the reserved place
        assert hosts[-1].receive()
        refused = run("info", "-p", bridge.address)
        assert refused.status == 1
        assert "all places of the bridge are in use" in refused.error
        for host in hosts:
            host.close()
