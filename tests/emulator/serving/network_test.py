"""Tests of hosts that connect over TCP and UDP."""

from __future__ import annotations

import fcntl
import socket
import sys
import termios
import time
from pathlib import Path

import pytest

from emulator import (
    BOARD_INFO,
    BOARD_INFO_3,
    DATA_STREAM_INTERVAL,
    PATIENCE,
    REALTIME_DATA_4,
    Emulator,
    Terminal,
    refused,
    stream,
)
from sbgc_command import frame, two_free_ports


@pytest.mark.parametrize("protocol", ["tcp", "udp"])
def test_a_stream_goes_only_to_the_host_that_requested_it(protocol: str) -> None:
    with Emulator(f"--{protocol}", "0") as emulator:
        assert emulator.places[0].startswith(f"{protocol}:127.0.0.1:")
        host, other = emulator.host(), emulator.host()
        assert other.ask(BOARD_INFO)
        host.ask(DATA_STREAM_INTERVAL, stream(20), answer=REALTIME_DATA_4)
        assert not other.receive(0.2)


def test_a_ninth_host_is_refused_until_another_leaves() -> None:
    with Emulator("--tcp", "0") as emulator:
        hosts = [emulator.host() for _ in range(8)]
        for host in hosts:
            assert len(host.ask(BOARD_INFO)) == 18
        for _ in range(100):
            ninth = emulator.host()
            assert ninth.is_refused()
            ninth.close()
        hosts[3].close()
        end = time.monotonic() + PATIENCE
        while True:
            another = emulator.host()
            another.send(BOARD_INFO)
            if another.receive(PATIENCE):
                break
            another.close()  # the port is kept for a moment
            assert time.monotonic() < end
            time.sleep(0.05)
        emulator.end()
    # That does not fill the log.
    assert 5 <= emulator.error.count("refused: all 8 places for TCP are in use") < 50
    assert "further refusals in this second are not reported" in emulator.error


def timer_of(place: str) -> list[str]:
    """Returns kind and time of the kernel's timer for the only connection to a port."""
    port = f":{int(place.rpartition(':')[2]):04X}"
    timers = []
    for line in Path("/proc/net/tcp").read_text(encoding="utf-8").splitlines()[1:]:
        _, here, _, state, _, timer, *_ = line.split()
        if here.endswith(port) and state == "01":
            timers.append(timer.split(":"))
    (timer_of_it,) = timers
    return timer_of_it


POST = b"POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 6\r\n\r\n"
TLS = b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc"
NOISE = (b"G", b"\x16\x02\x03", b"GET", b"POSE ", b"DELET\x00")
FIRST = [(POST[:split], POST[split:], False) for split in (len(POST), 1, 3, 5)]
FIRST += [(TLS, b"", False), (TLS[:1], TLS[1:], False)]
FIRST += [(noise, b"", True) for noise in NOISE]


@pytest.mark.parametrize(("first", "then", "is_host"), FIRST)
def test_a_web_page_is_no_host(first: bytes, then: bytes, is_host: bool) -> None:
    """A browser sends frames in the body of a request, because a web page tells it to."""
    with Emulator("--tcp", "0") as emulator:
        host = emulator.host()
        host.socket.settimeout(PATIENCE)
        host.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        try:
            host.socket.sendall(first)
            time.sleep(0.02)  # so that the parts arrive one by one
            host.socket.sendall(then + frame(BOARD_INFO))
            assert is_host == bool(host.socket.recv(1))
        except ConnectionError:
            assert not is_host  # closed before it has sent all


def test_tcp_hosts_that_vanish_are_noticed() -> None:
    with Emulator("--tcp", "0") as emulator:
        host = emulator.host()
        assert host.ask(BOARD_INFO)
        end = time.monotonic() + PATIENCE
        kind, ticks = timer_of(emulator.places[0])
        while kind == "01":  # the acknowledgment of the response may be pending
            assert time.monotonic() < end
            kind, ticks = timer_of(emulator.places[0])
        assert kind == "02"  # the keep-alive timer
        assert int(ticks, 16) <= 10 * 100
        host.close()


def test_tcp_has_one_host_after_the_other() -> None:
    with Emulator("--tcp", "0") as emulator:
        for _ in range(40):
            host = emulator.host()
            assert host.ask(BOARD_INFO)
            host.close()
        emulator.end()
        assert emulator.error == ""


def test_tcp_host_that_sends_its_end_with_its_requests() -> None:
    with Emulator("--tcp", "0", "--baud", "9600") as emulator:
        host = emulator.host()
        for _ in range(20):
            host.send(BOARD_INFO_3)
        host.socket.shutdown(socket.SHUT_WR)
        while host.receive(PATIENCE):
            pass
        assert len(host.heard) == 20 * 74


def test_udp_leaves_places_for_tcp() -> None:
    with Emulator("--tcp", "0", "--udp", "0", places=2) as emulator:
        senders = [emulator.host(1) for _ in range(50)]
        for sender in senders:
            sender.send(BOARD_INFO)
        for sender in senders[:4]:
            assert len(sender.body(BOARD_INFO)) == 18
        hosts = [emulator.host() for _ in range(4)]
        for host in hosts:
            assert len(host.ask(BOARD_INFO)) == 18
        fifth = emulator.host()
        assert fifth.is_refused()
        # Transient hosts make room for a new one.
        newcomer = emulator.host(1)
        end = time.monotonic() + PATIENCE
        while not newcomer.receive(0.1):
            newcomer.send(BOARD_INFO)
            assert time.monotonic() < end
        emulator.end()
        assert "refused: all 4 places for UDP" in emulator.error
        assert "refused: all 4 places for TCP" in emulator.error


def test_udp_tells_once_of_a_host_that_is_refused() -> None:
    with Emulator("--udp", "0") as emulator:
        hosts = [emulator.host() for _ in range(9)]
        for host in hosts[:8] + hosts[:8]:  # twice, which makes them permanent
            assert len(host.ask(BOARD_INFO)) == 18
        for _ in range(100):
            hosts[8].send(BOARD_INFO)
        assert hosts[0].ask(BOARD_INFO)  # after all of them
        assert not hosts[8].receive(0)
        assert emulator.end() == 0
        assert emulator.error.count("refused") == 1


def test_udp_carries_whole_answers_and_no_more_than_fits() -> None:
    with Emulator("--udp", "0") as emulator:
        host = emulator.host()
        host.send(BOARD_INFO_3)
        assert len(host.socket.recv(65536)) == 74
        for _ in range(10):  # more than fit
            host.socket.send(frame(BOARD_INFO) * 800)
        end = time.monotonic() + PATIENCE
        while bytes([0x3E, BOARD_INFO_3, 69]) not in host.heard and time.monotonic() < end:
            host.send(BOARD_INFO_3)  # its response follows theirs
            host.receive(1)
        answers, rest = divmod(host.heard.count(bytes([0x3E, BOARD_INFO, 18])), 800)
        assert 1 <= answers < 10 and rest == 0


def test_udp_takes_a_large_datagram_when_nothing_waits() -> None:
    with Emulator("--udp", "0", "--baud", "57600") as emulator:
        host = emulator.host()
        # A busy machine reads late, and the system drops what does not fit.
        host.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 20)
        host.socket.send(frame(BOARD_INFO) * 900)
        while len(host.heard) < 900 * 23:
            assert host.receive(PATIENCE)
        assert len(host.heard) == 900 * 23


def test_udp_loses_a_datagram_when_an_earlier_one_waits() -> None:
    with Emulator("--udp", "0", "--baud", "300", "--verbose") as emulator:
        host = emulator.host()
        host.socket.send(frame(BOARD_INFO) * 900)  # takes minutes
        host.socket.send(frame(BOARD_INFO_3) * 800)
        assert emulator.process.stdout is not None
        while b"lost a datagram of 4000 bytes" not in emulator.process.stdout.readline():
            assert emulator.process.poll() is None


def test_ports_in_a_row() -> None:
    port = two_free_ports()
    with Emulator("--tcp", str(port), "--count", "2", boards=2) as emulator:
        assert emulator.places == [f"tcp:127.0.0.1:{port}", f"tcp:127.0.0.1:{port + 1}"]
        assert "cannot listen" in refused("--tcp", str(port))


def waiting_for(terminal: Terminal) -> int:
    """Returns the number of unread bytes."""
    size = fcntl.ioctl(terminal.fd, termios.FIONREAD, bytes(4))
    return int.from_bytes(size, sys.byteorder)


def test_a_host_that_does_not_read() -> None:
    with Emulator("--pty", "--tcp", "0", places=2) as emulator:
        terminal = Terminal(emulator.places[0])
        terminal.send(DATA_STREAM_INTERVAL, stream(1))
        other = emulator.host(1)
        # A pseudo-terminal buffers few samples and is soon full, while the other host still gets
        # responses.
        unchanged = before = 0
        end = time.monotonic() + PATIENCE
        while unchanged < 20:
            assert time.monotonic() < end
            assert other.ask(BOARD_INFO)
            now = waiting_for(terminal)
            unchanged = unchanged + 1 if now == before > 1000 else 0
            before = now
            time.sleep(0.01)
        assert terminal.body(REALTIME_DATA_4)
        terminal.close()


def test_other_machines_only_when_told() -> None:
    with Emulator("--tcp", "0.0.0.0:0") as emulator:
        emulator.end()
        assert "open to any other machine" in emulator.error
    with Emulator("--tcp", "localhost:0") as emulator:
        emulator.end()
        assert emulator.error == ""


def test_a_host_that_floods() -> None:
    with Emulator("--tcp", "0") as emulator:
        host = emulator.host()
        host.socket.settimeout(0.5)
        requests = frame(BOARD_INFO) * 10000
        with pytest.raises(socket.timeout):  # blocked by backpressure
            for _ in range(1000):
                host.socket.sendall(requests)
        other = emulator.host()
        assert other.ask(BOARD_INFO)
        status = Path(f"/proc/{emulator.process.pid}/status").read_text(encoding="utf-8")
        (size,) = (int(line.split()[1]) for line in status.splitlines() if line.startswith("VmRSS"))
        assert size < 500_000  # KiB; sanitizers need more
