"""Tests of sbgc bridge with several hosts at one emulated gimbal."""

from __future__ import annotations

import os
import resource
import signal
import socket
import subprocess
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from bridge import (
    BOARD_INFO,
    DATA_STREAM_INTERVAL,
    GET_ANGLES,
    RESET,
    TOKEN,
    Bridge,
    Host,
    bridge_to,
    host_of_bridge_in,
    shared_gimbal,
    stream_request,
)
from emulated_gimbal import emulated_gimbal
from relay import relay_to
from sbgc_command import PROGRAM, frame, run
from screens import terminal
from web_socket import WebSocket


@pytest.fixture(scope="module", params=["tcp", "pty"])
def bridge(request: pytest.FixtureRequest) -> Iterator[Bridge]:
    options = ("--pty",) if request.param == "pty" else ()
    with emulated_gimbal(*options) as gimbal, bridge_to(gimbal.address_with_rate) as running:
        yield running


def test_two_hosts_that_ask_at_once(bridge: Bridge) -> None:
    """Each gets exactly its own answers, in its own order."""
    hosts = [Host(bridge.address) for _ in range(2)]
    counts = [0, 0]

    def ask_often(index: int) -> None:
        for i in range(50):
            command = (GET_ANGLES, BOARD_INFO)[(i + index) % 2]
            hosts[index].ask(command)
            counts[index] += 1

    threads = [threading.Thread(target=ask_often, args=(index,)) for index in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(timeout=30)
    assert counts == [50, 50]
    for host in hosts:  # nothing more has come
        host.socket.settimeout(0.05)
        with pytest.raises(TimeoutError):
            host.socket.recv(1)
        host.close()


def test_a_host_that_does_not_read_blocks_no_other(bridge: Bridge) -> None:
    deaf, other = Host(bridge.address), Host(bridge.address)
    deaf.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    deaf.send(DATA_STREAM_INTERVAL, stream_request(1))
    # It asks until the system takes no more.
    deaf.socket.setblocking(False)
    requests = frame(BOARD_INFO) * 1000
    with pytest.raises(BlockingIOError):
        while True:
            deaf.socket.send(requests)
    for _ in range(20):
        assert other.ask(GET_ANGLES)
    deaf.close()
    other.close()


def test_several_places() -> None:
    with shared_gimbal("--tcp", "0", "--udp", "0", "--pty") as bridge:
        assert len(bridge.addresses) == 3
        for address in bridge.addresses:
            result = run("info", "-p", address)
            assert result.status == 0, result


def test_hosts_stay_when_the_gimbal_is_started_again() -> None:
    with emulated_gimbal() as gimbal, bridge_to(gimbal.address) as bridge:
        host = Host(bridge.address)
        host.send(DATA_STREAM_INTERVAL, stream_request(20))
        host.receive_samples(3)
        gimbal.kill()
        bridge.wait_for("connecting again")
        port = gimbal.address.rsplit(":", 1)[1]
        with emulated_gimbal("--tcp", port):
            host.receive_samples(3)
            host.close()


def test_a_host_that_restarts_the_board_has_the_line_for_itself() -> None:
    with shared_gimbal() as bridge:
        assert run("reset", "-p", bridge.address, "--yes").status == 0
        assert run("info", "-p", bridge.address, "--timeout", "20").status == 0
        bridge.process.send_signal(signal.SIGINT)
        _, log = bridge.process.communicate(timeout=20)
    assert "has the line for itself while the board restarts" in log
    assert "all hosts have the line again" in log
    assert "unplugged" not in log


def test_the_status_on_a_terminal(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path, width=160) as shell:
        host = host_of_bridge_in(shell, gimbal.address)
        host.send(RESET, bytes(3))
        shell.wait(r"^connected, 1 host \| host 0 has the line for itself \| 0: 2 in, [12] out$")
        host.close()


def test_it_shows_who_comes_and_goes() -> None:
    with shared_gimbal() as bridge:
        host = Host(bridge.address)
        bridge.wait_for("is host 0")
        host.close()
        bridge.wait_for("has left")


def test_a_web_page_is_no_program() -> None:
    with shared_gimbal() as bridge:
        page = Host(bridge.address)
        page.socket.sendall(b"POST / HTTP/1.1\r\n\r\n" + frame(BOARD_INFO))
        bridge.wait_for("refused: it sent an HTTP request")
        page.close()


def test_a_line_that_dies_silently_is_replaced() -> None:
    is_silent = threading.Event()

    def pass_on(data: bytes) -> bytes:
        return b"" if is_silent.is_set() else data

    with emulated_gimbal() as gimbal, relay_to(gimbal.address, pass_on, pass_on) as address:
        with bridge_to(address) as bridge:
            host = Host(bridge.address)
            assert host.ask(BOARD_INFO)
            is_silent.set()
            for _ in range(3):
                host.send(GET_ANGLES)
            bridge.wait_for("does not respond")
            is_silent.clear()
            bridge.wait_for("TCP connection")
            assert host.ask(BOARD_INFO)
            host.close()


@pytest.mark.parametrize(
    "command",
    [
        ["bridge", "--tcp", "0"],
        ["stream", "RealtimeData4"],
        ["record", "out.capture", "--stream", "RealtimeData4"],
    ],
)
def test_ctrl_c_ends_the_connecting(command: list[str], tmp_path: Path) -> None:
    """The line is open, but nobody answers."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        address = f"tcp:127.0.0.1:{server.getsockname()[1]}"
        with subprocess.Popen(
            [PROGRAM, *command, "-p", address],
            cwd=tmp_path,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        ) as process:
            line, _ = server.accept()
            assert line.recv(100)
            process.send_signal(signal.SIGINT)
            # A shell says 130 for both.
            assert process.wait(timeout=3) in (130, -signal.SIGINT)
            line.close()


def test_a_place_in_use() -> None:
    with emulated_gimbal() as gimbal:
        port = gimbal.address.rsplit(":", 1)[1]
        result = run("bridge", gimbal.address, "--tcp", port)
        assert result.status == 1
        assert "cannot listen" in result.error


@pytest.fixture(scope="module")
def web() -> Iterator[Bridge]:
    options = ("--token", TOKEN, "--origin", "http://localhost:8000")
    with shared_gimbal("--tcp", "0", "--ws", "0", *options) as bridge:
        yield bridge


def web_address(bridge: Bridge) -> str:
    return bridge.addresses[1]


@pytest.mark.parametrize(
    ("query", "origin", "protocols", "status"),
    [
        (f"?token={TOKEN}", None, None, 101),
        (f"?a=b&token={TOKEN}", None, None, 101),
        ("", None, f"sbgc, token.{TOKEN}", 101),
        (f"?token={TOKEN}", "http://localhost:8000", None, 101),
        (f"?token={TOKEN}", "http://evil.example", None, 403),
        (f"?token={TOKEN}", "null", None, 403),
        ("", "http://localhost:8000", None, 401),
        ("", None, None, 401),
        ("?token=", None, None, 401),
        (f"?token={TOKEN}x", None, None, 401),
        (f"?token={TOKEN[:-1]}", None, None, 401),
        ("", None, "sbgc, token.wrong", 401),
        ("", None, f"token.{TOKEN}", 400),
        # Only the first would have been looked at.
        (f"?token={TOKEN}", "http://localhost:8000\r\nOrigin: http://evil.example", None, 400),
        (f"?token={TOKEN}", "http://localhost:8000\r\nOrigin: http://localhost:8000", None, 400),
    ],
)
def test_only_those_who_may_connect_over_a_web_socket(
    web: Bridge, query: str, origin: str | None, protocols: str | None, status: int
) -> None:
    connection = WebSocket(web_address(web), query, origin, protocols)
    assert connection.status == status
    if protocols is not None and status == 101:
        assert connection.headers["sec-websocket-protocol"] == "sbgc"
    connection.close()


def test_a_web_socket_is_a_host_like_others(web: Bridge) -> None:
    page = WebSocket(web_address(web), f"?token={TOKEN}")
    host = Host(web.address)
    request = frame(BOARD_INFO)
    page.send(request[:3])
    page.send(request[3:] + frame(GET_ANGLES))
    data = b""
    while len(data) < 4 or len(data) < 5 + data[2] + 5 + 18:
        opcode, message = page.receive()
        assert opcode == 2
        data += message
    assert data[1] == BOARD_INFO and data[5 + data[2] + 1] == GET_ANGLES
    assert host.ask(BOARD_INFO) == data[4 : 4 + data[2]]
    page.close()
    host.close()


def test_text_and_long_messages_end_a_web_socket(web: Bridge) -> None:
    for data, opcode in ((b"hello", 1), (bytes(20000), 2)):
        page = WebSocket(web_address(web), f"?token={TOKEN}")
        page.send(data, opcode)
        assert page.receive()[0] == 8  # close
        page.close()


def test_what_is_no_web_socket_is_refused(web: Bridge) -> None:
    host, port = web_address(web).removeprefix("ws://").split("/")[0].rsplit(":", 1)
    with socket.create_connection((host, int(port)), timeout=20) as connection:
        connection.sendall(b"GET / HTTP/1.1\r\nHost: x\r\n\r\n")
        assert b"426" in connection.recv(1000).splitlines()[0]


def test_a_web_socket_waits_for_the_response(web: Bridge) -> None:
    """A frame after the request would be read as bytes of the protocol."""
    page = WebSocket(web_address(web), f"?token={TOKEN}", behind=frame(GET_ANGLES))
    assert page.status == 400
    page.close()


def test_a_bridge_without_free_descriptors_waits() -> None:
    """Accepting fails at once then, again and again. The kernel holds the connections."""
    with shared_gimbal("--tcp", "0", "--ws", "0", "--token", TOKEN) as bridge:
        host, port = web_address(bridge).removeprefix("ws://").split("/")[0].rsplit(":", 1)
        process = bridge.process.pid
        used = len(list(Path(f"/proc/{process}/fd").iterdir()))
        resource.prlimit(process, resource.RLIMIT_NOFILE, (used + 2, used + 2))
        idle = [socket.create_connection((host, int(port)), timeout=20) for _ in range(10)]
        bridge.wait_for("ws: Too many open files")
        before = processor_ticks(process)
        time.sleep(1)
        assert processor_ticks(process) - before < os.sysconf("SC_CLK_TCK") / 2
        for connection in idle:
            connection.close()


def processor_ticks(process: int) -> int:
    fields = Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()
    return int(fields[11]) + int(fields[12])


def test_idle_connections_keep_no_web_socket_out(web: Bridge) -> None:
    host, port = web_address(web).removeprefix("ws://").split("/")[0].rsplit(":", 1)
    idle = [socket.create_connection((host, int(port)), timeout=20) for _ in range(100)]
    page = WebSocket(web_address(web), f"?token={TOKEN}")
    assert page.status == 101
    idle[0].settimeout(20)
    assert idle[0].recv(1) == b""  # the oldest had to leave
    for one in idle:
        one.close()
    page.close()


def test_a_web_socket_without_a_place_that_sends_a_text() -> None:
    """Both are reasons to close it."""
    with shared_gimbal("--tcp", "0", "--udp", "0", "--ws", "0", "--token", TOKEN) as bridge:
        hosts = [Host(bridge.address) for _ in range(16)]
        assert all(host.ask(BOARD_INFO) for host in hosts)
        _, address, port = bridge.addresses[1].split(":")
        senders = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(16)]
        for sender in senders:
            sender.settimeout(20)
            sender.connect((address, int(port)))
            sender.send(frame(BOARD_INFO))
            assert sender.recv(100)
        for _ in range(50):  # the text arrives before or while the place is refused
            page = WebSocket(bridge.addresses[2], f"?token={TOKEN}")
            page.send(b"hello", 1)
            assert page.receive()[0] == 8
            page.close()
        assert hosts[0].ask(BOARD_INFO)
        for one in [*hosts, *senders]:
            one.close()


def test_refusals_are_reported_a_few_at_a_time() -> None:
    with shared_gimbal("--ws", "0", "--token", TOKEN) as bridge:
        for _ in range(10):
            page = WebSocket(bridge.address, "?token=wrong")
            assert page.status == 401
            page.close()
        reports = bridge.wait_for("further refusals in this second")
        assert sum("does not know the token" in line for line in reports) == 5


@pytest.mark.parametrize(
    ("origin", "shown"),
    [("http://~a.example", "http://~a.example"), ("http://b.\u00fc", "http://b.??")],
)
def test_the_origin_of_a_refused_page_is_reported_printably(origin: str, shown: str) -> None:
    with shared_gimbal("--ws", "0", "--token", TOKEN) as bridge:
        page = WebSocket(bridge.address, f"?token={TOKEN}", origin)
        assert page.status == 403
        page.close()
        line = bridge.wait_for("refused")[-1]
        assert f"refused: pages of '{shown}' are not allowed; see --origin" in line


def test_the_token_of_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SBGC_TOKEN", TOKEN)
    with shared_gimbal("--ws", "0") as bridge:
        assert TOKEN not in bridge.addresses[0]
        page = WebSocket(bridge.addresses[0], f"/?token={TOKEN}")
        assert page.status == 101
        page.close()
    monkeypatch.setenv("SBGC_TOKEN", "short")
    result = run("bridge", "tcp:127.0.0.1:9", "--ws", "0")
    assert result.status == 2 and "SBGC_TOKEN: a token has at least 8" in result.error


def test_a_token_is_made_and_printed() -> None:
    with shared_gimbal("--ws", "0") as bridge:
        address = bridge.addresses[0]
        token = address.split("?token=")[1]
        assert len(token) == 32
        page = WebSocket(address, f"?token={token}")
        assert page.status == 101
        page.close()
