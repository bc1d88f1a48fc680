"""Tests of sbgc doctor over lines; doctor_test.cpp tests its judgment."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterator
from typing import Any

import pytest

from bridge import bridge_to
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import MODEL, PROGRAM, run


@pytest.fixture(name="shaking", scope="module")
def one_that_shakes() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal("--fault", "resonance=37Hz:0.5:pitch") as gimbal:
        yield gimbal


def examined(address: str, *found: str) -> dict[str, Any]:
    """Returns a report with these findings. A busy machine, or a camera that has just started, can
    add or hide some, but not each time."""
    for _ in range(6):
        result = run("doctor", "--for", "1s", "--format", "json", "-p", address)
        report: dict[str, Any] = json.loads(result.out) if result.out else {"findings": []}
        if [finding["id"] for finding in report["findings"]] == list(found):
            assert result.status == 1
            return report
    raise AssertionError((report, result.error))


def test_a_resonance_is_named(shaking: EmulatedGimbal) -> None:
    report = examined(shaking.address, "vibration")
    (finding,) = report["findings"]
    assert (finding["id"], finding["axis"], finding["command"]) == (
        "vibration",
        "pitch",
        "sbgc tune pitch",
    )
    assert report["sampling"]["how"] == "stream"
    assert report["sampling"]["rate_hz"] == 250
    assert report["sampling"]["highest_hz"] == pytest.approx(0.45 * 250)
    assert report["axes"]["pitch"]["frequencies"][0]["hz"] == pytest.approx(37, abs=1)
    assert report["thresholds"]["resonance"]["value"] == 0.05


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


def test_old_firmware_is_asked_for_each_sample() -> None:
    with emulated_gimbal("--firmware", "2.43b9", "--fault", "resonance=6Hz:3") as gimbal:
        report = examined(gimbal.address, "vibration")
    assert report["sampling"]["how"] == "polls"
    assert report["axes"]["pitch"]["frequencies"][0]["hz"] == pytest.approx(6, abs=1)


def test_the_stream_of_another_host_stays() -> None:
    slow = ("--fault", "resonance=6Hz:3:pitch")
    with emulated_gimbal(*slow) as gimbal, bridge_to(gimbal.address) as shared:
        other = ("stream", "RealtimeDataCustom", "--with", "IMU_ANGLES", "--rate", "20")
        with subprocess.Popen(
            [PROGRAM, *other, "--format", "jsonl", "-p", shared.address], stdout=subprocess.PIPE
        ) as watching:
            assert watching.stdout is not None
            watching.stdout.readline()
            report = examined(shared.address, "vibration")
            assert report["sampling"]["how"] == "polls", "the stream has another configuration"
            watching.terminate()
            samples = [json.loads(line) for line in watching.stdout]
            assert len(samples) > 10, "it went on meanwhile"
            assert all("imu_angles" in json.dumps(sample) for sample in samples)
            pace = (samples[-1]["time"] - samples[0]["time"]) / (len(samples) - 1)
            assert pace == pytest.approx(0.05, rel=0.2)


def test_as_text() -> None:
    with emulated_gimbal() as gimbal:
        for _ in range(6):
            result = run("doctor", "--for", "1s", "-p", gimbal.address)
            if result.status == 0:
                break
    text = " ".join(result.text.split())
    assert "250 times per second (a data stream), 0.0 % lost, which shows frequencies up to" in text
    assert text.endswith("Nothing is wrong.")


def test_thresholds_need_no_gimbal() -> None:
    result = run("doctor", "--thresholds")
    assert result.status == 0
    assert "assumptions" in result.text and "resonance " in result.text


@pytest.mark.parametrize("time", ["500ms", "11m"])
def test_the_time_has_bounds(time: str) -> None:
    result = run("doctor", "--for", time, "-p", "tcp:127.0.0.1:1")
    assert result.status == 2 and "--for is from 1 s to 10 minutes" in result.error
