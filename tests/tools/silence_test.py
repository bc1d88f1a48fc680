"""What the board did not confirm is no success: the commands say so, and end with status 3."""

from __future__ import annotations

from pathlib import Path

import pytest

from closed_terminal_test import CASES, CHANGING, prepare
from emulated_gimbal import emulated_gimbal
from relay import relay_to
from sbgc_command import run

SCRIPT, MENU, DEFAULTS, NAMES, SAVE, BATTERY, CONTROL = 57, 69, 70, 29, 32, 66, 67
SENT = "the board did not confirm it"
COMMANDS: dict[str, tuple[int, int, str]] = {
    "script stop 1": (SCRIPT, 3, SENT),
    "menu look_down --yes": (MENU, 3, SENT),
    "menu profile2 --yes": (MENU, 3, SENT),
    "vars set P_ROLL=33 --save --yes": (SAVE, 3, SENT),
    "calibrate battery actual_voltage=12 --yes --no-check": (BATTERY, 3, SENT),
    "params reset --profile 3 --yes": (DEFAULTS, 3, f"{SENT}, and profile 3 is as before"),
    "params diff --defaults --yes": (DEFAULTS, 3, SENT),
    "params rename 2 Studio --yes": (NAMES, 1, "did not confirm ReadProfileNames, and it reads"),
    "speed --yaw 10 --for 200ms --yes": (CONTROL, 3, "nothing shows that the camera has turned"),
    "send CMD_RUN_SCRIPT --yes": (SCRIPT, 0, SENT),
}


@pytest.mark.parametrize("command", COMMANDS)
def test_silence_is_no_success(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lost, status, sentence = COMMANDS[command]
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    with (
        emulated_gimbal("--firmware", "2.59") as gimbal,
        relay_to(gimbal.address, lambda data: b"" if data[1] == lost else data) as address,
    ):
        if lost == CONTROL:
            assert run("motors", "on", "--yes", "-p", gimbal.address).status == 0
        done = run(*command.split(), "--timeout", "600ms", "-p", address)
        assert done.status == status, done.error
        assert sentence in " ".join(done.error.split())
        assert not (tmp_path / "sbgc").exists(), "no defaults are kept"


# `send` does not wait for what a request does, and what stands already is stopped. `jog` has no end.
@pytest.mark.parametrize("name", sorted(set(CASES) - {"send", "stop", "script stop", "jog"}))
def test_no_command_succeeds_without_its_effect(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    case = CASES[name]
    monkeypatch.chdir(tmp_path)
    board = ("--board", "3.6", "--firmware", case.firmware)
    with (
        emulated_gimbal(*board) as gimbal,
        relay_to(gimbal.address, lambda data: b"" if data[1] in CHANGING else data) as address,
    ):
        prepare(name, gimbal, tmp_path)
        words = [*name.split(), *case.arguments.format(folder=tmp_path).split()]
        done = run(*words, "--yes", "--timeout", "600ms", "-p", address)
        assert done.status in (1, 3) and done.error, done
