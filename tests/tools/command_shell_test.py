"""Tests of sbgc shell."""

from __future__ import annotations

import os
import signal
import subprocess
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from emulated_gimbal import emulated_gimbal
from gimbal_observer import observer_of
from sbgc_command import PROGRAM, Result, decode, run
from screens import Terminal, terminal

TURN = "speed --yaw 20 --for 100s --yes\n"
SOON = 2.5


@pytest.fixture(autouse=True)
def history(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "kept"))
    return tmp_path / "kept" / "sbgc" / "history"


def shell(address: str, *lines: str, options: tuple[str, ...] = ()) -> Result:
    return run("shell", "-p", address, *options, stdin="\n".join(lines) + "\n")


def test_the_commands_of_a_file_have_one_connection(tmp_path: Path) -> None:
    capture = tmp_path / "c"
    with emulated_gimbal() as gimbal:
        result = shell(
            gimbal.address,
            *("# the gains", "", "params get pitch.p  # of one axis", "sbgc params get 'roll.p'"),
            *("stream --rate 10 --for 0.3s", "describe bat_level", "exit", "nonsense"),
            options=("--capture", str(capture)),
        )
    assert result.status == 0, result
    assert "axes.pitch.p = 14" in result.text and "axes.roll.p = 12" in result.text
    assert "angle.roll[deg]" in result.text and "Battery voltage" in result.text
    frames = decode(capture.read_bytes())
    assert {line["session"] for line in frames} == {0}
    assert sum(line["command"] == "CMD_READ_PARAMS_3" for line in frames) >= 4


@pytest.mark.parametrize(
    "line, status, reason",
    [
        ("nonsense", 2, "unknown command 'nonsense'"),
        ("params get 'pitch.p", 2, "a quote has no end"),
        ("shell", 2, "this is the shell"),
        ("motors off", 1, "there is no terminal to ask on; add --yes"),
        ("params show --profile 9", 2, "--profile"),
    ],
)
def test_the_first_failure_ends_a_file(line: str, status: int, reason: str) -> None:
    with emulated_gimbal() as gimbal:
        result = shell(gimbal.address, "ports", line, "describe bat_level")
    assert result.status == status and reason in result.error, result
    assert "sbgc: line 2 failed; what follows was not run" in result.error
    assert "Battery" not in result.text


def test_options_of_the_shell_hold_for_its_commands() -> None:
    with emulated_gimbal() as gimbal, emulated_gimbal("--firmware", "2.70") as other:
        result = shell(gimbal.address, "send CMD_GET_ANGLES", options=("--verbose",))
        assert "CMD_GET_ANGLES (73)  host to board" in result.error
        result = shell(gimbal.address, f"info -p {other.address}", "info")
        assert result.text.index("2.70") < result.text.index("2.59"), "a gimbal of its own"
        assert gimbal.address[4:] in result.text and "pts" not in result.text, "the real line"


def begin(terminal_of_test: Terminal, address: str) -> None:
    terminal_of_test.run("shell", "-p", address)
    terminal_of_test.wait("^sbgc>$")


def test_a_line_with_a_password_is_neither_run_nor_kept(tmp_path: Path, history: Path) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path) as screen:
        begin(screen, gimbal.address)
        screen.enter("send CMD_PASS_PROTECT_WRITE new_password=Sesam77")
        screen.wait("^sbgc: new_password is secret")
        screen.enter("describe bat_level")
        # The key ends the shell at its prompt only.
        screen.wait("Battery voltage(?s:.*)^sbgc>$")
        screen.press("C-d")
        screen.wait(r"^sbgc> \^D\n\$")
    kept = history.read_text("utf-8")
    assert "describe" in kept and "Sesam" not in kept


def test_the_greeting_is_wrapped_between_words(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path, 40, 10) as screen:
        begin(screen, gimbal.address)
        lines = [line.rstrip() for line in screen.lines()]
    assert "`help` lists the commands; Ctrl-D or" in lines and "`exit` ends." in lines


def leave_line(screen: Terminal) -> None:
    """Presses Ctrl-C, again if libedit has lost it: it does in the moment before it reads a key."""
    for _ in range(5):
        screen.press("C-c")
        with suppress(AssertionError):
            screen.wait("^sbgc>$", 4)
            return
    raise AssertionError("Ctrl-C does not end the line")


def test_keys_on_a_terminal(tmp_path: Path, history: Path) -> None:
    (tmp_path / "some file").touch()
    with emulated_gimbal() as gimbal, terminal(tmp_path) as screen:
        before = screen.state()
        begin(screen, gimbal.address)
        for keys in ("par", "ge", "pitch.pole"):
            screen.type(keys)
            screen.press("Tab")
        screen.wait("^sbgc> params get pitch.poles")
        screen.press("Enter")
        screen.wait(r"^axes\.pitch\.poles = 14")
        screen.type("params get pitch.po")
        screen.press("Tab")
        screen.wait(r"^pitch\.poles +pitch\.power\nsbgc> params get pitch\.po")
        leave_line(screen)
        screen.type("decode som")
        screen.press("Tab")
        screen.wait(r"^sbgc> decode some\\ file")
        leave_line(screen)
        # Ctrl-C ends a command, not the shell.
        screen.enter("stream --rate 5")
        screen.wait(r"^ +\d\.\d+ ( +-?\d\.\d+){3}")
        screen.press("C-c")
        screen.wait(r"\^C.*\n(.*\n)?sbgc>$")
        screen.enter("motors off")
        screen.wait(r"Continue\? \[y/N\]")
        screen.enter("n")
        screen.wait("^sbgc: not confirmed\nsbgc>$")
        screen.press("C-d")
        screen.wait(r"^sbgc> \^D\n\$")
        assert screen.state() == before
        assert history.stat().st_mode & 0o777 == 0o600
        screen.enter("clear")
        begin(screen, gimbal.address)
        screen.press("Up")
        screen.wait("^sbgc> motors off")


def test_a_lost_connection_is_restored_by_the_next_command(tmp_path: Path) -> None:
    with terminal(tmp_path) as screen:
        with emulated_gimbal() as gimbal:
            begin(screen, gimbal.address)
        port = gimbal.address.rsplit(":", 1)[1]
        with emulated_gimbal("--tcp", port):
            screen.enter("params get pitch.poles")
            lines = screen.wait(r"^axes\.pitch\.poles = 14")
    said = " ".join(lines)
    assert "sbgc: " in said and ("connected again" in said or "connecting again" in said), lines


@pytest.mark.parametrize("how", ["command", "shell", "group", "SIGTERM"])
def test_the_camera_stops_whatever_is_killed(how: str) -> None:
    with emulated_gimbal() as gimbal, observer_of(gimbal) as observer:
        process = turning_shell(gimbal.address)
        observer.await_motion()
        if how == "group":
            os.killpg(process.pid, signal.SIGKILL)
        elif how == "shell":
            process.kill()
        elif how == "SIGTERM":
            process.terminate()
        else:
            os.kill(command_of(process.pid), signal.SIGKILL)
        assert observer.stands_still_within(SOON)
        assert process.stdin is not None
        process.stdin.close()
        process.wait(30)


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP, signal.SIGINT, signal.SIGQUIT])
def test_a_signal_for_the_shell_alone_interrupts_its_command(number: signal.Signals) -> None:
    with emulated_gimbal() as gimbal, observer_of(gimbal) as observer:
        process = turning_shell(gimbal.address)
        observer.await_motion()
        process.send_signal(number)
        _, error = process.communicate(timeout=30)
        assert process.returncode == 130 and b"the camera has stopped" in error, error
        # The guard of the shell does not end the motion of the next program.
        result = run("speed", "--yaw", "20", "--for", "2s", "--yes", "-p", gimbal.address)
        assert result.status == 0, result


def turning_shell(address: str) -> subprocess.Popen[Any]:
    """Starts a shell that turns the camera, and waits for more lines."""
    process: subprocess.Popen[Any] = subprocess.Popen(
        [PROGRAM, "shell", "-p", address],
        stdin=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True,
    )  # fmt: skip
    assert process.stdin is not None
    process.stdin.write(TURN.encode())
    process.stdin.flush()
    return process


def command_of(shell_process: int) -> int:
    """Returns the command that the shell runs; its other child is a guard."""
    children = Path(f"/proc/{shell_process}/task/{shell_process}/children").read_text().split()
    (command,) = [
        int(child)
        for child in children
        if Path(f"/proc/{child}/cmdline").read_bytes().startswith(b"sbgc\0")
    ]
    return command
