"""Tests of what `sbgc decode` says about frames that came through a terminal that is not in raw mode."""

from __future__ import annotations

import os
import select
import termios

import pytest

from sbgc_command import MODEL, frame, run

MODE = "the port is not in raw mode"


def cooked(data: bytes) -> bytes:
    """Returns what a program reads from a new terminal of Linux to which these bytes come."""
    board, port = os.openpty()
    try:
        assert termios.tcgetattr(port)[3] & termios.ICANON
        os.write(board, data + b"\n")  # it gives whole lines
        received = b""
        while not received.endswith(b"\n"):
            assert select.select([port], [], [], 20)[0]
            received += os.read(port, 4096)
        while select.select([port], [], [], 0)[0]:
            received += os.read(port, 4096)
        return received[:-1]
    finally:
        os.close(board)
        os.close(port)


def sized_frames() -> list[tuple[str, bytes]]:
    """A frame of each message of one size, with its command."""
    return [
        (message["command"], frame(message["id"], bytes(message["min_size"])))
        for message in MODEL["messages"]
        if message["min_size"] == message["max_size"]
    ]


def test_a_changed_header_is_named() -> None:
    removed, replaced = set(), set()
    for command, whole in sized_frames():
        received = cooked(whole)
        if received == whole:
            continue
        text = run("decode", stdin=received).text
        if len(received) == len(whole) - 1:
            (place,) = [i for i in range(len(whole)) if whole[:i] + whole[i + 1 :] == received]
            said, found = f"0x{whole[place]:02x}, is missing: {MODE}", removed
        elif len(received) == len(whole):
            (place,) = [i for i in range(len(whole)) if whole[i] != received[i]]
            said, found = f"0x{whole[place]:02x}, has become 0x0a: {MODE}", replaced
        else:
            continue  # a byte that erases others
        assert text.splitlines()[1].startswith(f"    @0: looks like {command} ("), text
        assert said in text, (whole.hex(), text)
        found.add(whole[place])
    assert removed == {0x04, 0x12, 0x13, 0x16} and replaced == {0x0D}


@pytest.mark.parametrize("data", ["3e55670a00", "3e01130000", "3e958413"])
def test_other_bytes_are_not_explained_so(data: str) -> None:
    """No command has such a header."""
    assert "raw mode" not in run("decode", "--hex", stdin=data).text
