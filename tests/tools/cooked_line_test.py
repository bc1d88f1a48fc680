"""Tests of what `sbgc decode` says about frames that came through a terminal that is not in raw mode."""

from __future__ import annotations

import os
import select
import termios

import pytest

from sbgc_command import MODEL, frame, run

GET_ANGLES = frame(73)
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


@pytest.mark.parametrize(
    "body, said",
    [
        # CMD_CONFIRM; the checksum of the body is removed, or a byte of it, or one is replaced.
        (bytes([0x10, 0x02]), "0x12, is missing: the next frame begins in its place, as on a port"),
        (bytes([0x43, 0x13]), "; or it is there, and 0x13 is missing in the body, as on a port"),
        (bytes([0x11, 0x43]), "; or it is there, and 0x11 is missing in the body, as on a port"),
        (bytes([0x43, 0x0D]), "; it fits if 0x0d has become 0x0a, as on a port that is not in raw"),
        (bytes([0x43, 0x0D, 0x0A, 0x0D, 0]), "; it fits if 0x0d has become 0x0a, as on a port"),
        (bytes([0x0C, 0x01]), "; it fits if 0x0d has become 0x0a, as on a port that is not in raw"),
    ],
)
def test_a_changed_body_is_named(body: bytes, said: str) -> None:
    received = cooked(frame(67, body) + GET_ANGLES)
    assert received.endswith(GET_ANGLES) and frame(67, body) not in received
    text = run("decode", stdin=received).text
    assert "@0: looks like CMD_CONFIRM (67) from the board" in text and said in text


def test_what_a_user_saw() -> None:
    said = "a body of 18 bytes, but its size, 0x12, is missing: the port is not in raw mode"
    for data in ("3e56680a00", "3e5668"):
        for form in ("text", "jsonl"):
            result = run("decode", "--format", form, "--hex", stdin=data)
            assert result.status == 1
            assert said in (result.text if form == "text" else result.error)
            assert "baud rate" not in result.error


@pytest.mark.parametrize("data", ["3e55670a00", "3e01130000", "3e958413"])
def test_other_bytes_are_not_explained_so(data: str) -> None:
    """No command has such a header."""
    assert "raw mode" not in run("decode", "--hex", stdin=data).text
