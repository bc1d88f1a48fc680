"""Tests of commands in small terminals, of messages above a status that changes, and of what differs between a
terminal and a pipe."""

from __future__ import annotations

import os
import subprocess
from contextlib import suppress
from pathlib import Path

import pytest

from bridge import host_of_bridge_in
from emulated_gimbal import emulated_gimbal
from sbgc_command import PROGRAM, run
from screens import terminal

NOBODY = "tcp:127.0.0.1:1"


@pytest.mark.parametrize("columns", ["40", "80", "200"])
def test_info_is_short(columns: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    with emulated_gimbal("--firmware", "2.70") as gimbal:
        short = run("info", "-p", gimbal.address)
        everything = run("info", "--all", "-p", gimbal.address)
    lines = short.text.splitlines() + short.error.splitlines()
    assert len(lines) <= 15 and all(len(line) <= int(columns) for line in lines), lines
    assert short.error == "(--all lists and explains everything)\n" and everything.error == ""
    assert "BOARD_FEATURE_MAG_SENSOR" in everything.text and " more" not in everything.text
    if columns == "80":
        assert "features       BOARD_FEATURE_3AXIS, " in short.text and " more\n" in short.text


def test_errors_are_wrapped_between_words_on_a_terminal_only(tmp_path: Path) -> None:
    error = run("info", "-p", NOBODY).error
    assert error.count("\n") == 1 and len(error) > 80
    with terminal(tmp_path, width=40, height=10) as shell:
        shell.run("info", "-p", NOBODY, ">/dev/null")
        lines = shell.wait("this port")
    (first,) = [i for i, line in enumerate(lines) if line.startswith("sbgc: ")]
    assert " ".join(line for line in lines[first:] if line and line != "$") == error.strip()


def test_the_parameters_are_paged_on_a_terminal(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path) as shell:
        shell.run("params", "show", "-p", gimbal.address)
        lines = shell.wait("^:$")
        assert lines[0].startswith("profile 1") and len(lines) == 24
        assert lines[1].startswith("pid: Gains of the controller (ReadParams3, ")
        shell.press("q")
        shell.wait(r"^\$ $|^\$$")
        shell.type("clear; PAGER='sed s/^/P./' ")
        shell.run("params", "show", "poles", "-p", gimbal.address)
        shell.wait("^P.  axes.yaw.poles    14")
        shell.type("clear; PAGER='there-is-no-pager' ")
        shell.run("params", "show", "poles", "-p", gimbal.address)
        shell.wait("not found\nprofile 1, .*\n(.*\n)*  axes.yaw.poles    14")


def test_what_differs_from_the_defaults(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.chdir(tmp_path)
    with emulated_gimbal() as gimbal:
        changed = ["params", "show", "--changed", "-p", gimbal.address]
        unknown = run(*changed)
        assert unknown.status == 1 and "are not known here; `sbgc params diff" in unknown.error
        assert run("params", "diff", "--defaults", "--yes", "-p", gimbal.address).status == 0
        assert run(*changed).text == "profile 1, which is active: the factory defaults\n"
        assert run("params", "set", "pitch.p=30", "--yes", "-p", gimbal.address).status == 0
        lines = run(*changed).text.splitlines()
        assert lines[0] == "profile 1, which is active"
        assert lines[2:] == ["  axes.pitch.p  30 (default 14)"]
        (json,) = run(*changed, "pitch.p", "--format", "json").text.split('"parameters": ')[1:]
        assert '"default": "14"' in json
    # Those of another board say nothing about this one.
    with emulated_gimbal("--firmware", "2.70") as other:
        assert run("params", "show", "--changed", "-p", other.address).status == 1


def test_a_jog_fits_into_a_small_terminal(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path, 40, 12) as shell:
        shell.run("jog", "--yes", "-p", gimbal.address)
        shell.wait(r"^roll -?\d+ pitch -?\d+ yaw -?\d+ 10 deg/s$")
        shell.wait("; q: quit$|^q: quit$")
        assert "down, right; z," in " ".join(shell.lines()), "no word is broken"
        shell.press("q")
        shell.wait("^The camera has stopped.$")


def test_a_bridge_that_loses_its_line(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path, width=160) as shell:
        host = host_of_bridge_in(shell, gimbal.address)
        gimbal.kill()
        shell.wait("^sbgc: connecting again")
        lines = [line for line in shell.wait(r"^(lost|searching), 1 host") if line]
        assert all(line.startswith(("sbgc: ", "bridge: ", "$ ")) for line in lines[:-1]), lines
        assert all(" | " not in line for line in lines[:-1]), "the status is the last line"
        host.close()


def test_frames_above_the_progress() -> None:
    with emulated_gimbal() as gimbal:
        command = [PROGRAM, "speed", "--yaw", "10", "--for", "1s", "--yes", "--verbose"]
        keyboard, screen = os.openpty()
        environment = {**os.environ, "NO_COLOR": "1"}
        with subprocess.Popen(
            [*command, "-p", gimbal.address], stderr=screen, env=environment
        ) as process:
            os.close(screen)
            written = b""
            with suppress(OSError):  # the other end is closed
                while part := os.read(keyboard, 65536):
                    written += part
            assert process.wait(20) == 0
        os.close(keyboard)
    assert b"turning for" in written and b"CMD_CONTROL (67)  host to board" in written
    # The rest of each line after the cursor has returned to its start.
    lines = [line.rstrip(b"\r").rsplit(b"\r", 1)[-1] for line in written.split(b"\n")]
    assert [line for line in lines if b"turning for" in line] == []


def test_a_capture_that_fails_does_not_disturb_the_monitor(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path) as shell:
        shell.type("ulimit -f 16")  # KiB; writing fails then
        shell.press("Enter")
        shell.run("monitor", "-p", gimbal.address, "--capture", "c")
        shell.wait("motor power")
        shell.press("4")
        lines = shell.wait("The capture c cannot be written: File too large")
        assert [line for line in lines if line.startswith("sbgc:")] == []
        shell.press("q")
        shell.wait("^sbgc: the capture is incomplete")
