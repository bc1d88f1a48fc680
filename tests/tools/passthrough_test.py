"""Tests of the host of `sbgc bridge` that has the line for itself: a board in its bootloader sends any bytes."""

from __future__ import annotations

import os
import socket
import threading
import time
import tty
from pathlib import Path

import pytest

from bridge import TOKEN, Host, bridge_to
from emulated_gimbal import emulated_gimbal
from sbgc_command import Running, frame
from web_socket import WebSocket

BOOT_MODE = 51


class Bootloader:
    """A TCP server that passes bytes to a gimbal until it is asked to start its bootloader, which then sends
    these bytes, as fast as they are read."""

    def __init__(self, address: str, sends: bytes) -> None:
        self.gimbal = address.split(":")[1:]
        self.sends = sends
        self.server = socket.create_server(("127.0.0.1", 0))
        self.address = f"tcp:127.0.0.1:{self.server.getsockname()[1]}"
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self) -> None:
        while True:
            try:
                client, _ = self.server.accept()
            except OSError:
                return
            threading.Thread(target=self.pass_on, args=(client,), daemon=True).start()

    def pass_on(self, client: socket.socket) -> None:
        board = socket.create_connection((self.gimbal[0], int(self.gimbal[1])))

        def pass_back() -> None:
            while data := board.recv(4096):
                client.sendall(data)

        thread = threading.Thread(target=pass_back, daemon=True)
        thread.start()
        try:
            while (data := client.recv(4096)) and frame(BOOT_MODE) not in data:
                board.sendall(data)
            board.shutdown(socket.SHUT_RDWR)
            thread.join()
            if data:
                client.sendall(self.sends)
                client.recv(1)
        except OSError:
            pass
        board.close()
        client.close()


def numbered_bytes(size: int) -> bytes:
    """Bytes of which none is the start of a frame, and of which every few are different."""
    return b"".join(b"%07d\n" % i for i in range(size // 8))


def test_a_slow_host_gets_all_bytes_of_a_bootloader() -> None:
    sends = numbered_bytes(300_000)
    with emulated_gimbal() as gimbal:
        board = Bootloader(gimbal.address, sends)
        with bridge_to(board.address) as bridge:
            host = Host(bridge.address)
            host.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            host.send(BOOT_MODE)
            received = b""
            while len(received) < len(sends):
                time.sleep(0.001)
                part = host.stream.read1(4096)
                assert part
                received += part
            assert received == sends
            host.close()
        board.server.close()


@pytest.mark.parametrize("place", ["--tcp", "--ws"])
def test_a_host_that_does_not_read_a_bootloader_must_leave(place: str) -> None:
    sends = numbered_bytes(32 << 20)  # more than all buffers on the way
    options = ("--token", TOKEN) if place == "--ws" else ()
    with emulated_gimbal() as gimbal:
        board = Bootloader(gimbal.address, sends)
        with bridge_to(board.address, place, "0", *options) as bridge:
            if place == "--ws":
                page = WebSocket(bridge.address, f"?token={TOKEN}")
                page.send(frame(BOOT_MODE))
                bridge.wait_for("must leave: it does not read what the board sends")
                received = b""
                while (message := page.receive())[0] == 2:
                    received += message[1]
                assert message[0] == 8, "the connection ends"
                page.close()
            else:
                host = Host(bridge.address)
                host.send(BOOT_MODE)
                bridge.wait_for("must leave: it does not read what the board sends")
                received = host.stream.read()  # up to the end of the connection
                host.close()
            bridge.wait_for("has left")
            assert 1 << 20 <= len(received) < len(sends)
            assert sends.startswith(received)
        board.server.close()


def test_a_terminal_whose_program_does_not_read_a_bootloader_is_replaced(tmp_path: Path) -> None:
    link = tmp_path / "gimbal"
    with emulated_gimbal() as gimbal:
        board = Bootloader(gimbal.address, numbered_bytes(32 << 20))
        with bridge_to(board.address, "--tcp", "0", "--link", str(link)) as bridge:
            before = link.resolve()
            terminal_of_host = os.open(link, os.O_RDWR | os.O_NOCTTY)
            tty.setraw(terminal_of_host)
            os.write(terminal_of_host, frame(BOOT_MODE))
            bridge.wait_for(f"{before} was closed for its program; now there is /dev/pts/")
            with pytest.raises(OSError):
                while os.read(terminal_of_host, 65536):
                    pass
                raise OSError("the end")
            os.close(terminal_of_host)
            assert link.exists()
        board.server.close()


def test_a_replay_waits_for_slow_hosts_but_not_for_ever(tmp_path: Path) -> None:
    sends = frame(73) + numbered_bytes(32 << 20)
    (tmp_path / "bytes").write_bytes(sends)
    with Running("replay", str(tmp_path / "bytes"), "--tcp", "0") as replay:
        address = replay.address()
        deaf, slow = Host(address), Host(address)
        received = slow.stream.read(1 << 20)
        replay.wait_for("host 0 must leave: it does not read")
        received += slow.stream.read()
        assert len(received) > 16 << 20 and sends.endswith(received), "all since it has connected"
        heard = deaf.stream.read()
        assert 1 << 20 <= len(heard) < len(sends) and sends.startswith(heard)
        deaf.close()
        slow.close()
        assert replay.wait(20) == 0
