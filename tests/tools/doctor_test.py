"""Tests of sbgc doctor over lines; tests/doctor tests its judgment."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from bridge import bridge_to
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import MODEL, PROGRAM, run
from screens import terminal


@pytest.fixture(name="shaking", scope="module")
def one_that_shakes() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal("--fault", "resonance=37Hz:0.5:pitch") as gimbal:
        yield gimbal


def examined(address: str, duration: str = "2s") -> dict[str, Any]:
    result = run("doctor", "--for", duration, "--format", "json", "-p", address)
    assert result.out, result.error
    report: dict[str, Any] = json.loads(result.out)
    assert result.status == (1 if report["findings"] else 0)
    return report


def test_a_resonance_is_named(shaking: EmulatedGimbal) -> None:
    report = examined(shaking.address)
    # A camera that has just started may have others.
    (finding,) = [one for one in report["findings"] if one.get("axis") == "pitch"]
    assert (finding["id"], finding["command"]) == ("vibration", "sbgc tune pitch")
    assert report["sampling"]["how"] == "stream"
    assert report["sampling"]["rate_hz"] == 250 and report["sampling"]["second_rate_hz"] == 200
    assert report["sampling"]["highest_hz"] == pytest.approx(0.45 * 250)
    first = report["axes"]["pitch"]["frequencies"][0]
    # Noise at the other rate decides what it may be an alias of; tests with seeds look at that.
    assert first["hz"] == pytest.approx(37, abs=1)
    assert report["thresholds"]["resonance"]["value"] == 0.035


def test_an_alias_is_no_frequency() -> None:
    with emulated_gimbal("--fault", "resonance=213Hz:0.5:pitch") as gimbal:
        for _ in range(4):
            report = examined(gimbal.address, "4s")
            first = report["axes"]["pitch"]["frequencies"][0]
            if len(first["or_hz"]) == 1:
                break
            # On a busy machine, the samples at the other rate may have gaps, but not each time.
            assert first["hz"] == pytest.approx(37, abs=1) and len(first["or_hz"]) > 1
    assert first["hz"] is None and first["seen_at_hz"] == pytest.approx(37, abs=1)
    assert first["or_hz"] == [pytest.approx(213, abs=1)]
    (text,) = [one["sentence"] for one in report["findings"] if one.get("axis") == "pitch"]
    assert re.search(r"shakes at 21[23]\.\d Hz \(an alias at 3[67]\.\d Hz\)", text)


def test_it_only_reads(shaking: EmulatedGimbal) -> None:
    effects = {m["command"]: m for m in MODEL["messages"] if m["direction"] == "to_board"}
    result = run("doctor", "--for", "1s", "-v", "-p", shaking.address)
    sent = {
        word
        for line in result.error.splitlines()
        if "host to board" in line
        for word in line.split()
        if word in effects
    }
    assert "CMD_REALTIME_DATA_4" in sent, result.error
    assert sent <= {
        *("CMD_BOARD_INFO", "CMD_BOARD_INFO_3", "CMD_REALTIME_DATA_3", "CMD_REALTIME_DATA_4"),
        *("CMD_READ_PARAMS_3", "CMD_CALIB_INFO", "CMD_DATA_STREAM_INTERVAL"),
    }


# The results of polling depend on the speed of the machine; tests/doctor tests them in virtual
# time.


def test_the_stream_of_another_host_stays() -> None:
    with emulated_gimbal() as gimbal, bridge_to(gimbal.address) as shared:
        other = ("stream", "RealtimeDataCustom", "--with", "IMU_ANGLES", "--rate", "20")
        with subprocess.Popen(
            [PROGRAM, *other, "--format", "jsonl", "-p", shared.address], stdout=subprocess.PIPE
        ) as watching:
            assert watching.stdout is not None
            watching.stdout.readline()
            report = examined(shared.address)
            assert report["sampling"]["how"] == "polls", "the stream has another configuration"
            watching.terminate()
            samples = [json.loads(line) for line in watching.stdout]
            assert len(samples) > 10, "it went on meanwhile"
            assert all("imu_angles" in json.dumps(sample) for sample in samples)
            pace = (samples[-1]["time"] - samples[0]["time"]) / (len(samples) - 1)
            assert pace == pytest.approx(0.05, rel=0.2)


def test_a_narrow_terminal(tmp_path: Path) -> None:
    with emulated_gimbal("--fault", "imu") as gimbal, terminal(tmp_path, 40, 60) as shell:
        shell.run("doctor", "--for", "1s", "-p", gimbal.address)
        lines = shell.wait("1. The board reports ERR_NO_SENSOR")
        first = lines.index(next(line for line in lines if "motor power" in line))
        table = lines[first : first + 5]
        names = ["motor power", "balance error", "vibration", "  strongest", "  with"]
        assert [line.split(",")[0] for line in table] == names, "no row is broken"
