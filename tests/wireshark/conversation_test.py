"""Tests the dissector's tracking of conversations: requests, contexts, values out of range."""

from __future__ import annotations

import struct
from pathlib import Path

import pytest

from line import CARRIERS, DECODE_AS, Packet, shown, tshark
from sbgc_command import frame, run

BOARD, HOST = 1, 2


def encoded(message: str, fields: str) -> bytes:
    """A frame from the names of values, by `sbgc encode`."""
    text = f'{{"message":"{message}","fields":{fields}}}'
    return run("encode", "--defaults", "--no-validate", stdin=text).out


@pytest.mark.parametrize("carrier", CARRIERS)
def test_responses_belong_to_requests(carrier: str, tmp_path: Path) -> None:
    info, confirm = frame(86, bytes(18)), frame(67, b"\x4d")
    packets = [
        Packet(frame(86), HOST),
        Packet(frame(77), HOST),
        Packet(confirm, BOARD),  # of the second request
        Packet(info, BOARD),
        Packet(info, BOARD),  # of none
    ]
    (tmp_path / "packets").write_bytes(CARRIERS[carrier](packets))
    found = list(shown(tmp_path / "packets", "-2", *DECODE_AS))
    first = found[0].packet
    numbers = [(one.text("sbgc.request_in"), one.text("sbgc.response_in")) for one in found]
    assert numbers == [
        ("", str(first + 3)),
        ("", str(first + 2)),
        (str(first + 1), ""),
        (str(first), ""),
        ("", ""),
    ]
    assert float(found[3].text("sbgc.response_time")) == pytest.approx(0.003)


def test_samples_are_decoded_with_the_flags_of_the_request(tmp_path: Path) -> None:
    sample = struct.pack("<H3h", 7, 100, 200, 300)
    packets = [
        Packet(frame(88, sample), BOARD),
        Packet(encoded("RealtimeDataCustomRequest", '{"flags":"IMU_ANGLES"}'), HOST),
        Packet(frame(88, sample), BOARD),
        Packet(encoded("RealtimeDataCustomRequest", '{"flags":"GYRO_DATA"}'), HOST),
        Packet(frame(88, sample), BOARD),
        Packet(frame(88, sample), BOARD, host=40001),  # another session knows nothing
    ]
    (tmp_path / "packets").write_bytes(CARRIERS["line"](packets))
    for passes in ([], ["-2"]):
        found = [o for o in shown(tmp_path / "packets", *passes) if o.text("sbgc.direction") == "0"]
        angles = [one.text("sbgc.realtime_data_custom.imu_angles.pitch.raw") for one in found]
        gyro = [one.text("sbgc.realtime_data_custom.gyro_data.pitch.raw") for one in found]
        assert (angles, gyro) == (["", "200", "", ""], ["", "", "200", ""])
        assert [bool(one.all("sbgc.realtime_data_custom.tail")) for one in found] == [
            True,
            False,
            False,
            True,
        ]


def test_the_request_decides_between_answers_of_one_size(tmp_path: Path) -> None:
    answer = Packet(frame(46, bytes.fromhex("00201200c00000c03f6400000010c0")), BOARD)
    asked = [Packet(frame(46, bytes(size)), HOST) for size in (7, 2)]
    (tmp_path / "packets").write_bytes(
        CARRIERS["line"]([answer, asked[0], answer, asked[1], answer])
    )
    for passes in ([], ["-2"]):
        found = [o for o in shown(tmp_path / "packets", *passes) if o.text("sbgc.direction") == "0"]
        floats = [one.text("sbgc.adj_vars_state_ext.analog_var_value") for one in found]
        integers = [one.text("sbgc.adj_vars_state.analog_value") for one in found]
        assert (floats, integers) == (["", "1.5", ""], ["1069547520", "", "1069547520"])


def test_what_is_wrong_is_expert_information(tmp_path: Path) -> None:
    good = frame(86)
    packets = [
        Packet(good[:-1] + b"\x01", HOST),  # a wrong checksum
        Packet(frame(1), HOST),  # no such command
        Packet(frame(67, bytes(3)), HOST),  # no such form
        Packet(frame(67, b"\x0e" + bytes(12)), HOST),  # a value without a name
        Packet(encoded("BeepSound", '{"note_length":0,"note_freq_hz":[1]}'), HOST),  # out of range
        Packet(frame(86, bytes(17)), BOARD),  # too short
        Packet(good + b"\x07" + good, HOST),
    ]
    (tmp_path / "packets").write_bytes(CARRIERS["line"](packets))
    found = list(shown(tmp_path / "packets"))
    experts = [one.experts - {"tail"} for one in found]
    assert experts[0] == {"skipped", "checksum"}
    assert experts[1:3] == [{"unknown"}, {"unknown"}]
    assert experts[3] == {"value"} and experts[4] == {"range"} and experts[5] == {"malformed"}
    assert experts[6:] == [set(), {"skipped"}, set()]
    texts = [str(one.get("showname")) for one in found[3].fields]
    assert any("no name for 14; the nearest: MODE_" in text for text in texts)


def test_the_column_tells_what_happens(tmp_path: Path) -> None:
    move = encoded(
        "Control",
        '{"control_mode":"MODE_ANGLE","axes":{"pitch":{"angle":1365,"speed":82}}}',
    )
    (tmp_path / "packets").write_bytes(CARRIERS["line"]([Packet(move, HOST)]))
    text = tshark(tmp_path / "packets", "-Tfields", "-e_ws.col.Info").splitlines()
    assert text == [
        "a session begins",
        "> Control moves: MODE_ANGLE, pitch 29.9927 deg down at 10.0101 deg/s",
    ]


@pytest.mark.parametrize(("others", "is_known"), [(998, True), (1000, False)])
def test_the_oldest_conversation_is_forgotten_first(
    others: int, is_known: bool, tmp_path: Path
) -> None:
    ask = encoded("RealtimeDataCustomRequest", '{"flags":"IMU_ANGLES"}')
    sample = frame(88, struct.pack("<H3h", 7, 100, 200, 300))
    packets = [
        Packet(ask, HOST),
        *(Packet(frame(86), HOST, host=41000 + number) for number in range(others)),
        Packet(sample, BOARD),
        Packet(sample, BOARD, host=41000 + others - 1),  # which has asked for something else
    ]
    (tmp_path / "packets").write_bytes(CARRIERS["udp"](packets))
    found = list(shown(tmp_path / "packets", *DECODE_AS, "-Y", "sbgc.direction == 0"))
    angles = [one.text("sbgc.realtime_data_custom.imu_angles.pitch.raw") for one in found]
    assert angles == ["200" if is_known else "", ""]
