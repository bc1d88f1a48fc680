"""The sbgc command: wrong usage, input that can not be read, output that can not be written."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from sbgc_command import frame, run

GET_ANGLES = frame(73)
LINE = '{"message":"GetAnglesRequest","fields":{}}\n'


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["nonsense"],
        ["decode", "--format", "xml"],
        ["decode", "--format"],
        ["decode", "--from", "mars"],
        ["decode", "--nonsense"],
        ["decode", "one", "two"],
        ["encode", "--from", "host"],
        ["encode", "one", "two"],
        ["ports", "--format", "jsonl"],
        ["ports", "one"],
        ["record"],
        ["record", "pty:"],
        ["record", "pty:", "file", "--seconds", "soon"],
    ],
)
def test_wrong_usage(arguments: list[str]) -> None:
    result = run(*arguments)
    assert result.status == 2
    assert result.out == b""


@pytest.mark.parametrize(
    "arguments",
    [["--help"], ["--help-all"]]
    + [[command, "--help"] for command in ("decode", "emulate", "encode", "ports", "record")],
)
def test_help(arguments: list[str]) -> None:
    result = run(*arguments)
    assert result.status == 0
    assert "Usage" in result.text


@pytest.mark.parametrize("command", ["decode", "encode"])
def test_input_that_can_not_be_read(command: str, tmp_path: Path) -> None:
    missing = run(command, str(tmp_path / "missing"))
    assert missing.status == 1 and str(tmp_path / "missing") in missing.error
    folder = run(command, str(tmp_path))
    assert folder.status == 1 and str(tmp_path) in folder.error
    empty = run(command, "")
    assert empty.status == 1
    if os.geteuid() != 0:
        secret = tmp_path / "secret"
        secret.write_bytes(GET_ANGLES)
        secret.chmod(0)
        assert run(command, str(secret)).status == 1


@pytest.mark.parametrize(
    "text, place",
    [
        ("3e4", "line 1 column 3"),
        ("3e 4 9", "line 1 column 5"),
        ("3e49\n00 zz", "line 2 column 4"),
        ("3e 4\n", "line 1"),
        ("# ok\n3e 49 00 49 00\n\n3e;", "line 4 column 3"),
        ("\x01", "line 1 column 1"),
    ],
)
def test_text_that_is_not_hex(text: str, place: str) -> None:
    result = run("decode", "--hex", "--format", "jsonl", stdin=text)
    assert result.status == 1
    assert place in result.error


def test_what_stands_before_a_bad_digit_is_decoded_once() -> None:
    for text in ("3e49004900 3e49004900 3", "3e49004900 3e49004900 x"):
        result = run("decode", "--hex", "--format", "jsonl", stdin=text)
        assert result.status == 1
        assert [line["offset"] for line in result.objects] == [0, 5]


@pytest.mark.parametrize("command, stdin", [("decode", GET_ANGLES), ("encode", LINE.encode())])
def test_output_that_can_not_be_written(command: str, stdin: bytes) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("no /dev/full")
    with open("/dev/full", "wb") as full:
        for amount in (1, 2000):
            result = run(command, stdin=stdin * amount, stdout=full.fileno())
            assert result.status == 1
            assert "output" in result.error or "write" in result.error
