"""The gimbal device, told by what ArduPilot and PX4 really send; the optical axis is that of the joints."""

from __future__ import annotations

from math import degrees, isnan, nan, pi
from pathlib import Path
from typing import Any

import pytest
from drone import FOLLOW, LOCK, NO_Q, SLOW, STATUS, Gimbal, Rig, Station, aircraft, program, started
from optical_axis import right_side_down

from sbgc import Angles
from sbgc.mavlink.geometry import angles_of, wrapped

YAW_FRAMES = 32 | 64


def attitude_of(status: Any) -> Angles:
    w, x, y, z = status.q
    return angles_of((w, x, y, z))


def test_it_becomes_a_gimbal_of_the_autopilot_that_it_hears() -> None:
    gimbal, autopilot = Gimbal(), Station(system=7)
    line = f"--line=udpout:127.0.0.1:{autopilot.port}"
    try:
        with program(gimbal.address, line) as _:
            while len(autopilot.got) < 2:
                autopilot.listen(0.1)
            assert {one.name for one in autopilot.got} == {"HEARTBEAT"}, "it wakes who listens"
            autopilot.until(lambda: autopilot.all(STATUS))
            assert {one.sender for one in autopilot.all(STATUS)} == {(7, 154)}
            autopilot.command(512, 283, to=(0, 0))  # PX4 asks all
            told = autopilot.last("GIMBAL_DEVICE_INFORMATION")
    finally:
        gimbal.close()
    beat = autopilot.last("HEARTBEAT")
    assert (beat.type, beat.autopilot, beat.system_status) == (26, 8, 4)
    assert told.firmware_version == 59 << 8 | 2 and told.model_name == "SimpleBGC 3.0"
    assert degrees(told.pitch_min) == pytest.approx(-90), "the board looks 90 degrees down"
    assert degrees(told.pitch_max) == pytest.approx(45)
    assert told.yaw_max == pytest.approx(pi) and told.cap_flags == told.cap_flags2 & 0xFFFF


def test_requests_are_answered(rig: Rig) -> None:
    autopilot = rig.autopilot
    assert autopilot.command(512, 396) == 0
    assert autopilot.last("COMPONENT_INFORMATION_BASIC").capabilities == 0, "no manager"
    assert autopilot.command(512, 396, is_int=True) == 0
    assert autopilot.command(512, 280) == autopilot.command(400, 1) == autopilot.command(1000) == 3
    assert autopilot.command(400, 1, to=(0, 0)) is None, "others are meant, too"
    assert autopilot.command(511, 285, nan) == 2
    before = len(autopilot.all(STATUS))
    autopilot.fly(2)
    assert 30 <= len(autopilot.all(STATUS)) - before <= 42
    assert autopilot.command(511, 285, -1) == 0
    before = len(autopilot.all(STATUS))
    autopilot.fly(0.5)
    assert len(autopilot.all(STATUS)) == before
    target = {"target_system": 1, "target_component": 0}
    autopilot.put(autopilot.encode("PARAM_REQUEST_LIST", **target))
    autopilot.until(lambda: autopilot.all("PARAM_VALUE"))
    assert autopilot.last("PARAM_VALUE").param_count == 1


@pytest.mark.parametrize(
    "roll, pitch, yaw",
    [(0, -20, 0), (0, 20, 0), (0, 0, 25), (12, 0, 0), (0, -90, 0), (0, -30, -40)],
)
def test_directions(roll: float, pitch: float, yaw: float, rig: Rig) -> None:
    """MAVLink: pitch up, yaw and roll to the right. Flags 0 do not mean that pitch follows."""
    autopilot, gimbal = rig.autopilot, rig.gimbal
    aim = autopilot.aim(aircraft(roll, pitch, yaw), flags=FOLLOW)
    place = pytest.approx((roll, -pitch, yaw), abs=1)
    autopilot.until(lambda: gimbal.joints() == place, aim)
    assert gimbal.up == pytest.approx(pitch, abs=1)
    assert right_side_down(gimbal.joints()) == pytest.approx(roll, abs=1)
    if pitch != -90:
        assert gimbal.right == pytest.approx(yaw, abs=1)
    autopilot.fly(0.3, aim)
    status = autopilot.last(STATUS)
    assert attitude_of(status) == pytest.approx((roll, pitch, yaw), abs=1)
    assert status.flags & YAW_FRAMES == 32 and status.flags & LOCK == 12
    assert status.failure_flags == 0 and status.delta_yaw == 0 and status.gimbal_device_id == 0


def turning(tmp_path: Path) -> tuple[str, str]:
    """A frame that turns by 90 degrees, from the 4th second to the 10th."""
    motion = tmp_path / "turn.csv"
    motion.write_text("0,0,0,0\n4,0,0,0\n10,0,0,90\n600,0,0,90\n")
    return "--motion", str(motion)


@pytest.mark.parametrize("flags", [FOLLOW, LOCK, 12, 16])
def test_a_vehicle_that_turns(flags: int, tmp_path: Path) -> None:
    """The board begins with yaw 0, the vehicle heads north-east."""
    with started(emulator=turning(tmp_path), north=45) as rig:
        autopilot, gimbal = rig.autopilot, rig.gimbal
        is_locked = bool(flags & 16)
        yaw = 60 if is_locked else 15
        aim = autopilot.aim(aircraft(pitch=-10, yaw=yaw), flags=flags)
        while gimbal.data().frame_imu_angle.yaw < 89:
            autopilot.fly(0.1, aim)
        autopilot.fly(2, aim)
        assert gimbal.right == pytest.approx(60 - 135 if is_locked else 15, abs=2)
        assert gimbal.up == pytest.approx(-10, abs=1)
        status = autopilot.last(STATUS)
        assert degrees(status.delta_yaw) == pytest.approx(135, abs=1)
        assert wrapped(attitude_of(status).yaw - gimbal.right) == pytest.approx(0, abs=1)
        assert status.flags & LOCK == {FOLLOW: 12, LOCK: 28, 12: 12, 16: 16}[flags]


def test_without_a_heading_yaw_of_the_earth_follows(rig: Rig) -> None:
    autopilot, gimbal = rig.autopilot, rig.gimbal
    autopilot.heading = lambda: None
    autopilot.fly(1.2)
    aim = autopilot.aim(aircraft(yaw=30), flags=LOCK)
    autopilot.until(lambda: gimbal.right == pytest.approx(30, abs=1), aim)
    autopilot.fly(0.2)
    status = autopilot.last(STATUS)
    assert status.flags & (16 | 128) == 0 and isnan(status.delta_yaw)
    rig.process.terminate()
    assert rig.process.stderr is not None
    assert rig.process.stderr.read().count("yaw follows the vehicle") == 1


@pytest.mark.parametrize("limit, way", [(180, -170), (300, 190)])
def test_yaw_takes_the_short_way_within_the_limits(limit: int, way: int) -> None:
    gimbal = Gimbal()
    gimbal.close()
    gimbal = Gimbal(port=gimbal.address.rsplit(":", 1)[1])
    with gimbal.host.edit_profile(1) as profile:
        profile["rc.yaw.rc_min_angle"], profile["rc.yaw.rc_max_angle"] = -limit, limit
    autopilot = Station()
    try:
        with program(gimbal.address, f"--line=udpout:127.0.0.1:{autopilot.port}"):
            for yaw, joint in ((90, 90), (170, 170), (-170, way)):
                found = pytest.approx(joint, abs=1)
                aim = autopilot.aim(aircraft(yaw=yaw))
                while gimbal.joints()[2] != found:
                    autopilot.fly(0.1, aim)
    finally:
        gimbal.close()


@pytest.mark.parametrize("flags", [FOLLOW, LOCK])
def test_a_rate_ends_half_a_second_after_the_last_one(flags: int, rig: Rig) -> None:
    autopilot, gimbal = rig.autopilot, rig.gimbal
    rates = (nan, 0.2, -0.3)
    autopilot.fly(1, autopilot.aim(rates=rates, flags=flags))
    status = autopilot.last(STATUS)
    assert status.angular_velocity_y == pytest.approx(0.2, abs=0.05)
    assert status.angular_velocity_z == pytest.approx(-0.3, abs=0.05)
    up, right = gimbal.up, gimbal.right
    assert 6 < up < 16 and -24 < right < -9
    autopilot.fly(1.2)
    assert gimbal.is_still()
    assert 3 < gimbal.up - up < 9, "half a second, and what the camera was behind"
    up = gimbal.up
    autopilot.fly(0.3, autopilot.aim(rates=(nan, 0, nan), flags=flags))
    assert gimbal.is_still() and gimbal.up == pytest.approx(up, abs=1), "0 holds"


def test_retract_comes_with_rates_that_are_none(rig: Rig) -> None:
    autopilot, gimbal = rig.autopilot, rig.gimbal
    autopilot.until(lambda: gimbal.up < -18, autopilot.aim(aircraft(pitch=-20)))
    retract = autopilot.aim(NO_Q, (0, 0, 0), 1)
    level = autopilot.aim(aircraft())
    autopilot.until(lambda: abs(gimbal.up) < 1, lambda: (retract(), level()))
    autopilot.until(lambda: gimbal.up < -18, autopilot.aim(aircraft(pitch=-20)))
    autopilot.fly(SLOW / 3, autopilot.aim(aircraft(pitch=30), flags=2))
    assert gimbal.up == pytest.approx(0, abs=1), "neutral takes precedence over angles"
