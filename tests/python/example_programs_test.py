"""The programs of examples/python and of docs/15-python.md run."""

from __future__ import annotations

import asyncio
import builtins
import re
import subprocess
import sys
from pathlib import Path

import pytest

import nbformat
import sbgc
from nbclient.client import NotebookClient
from sbgc import Board, msg

EXAMPLES = Path(__file__).resolve().parents[2] / "examples" / "python"
sys.path.insert(0, str(EXAMPLES))

import draw  # noqa: E402
import follow_sine  # noqa: E402
import move  # noqa: E402


@pytest.mark.parametrize(("answer", "pitch"), [("y", 10), ("", 0)])
def test_the_camera_moves_only_if_the_user_agrees(
    answer: str, pitch: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(builtins, "input", lambda _: answer)
    with sbgc.emulator(noise=0, virtual_time=True) as board:
        move.main(board)
        assert board.angles.pitch == pytest.approx(pitch, abs=0.6)


def test_the_camera_follows_a_sine(board: Board) -> None:
    asyncio.run(follow_sine.follow(board, 1.0))
    # 5 degrees * sin(2 t) at its end, and the way that it needs to stop.
    assert 3.5 < board.angles.pitch < 6.5


def test_a_recording_shows_how_still_the_camera_is(tmp_path: Path) -> None:
    path = tmp_path / "capture.sbgc"
    with sbgc.emulator(motion="handheld", virtual_time=True) as board:
        with sbgc.connect(board, capture=path) as gimbal:
            gimbal.call(msg.MotorsOn())
            board.sleep(2)
            draw.record(gimbal, 2)
    table = sbgc.read_capture(path)[msg.RealtimeData4]
    assert table.rows >= 100
    assert table["frame_imu_angle.pitch"].std() > 10 * table["angle.pitch"].std()


def test_the_notebook_compares_two_boards() -> None:
    notebook = nbformat.read(EXAMPLES / "compare.ipynb", as_version=4)  # type: ignore[no-untyped-call]
    NotebookClient(notebook, timeout=60).execute()
    printed = "".join(
        output.get("text", "") for cell in notebook.cells for output in cell.get("outputs", [])
    )
    assert "axes.pitch.p" in printed and "axes.roll.p" not in printed


GUIDE = Path(__file__).resolve().parents[2] / "docs" / "15-python.md"
PROGRAMS = re.findall(r"^```python\n(.*?)^```$", GUIDE.read_text(), re.DOTALL | re.MULTILINE)
OUTPUT = ["20", "", "True 1", "", "int16", "604 20", "axes.pitch.angle: 800 deg does not fit"]


def test_there_are_programs() -> None:
    assert len(PROGRAMS) == len(OUTPUT)


@pytest.mark.parametrize("number", range(len(PROGRAMS)))
def test_programs_run(number: int, tmp_path: Path) -> None:
    command = [sys.executable, "-W", "error", "-c", PROGRAMS[number]]
    done = subprocess.run(
        command, capture_output=True, text=True, timeout=60, check=False, cwd=tmp_path
    )
    assert done.returncode == 0 and not done.stderr, done.stderr
    assert OUTPUT[number] in done.stdout
