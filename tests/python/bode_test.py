"""Frequency responses: recordings, files, and gain and phase."""

from __future__ import annotations

import asyncio
import math
from pathlib import Path

import pytest

import sbgc
from sbgc import msg


def request(samples: int = 5000) -> msg.BodeTestStartStopRequest:
    return msg.BodeTestStartStopRequest(
        axis=msg.BodeAxis.ROLL,
        stimulus_type=msg.BodeStimulus.WHITE_NOISE,
        stimulus_gain=3000,
        start_freq=6,
        end_freq=200,
        system=msg.BodeSystem.OPEN_LOOP_PLANT,
        samples_num=samples,
    )


def test_a_recording_shows_the_resonance(tmp_path: Path) -> None:
    seen: list[tuple[int, int]] = []
    with sbgc.emulator(virtual_time=True) as board:
        with sbgc.connect(board) as gimbal:
            gimbal.call(msg.MotorsOn())
            recording = gimbal.record_bode(
                request(), progress=lambda done, total, what: seen.append((done, total))
            )
    assert (len(recording.input), len(recording.output), recording.lost) == (5000, 5000, 0)
    assert not recording.end_lost
    assert seen and seen[-1][1] == 5000
    points = recording.response()
    assert len(points) == 159
    certain = [point for point in points if (point.coherence or 0) > 0.9]
    strongest = max(certain, key=lambda point: point.gain)
    assert 30 < strongest.frequency < 45
    assert strongest.gain == pytest.approx(20 * math.log10(abs(strongest.response)))
    file = tmp_path / "roll.csv"
    file.write_text(recording.csv())
    again = sbgc.read_bode(file)
    assert again.request.start_freq == 6 and again.response() == points


def test_asynchronously() -> None:
    async def record() -> sbgc.BodeRecording:
        async with sbgc.aio.connect(board) as gimbal:
            await gimbal.call(msg.MotorsOn())
            recording = await gimbal.record_bode(request(64))
            with pytest.raises(TimeoutError, match="it took more than 0 s"):
                await gimbal.record_bode(request(5000), timeout=0)
            return recording

    with sbgc.emulator() as board:
        assert len(asyncio.run(record()).input) == 64


def test_a_board_that_refuses_is_an_error() -> None:
    with sbgc.emulator(virtual_time=True) as board:
        with sbgc.connect(board) as gimbal:
            gimbal.call(msg.MotorsOff())
            with pytest.raises(sbgc.GimbalError, match="starting the recording"):
                gimbal.record_bode(request())


def test_a_lost_sample_and_a_broken_file(tmp_path: Path) -> None:
    file = tmp_path / "lost.csv"
    file.write_text("%sbgc_test_data;70;0;1;3000;6;200\n1;2\nnan;nan\n")
    recording = sbgc.read_bode(file)
    assert recording.lost == 1 and math.isnan(recording.output[1]) and not recording.response()
    file.write_text("1;2\n")
    with pytest.raises(ValueError, match="lost.csv: line 1: not a frequency response"):
        sbgc.read_bode(file)
    with file.open("wb") as large:
        large.truncate(1 << 40)  # bytes that take no space
    with pytest.raises(ValueError, match="lost.csv: .*the file is too long"):
        sbgc.read_bode(str(file))
