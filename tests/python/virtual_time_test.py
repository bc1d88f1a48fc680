"""The blocking client and the emulated board in virtual time, and the fixtures of the package."""

from __future__ import annotations

import math
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

import sbgc
from sbgc import Board, Gimbal, GimbalTimeout, aio, msg
from sbgc.testing import emulator_options as emulator_options
from sbgc.testing import gimbal as gimbal
from sbgc.testing import gimbal_board as gimbal_board


def test_a_move_takes_the_time_of_the_board(gimbal: Gimbal, gimbal_board: Board) -> None:
    gimbal.call(msg.MotorsOn())
    start = gimbal_board.time
    moved = gimbal.move_to(pitch=30, speed=10)
    assert moved.is_close
    assert moved.elapsed == pytest.approx(gimbal_board.time - start, abs=0.1)
    assert 3 < moved.elapsed < 5
    assert gimbal_board.angles.pitch == pytest.approx(30, abs=0.6)


def test_ten_minutes_take_seconds(gimbal: Gimbal, gimbal_board: Board) -> None:
    real, start = time.process_time(), gimbal_board.time
    gimbal_board.sleep(600)
    assert gimbal_board.time == pytest.approx(start + 600)
    # A second with optimization; the tests are built without.
    assert time.process_time() - real < 8


def test_everything_happens_in_the_same_way_each_time() -> None:
    def seen() -> list[Any]:
        with sbgc.emulator(motion="handheld", lost=0.002, virtual_time=True) as board:
            with sbgc.connect(board) as gimbal:
                gimbal.call(msg.MotorsOn())
                with gimbal.stream(msg.RealtimeData4, 0.01) as samples:
                    bodies = [sbgc.encode_body(next(samples)) for _ in range(100)]
                gimbal.move_to(yaw=5, speed=20)
                return [*bodies, board.time, board.angles, board.speeds]

    assert seen() == seen()


def test_speeds_that_nobody_refreshes_end(gimbal: Gimbal, gimbal_board: Board) -> None:
    gimbal.call(msg.MotorsOn())
    with gimbal.speed_control(silence=0.5) as control:
        control.set(yaw=20)
        gimbal_board.sleep(0.4)
        assert gimbal_board.speeds.yaw == pytest.approx(20, abs=1)
        gimbal_board.sleep(1)
        assert gimbal_board.speeds.yaw == pytest.approx(0, abs=1)
        with pytest.raises(sbgc.GimbalError, match="has been stopped"):
            control.refresh()
        with pytest.warns(RuntimeWarning, match="was called for 500 ms"):
            control.set(yaw=20)
        gimbal_board.sleep(0.4)
        assert gimbal_board.speeds.yaw == pytest.approx(20, abs=1)
        gimbal.stop()
        with pytest.raises(sbgc.GimbalSuperseded):
            control.set(yaw=20)
        control.set(yaw=20)


def test_a_silent_line_ends_calls_at_their_timeout() -> None:
    with sbgc.emulator(silences=[(1, 1000)], virtual_time=True) as board:
        with sbgc.connect(board) as gimbal:
            board.sleep(2)
            start = board.time
            with pytest.raises(GimbalTimeout):
                gimbal.call(msg.GetAnglesRequest(), timeout=3)
            assert board.time - start == pytest.approx(3, abs=0.05)


def test_a_board_restarts_when_it_is_told_to() -> None:
    with sbgc.emulator(restart_at=5, virtual_time=True) as board, sbgc.connect(board) as gimbal:
        stored = gimbal.get_variable("LPF_FREQ_ROLL")
        gimbal.set_variables({"LPF_FREQ_ROLL": stored + 1})
        assert gimbal.get_variable("LPF_FREQ_ROLL") == stored + 1
        board.sleep(8)
        assert gimbal.get_variable("LPF_FREQ_ROLL") == stored


def test_faults_damage_frames(tmp_path: Path) -> None:
    path = tmp_path / "capture.sbgc"
    with sbgc.emulator(bit_errors=1e-3, text_every=0.5, virtual_time=True) as board:
        with sbgc.connect(board, capture=path) as gimbal:
            with gimbal.stream(msg.RealtimeData3, 0.02, timeout=60) as samples:
                for _ in range(50):
                    next(samples)
    capture = sbgc.read_capture(path)
    counters = capture.counters[sbgc.Direction.FROM_BOARD]
    assert counters.body_errors > 5 and counters.skipped_bytes > 500
    times = capture[msg.RealtimeData3]["time"]
    assert times[-1] - times[0] > 0.9 and all(math.isclose(t, round(t, 6)) for t in times)


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ({"lost": 1.5}, "lost: 0 to 1 are possible, not 1.5"),
        ({"noise": math.nan}, "noise: 0 to 1000 are possible, not nan"),
        ({"seed": -1}, "seed: 0 to 4294967295 are possible, not -1"),
        ({"silences": [(-1, 2)]}, "silences: 0 to"),
        ({"board": "x"}, "x"),
        ({"firmware": "9.9"}, "no version of firmware"),
        ({"motion": "nowhere.csv"}, "nowhere.csv"),
    ],
    ids=lambda one: "",
)
def test_wrong_arguments_are_errors(arguments: Any, text: str) -> None:
    with pytest.raises(ValueError, match=text):
        sbgc.emulator(**arguments)


def test_asyncio_waits_in_real_time(gimbal_board: Board) -> None:
    with pytest.raises(ValueError, match="asyncio waits in real time"):
        aio.connect(gimbal_board)


def test_the_fixtures_are_a_plugin_of_pytest(tmp_path: Path) -> None:
    (tmp_path / "conftest.py").write_text('pytest_plugins = ["sbgc.testing"]\n')
    (tmp_path / "some_test.py").write_text(
        """
import pytest

@pytest.fixture
def emulator_options():
    return {"firmware": "2.74"}

def test_firmware(gimbal, gimbal_board):
    assert gimbal.identity.firmware == "2.74" and gimbal_board.has_virtual_time
"""
    )
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-W", "error"]
    done = subprocess.run(
        [*command, tmp_path], capture_output=True, text=True, timeout=60, check=False
    )
    assert "1 passed" in done.stdout, done.stdout + done.stderr
