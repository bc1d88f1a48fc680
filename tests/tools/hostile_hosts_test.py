"""Hosts that send anything to `sbgc emulate` and `sbgc bridge`; another host is served meanwhile."""

from __future__ import annotations

import random
import socket
import struct
from collections.abc import Callable

import pytest

from bridge import Host, bridge_to, shared_gimbal
from emulated_gimbal import emulated_gimbal
from sbgc_command import frame
from web_socket import WebSocket

BOARD_INFO = 86
TOKEN = "0123456789abcdef"
ROUNDS = 60


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
