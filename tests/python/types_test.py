"""The classes of messages: construction, attributes, errors, text."""

from __future__ import annotations

import copy
import pickle
import pydoc
from collections.abc import Callable, Iterator

import pytest

import sbgc
from sbgc import DecodeError, Direction, FieldError, Parser, decode, encode, msg, validate


def test_fields_are_in_their_units_with_the_raw_number_beside() -> None:
    axis = msg.ControlAxis(speed=10, angle=-30)
    assert axis.angle == pytest.approx(-30, abs=0.02)
    assert axis.angle_raw == -1365
    axis.angle_raw = 4096
    assert axis.angle == 90
    assert str(axis) == "ControlAxis{speed = 10.0101 deg/s, angle = 90 deg}"
    assert msg.ControlAxis(angle_raw=4096).angle == 90
    with pytest.raises(TypeError, match="angle and angle_raw are the same field"):
        msg.ControlAxis(angle=1, angle_raw=4096)


def test_representations_are_read_by_python_as_the_same_value() -> None:
    names = {**vars(sbgc), **vars(msg)}
    for value in (
        msg.Control(
            control_mode=msg.ControlMode(mode=msg.ControlModeKind.MODE_ANGLE),
            axes=msg.Axes(pitch=msg.ControlAxis(angle=30)),
        ),
        msg.BeepSound(note_freq_hz=[600, 700], mode=msg.BeepModes(0x8001)),
        msg.GetAngles(),
        msg.BoardErrorCode(211),
        msg.BoardFeatures(0),
    ):
        assert eval(repr(value), names) == value, repr(value)


def test_help_shows_units_and_directions() -> None:
    text = pydoc.plain(pydoc.render_doc(msg.ControlAxis))
    assert "Target angle;" in text and "Unit: deg. Positive pitch is down" in text
    assert "The number on the wire for angle." in text


def test_a_message_is_made_with_keywords_and_changed_in_place() -> None:
    message = msg.Control(
        control_mode=msg.ControlMode(mode=msg.ControlModeKind.MODE_ANGLE),
        axes=msg.Axes(pitch=msg.ControlAxis(angle=30)),
    )
    assert message.axes.roll.angle == 0
    assert message.axes.pitch.angle == pytest.approx(30, abs=0.02)
    pitch = message.axes.pitch
    pitch.angle = 10
    assert message.axes.pitch.angle == pytest.approx(10, abs=0.02)
    assert decode(encode(message), Direction.TO_BOARD) == message


def test_a_speed_keeps_its_size_in_the_unit_that_a_flag_selects() -> None:
    fine = msg.ControlMode(flags=msg.ControlFlags.CONTROL_FLAG_HIGH_RES_SPEED)
    message = msg.Control(control_mode=fine, axes=msg.Axes(yaw=msg.ControlAxis(speed=10)))
    assert message.axes.yaw.speed == pytest.approx(10.01, abs=0.001)  # in steps of a structure
    message.axes.yaw.speed = 10
    assert message.axes.yaw.speed_raw == 10000


def test_messages_are_matched_by_their_fields() -> None:
    match msg.BeepSound(note_length=24):
        case msg.BeepSound(note_length=length):
            assert length == 24
        case _:
            pytest.fail("no match")


def test_axes_are_matched_by_position_too() -> None:
    match msg.Axes(1, 2, 3):
        case msg.Axes(1, pitch, 3):
            assert pitch == 2
        case _:
            pytest.fail("no match")


def test_values_of_another_type_are_errors() -> None:
    with pytest.raises(TypeError, match="control_mode: ControlMode is needed, not ControlFlags"):
        msg.Control(control_mode=msg.ControlFlags.CONTROL_FLAG_HIGH_RES_SPEED)
    with pytest.raises(TypeError, match="control_mode: ControlMode is needed, not FirmwareVersion"):
        msg.Control(control_mode=msg.FirmwareVersion(2740))
    with pytest.raises(TypeError, match="^speed: a number is needed, not ControlMode"):
        msg.ControlAxis(speed=msg.ControlModeKind.MODE_ANGLE)
    with pytest.raises(TypeError, match="speed: a number is needed, not True"):
        msg.ControlAxis(speed=True)


def test_unknown_values_and_bits_survive() -> None:
    assert msg.BoardErrorCode(211) == 211
    assert pickle.loads(pickle.dumps(msg.BoardErrorCode(211))) == 211
    flags = msg.BoardFeatures(0) | 0x8000
    assert int(msg.StateFlags(0xFFFF) & ~msg.StateFlags.DEBUG_MODE) == 0xFFFE
    assert int(flags) & 0x8000
    assert pickle.loads(pickle.dumps(flags)) == flags


def test_copies_are_independent() -> None:
    message = msg.Control(axes=msg.Axes(pitch=msg.ControlAxis(angle=30)))
    other = copy.copy(message)
    other.axes.pitch.angle = 0
    axis = copy.deepcopy(message.axes.pitch)
    axis.angle = 1
    assert message.axes.pitch.angle == pytest.approx(30, abs=0.02)
    assert pickle.loads(pickle.dumps(message.axes.pitch)) == message.axes.pitch


def test_lists_behave_like_lists() -> None:
    message = msg.BeepSound(note_freq_hz=[600, 700])
    assert list(message.note_freq_hz) == [600, 700]
    message.note_freq_hz.append(800)
    del message.note_freq_hz[0]
    message.note_freq_hz[0] = 900
    assert message.note_freq_hz == [900, 800]
    message.note_freq_hz_raw = [21000]
    assert "pause" in str(message)
    with pytest.raises(FieldError):
        message.note_freq_hz.extend([600] * 200)
    assert message.note_freq_hz_raw == [21000]


def test_only_what_can_fit_is_taken_of_an_iterable() -> None:
    taken = 0

    def endless() -> Iterator[float]:
        nonlocal taken
        while taken < 10_000:
            taken += 1
            yield 600

    message = msg.BeepSound(note_freq_hz=[600])

    def set_slice() -> None:
        message.note_freq_hz[:] = endless()

    uses: list[Callable[[], object]] = [
        lambda: msg.BeepSound(note_freq_hz=endless()),
        lambda: message.note_freq_hz.extend(endless()),
        set_slice,
        lambda: msg.ReadProfileNames(profile_name=map(str, endless())),
    ]
    for use in uses:
        taken = 0
        with pytest.raises(FieldError, match=r"(takes at most 255|has 5) elements, not over 255"):
            use()
        assert taken <= 256
    with pytest.raises(FieldError, match="it has 5 elements, not 2"):
        msg.ReadProfileNames(profile_name=["a", "b"])


def test_errors_name_field_value_and_limit() -> None:
    message = msg.Control()
    with pytest.raises(FieldError, match=r"axes.pitch.angle: 1e\+06 deg does not fit: -720 deg to"):
        message.axes.pitch.angle = 1e6
    with pytest.raises(TypeError, match="axes.pitch.angle: a number is needed, not 'up'"):
        message.axes.pitch.angle = "up"  # type: ignore[assignment]
    with pytest.raises(TypeError, match="unexpected keyword argument 'contrl_mode'"):
        msg.Control(contrl_mode=1)  # type: ignore[call-arg]
    with pytest.raises(TypeError, match="note_freq_hz: a list is needed, not 5"):
        msg.BeepSound(note_freq_hz=5)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="axes: Axes is needed"):
        message.axes = 3  # type: ignore[assignment]
    with pytest.raises(FieldError, match="^angle: 1000 deg does not fit"):
        msg.Axes(pitch=msg.ControlAxis(angle=1000))
    with pytest.raises(TypeError, match="axes.roll: ControlAxis is needed"):
        message.axes.roll = msg.AxisState()  # type: ignore[assignment]
    with pytest.raises(FieldError, match=r"note_length: 1e\+09 ms does not fit: 0 ms to 2040 ms"):
        msg.BeepSound(note_length=1e9)
    assert msg.ControlAxis(speed=0.05).speed_raw == 0, "computed speeds may be small"
    with pytest.raises(AttributeError):
        message.pitch = 3  # type: ignore[attr-defined]
    assert message == msg.Control()


def test_what_the_specification_does_not_allow_is_refused_unless_asked() -> None:
    message = msg.BeepSound()
    with pytest.raises(FieldError) as caught:
        message.decay_factor = 16
    assert caught.value.field == "decay_factor"
    assert str(caught.value) == "decay_factor: 16 is above 15"
    message.assign("decay_factor", "16", validates=False)
    (violation,) = [v for v in validate(message) if v.field == "decay_factor"]
    assert (violation.value, violation.limit, violation.rule) == (16, 15, "maximum")


def test_frames_that_are_none_say_why() -> None:
    frame = encode(msg.GetAnglesRequest())
    with pytest.raises(DecodeError, match="the checksum of the header"):
        decode(frame[:3] + b"\0")
    with pytest.raises(DecodeError, match="incomplete"):
        decode(frame[:-1])
    with pytest.raises(DecodeError, match="1 more follow"):
        decode(frame + b"\0")
    with pytest.raises(DecodeError, match="no start"):
        decode(b"hello")
    with pytest.raises(DecodeError, match="GetAngles: The body ends|body"):
        decode(frame, Direction.FROM_BOARD)


def test_what_is_no_message_and_no_bytes_is_an_error() -> None:
    for wrong in (5, None, msg.AxisState(), msg.Control):
        for take in (sbgc.encode, sbgc.encode_body, sbgc.validate, sbgc.describe):
            with pytest.raises(TypeError, match="a message is needed, not"):
                take(wrong)  # type: ignore[operator]
        for read in (sbgc.decode, sbgc.Parser().feed, msg.Control.from_body):
            with pytest.raises(TypeError, match="bytes-like object is required"):
                read(wrong)  # type: ignore[operator]
    with pytest.raises(TypeError, match="direction: a Direction is needed, not 'from_board'"):
        sbgc.decode(b"", "from_board")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="id: 0 to 255 are possible, not 256"):
        sbgc.decode_body(256, b"")
    with pytest.raises(TypeError, match="text: a text is needed, not 5"):
        msg.Control().assign("axes.roll.angle", 5)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="contexts: Contexts are needed, not 5"):
        sbgc.decode(b"", contexts=5)  # type: ignore[arg-type]


def test_a_parser_counts_what_it_skips() -> None:
    parser = Parser()
    frame = encode(msg.GetAnglesRequest())
    found = parser.feed(b"noise" + frame + frame[:3])
    assert [one.offset for one in found] == [5]
    assert parser.waiting_bytes == 3
    assert parser.flush() == []
    assert parser.counters.skipped_bytes == 8


def test_packed_values_have_parts() -> None:
    version = msg.FirmwareVersion(2740)
    assert str(version) == "2.74"
    mode = msg.ControlMode(mode=msg.ControlModeKind.MODE_SPEED)
    assert msg.ControlMode(mode, mode=msg.ControlModeKind.MODE_ANGLE).mode == 2
    with pytest.raises(FieldError, match="does not fit into 'mode'"):
        msg.ControlMode(mode=9999)  # type: ignore[arg-type]
