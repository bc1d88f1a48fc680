"""Tests of messages on a terminal whose last line is a status that changes."""

from __future__ import annotations

import os
import subprocess
from contextlib import suppress
from pathlib import Path

from bridge import host_of_bridge_in
from emulated_gimbal import emulated_gimbal
from sbgc_command import PROGRAM
from screens import terminal


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
    # What remains of each line after the cursor has gone back to its begin.
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
