"""Tests that need matplotlib and pandas; `./dev test python --long` runs them."""

from __future__ import annotations

import sys
from pathlib import Path

import sbgc
from sbgc import msg

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "examples" / "python"))

import draw  # noqa: E402


def test_a_recording_is_drawn_and_becomes_a_table_of_pandas(tmp_path: Path) -> None:
    capture, picture = tmp_path / "capture.sbgc", tmp_path / "picture.png"
    draw.main("", str(capture), str(picture), seconds=3)
    assert picture.read_bytes().startswith(b"\x89PNG") and picture.stat().st_size > 10_000
    table = sbgc.read_capture(capture)[msg.RealtimeData4]
    frame = table.to_pandas()
    assert frame.index.name == "time" and len(frame) == table.rows >= 150
    assert frame["angle.pitch"].tolist() == table["angle.pitch"].tolist()
    assert frame["frame_imu_angle.pitch"].std() > 10 * frame["angle.pitch"].std()
