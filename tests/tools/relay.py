"""A relay between a host and an emulated gimbal, which can lose or delay what passes."""

from __future__ import annotations

import socket
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

Change = Callable[[bytes], bytes]


def frames_in(data: bytes) -> Iterator[tuple[int, bytes]]:
    """The ids and bodies of whole frames of either framing."""
    at = 0
    while at + 4 < len(data):
        command, size = data[at + 1], data[at + 2]
        assert data[at : at + 1] in (b">", b"$") and data[at + 3] == (command + size) % 256
        yield command, data[at + 4 : at + 4 + size]
        at += 4 + size + (1 if data[at : at + 1] == b">" else 2)


def pass_on(source: socket.socket, target: socket.socket, change: Change) -> None:
    """Carries until one of them ends, and then ends the other."""
    try:
        while data := source.recv(4096):
            target.sendall(change(data))
    except OSError:
        pass  # the other side has closed, or its process was killed
    for one in (source, target):
        with suppress(OSError):
            one.shutdown(socket.SHUT_RDWR)


def _serve(
    listener: socket.socket, gimbal: tuple[str, int], change: Change, answers: Change
) -> None:
    while True:
        try:
            host, _ = listener.accept()
        except OSError:
            return  # the test is over
        board = socket.create_connection(gimbal)
        for source, target, kind in ((host, board, change), (board, host, answers)):
            threading.Thread(target=pass_on, args=(source, target, kind), daemon=True).start()


@contextmanager
def relay_to(address: str, change: Change, answers: Change = bytes) -> Iterator[str]:
    """Yields an address that leads to a gimbal.

    `change` sees what hosts send, a frame at a time; `answers` sees what the gimbal sends.
    """
    _, place, port = address.split(":")
    with socket.create_server(("127.0.0.1", 0)) as listener:
        arguments = (listener, (place, int(port)), change, answers)
        threading.Thread(target=_serve, args=arguments, daemon=True).start()
        yield f"tcp:127.0.0.1:{listener.getsockname()[1]}"
        listener.shutdown(socket.SHUT_RDWR)
