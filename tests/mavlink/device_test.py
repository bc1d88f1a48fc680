"""The gimbal device, told by what ArduPilot and PX4 really send; the optical axis is that of the joints."""

from __future__ import annotations

from math import degrees, isnan, nan, pi, remainder
from pathlib import Path
from statistics import median

import pytest
from drone import FOLLOW, LOCK, NO_Q, STATUS, Gimbal, Rig, Station, aircraft, started
from optical_axis import right_side_down

from sbgc.mavlink.geometry import angles_of


def test_it_becomes_a_gimbal_of_the_autopilot_that_it_hears() -> None:
    with started(system=7) as rig:
        autopilot = rig.autopilot
        assert autopilot.got[0].name == "HEARTBEAT", "it wakes who has sent nothing"
        assert {one.sender for one in autopilot.all(STATUS)} == {(7, 154)}
        assert autopilot.command(512, 283, to=(7, 154)) == 0
        autopilot.until(lambda: autopilot.last("HEARTBEAT").system_status == 4)
    beat, told = autopilot.last("HEARTBEAT"), autopilot.last("GIMBAL_DEVICE_INFORMATION")
    assert (beat.type, beat.autopilot) == (26, 8)
    assert told.firmware_version == 59 << 8 | 2 and told.model_name == "SimpleBGC 3.0"
    ends = degrees(told.pitch_min), degrees(told.pitch_max)
    assert ends == pytest.approx((-90, 45)), "the board looks 90 degrees down"
    assert told.yaw_max == pytest.approx(pi) and told.cap_flags == told.cap_flags2 & 0xFFFF


def test_requests_are_answered(autopilot: Station) -> None:
    assert autopilot.command(512, 396) == 0
    assert autopilot.last("COMPONENT_INFORMATION_BASIC").capabilities == 0, "no manager"
    assert autopilot.command(512, 396, is_int=True) == 0
    assert autopilot.command(512, 280) == autopilot.command(400, 1) == autopilot.command(1000) == 3
    assert autopilot.command(400, 1, to=(0, 0), patience=2) is None, "others are meant, too"
    assert autopilot.command(511, 285, nan) == 2
    assert 35 < autopilot.interval(STATUS, 30) < 150, "it sends 20 per second"
    assert autopilot.command(511, 285, -1) == 0
    before = len(autopilot.all(STATUS))
    autopilot.fly(0.5)
    assert len(autopilot.all(STATUS)) == before
    autopilot.put(autopilot.encode("PARAM_REQUEST_LIST", target_system=1))
    autopilot.until(lambda: autopilot.all("PARAM_VALUE"))
    assert autopilot.last("PARAM_VALUE").param_count == 1


@pytest.mark.parametrize("period", [0.2, 0.05])
def test_px4(period: float, autopilot: Station, gimbal: Gimbal) -> None:
    """It asks all, sends 5 to 20 times a second, and only flags that lock."""
    autopilot.period = period
    assert autopilot.command(512, 283, to=(0, 0)) == 0
    assert autopilot.last("GIMBAL_DEVICE_INFORMATION").gimbal_device_id == 0
    autopilot.fly(0.5, autopilot.aim())  # all is NaN until somebody steers
    for flags, pitch, yaw in ((12, -20, 30), (28, -30, -15), (0, -10, 20)):
        aim = autopilot.aim(aircraft(pitch=pitch, yaw=yaw), flags=flags)
        place = pytest.approx((pitch, yaw), abs=1)
        autopilot.until(lambda: (gimbal.up, gimbal.right) == place, aim)
        autopilot.fly(0.3, aim)
        assert autopilot.last(STATUS).flags & LOCK == (flags or 12)
    before = len(autopilot.all(STATUS))
    autopilot.fly(1.5, autopilot.aim(rates=(nan, 0.2, -0.3), flags=12))
    seen = [one.values for one in autopilot.all(STATUS)[before:]]
    speeds = [(one.angular_velocity_y, one.angular_velocity_z) for one in seen[len(seen) // 2 :]]
    assert all(y > 0.05 and z < -0.05 for y, z in speeds), "it does not stop in between"
    assert tuple(map(median, zip(*speeds))) == pytest.approx((0.2, -0.3), abs=0.05)


PLACES = [(0, -20, 0), (0, 20, 0), (0, 0, 25), (12, 0, 0), (0, -90, 0), (0, -30, -40)]


@pytest.mark.parametrize("roll, pitch, yaw", PLACES)
def test_directions(roll: int, pitch: int, yaw: int, autopilot: Station, gimbal: Gimbal) -> None:
    """MAVLink: pitch up, yaw and roll to the right. Flags 0 do not mean that pitch follows."""
    aim = autopilot.aim(aircraft(roll, pitch, yaw), flags=FOLLOW)
    place = pytest.approx((roll, -pitch, yaw), abs=1)
    autopilot.until(lambda: gimbal.joints() == place, aim)
    assert gimbal.up == pytest.approx(pitch, abs=1)
    assert right_side_down(gimbal.joints()) == pytest.approx(roll, abs=1)
    if pitch != -90:
        assert gimbal.right == pytest.approx(yaw, abs=1)
    autopilot.fly(0.3, aim)
    status = autopilot.last(STATUS)
    assert angles_of(status.q) == pytest.approx((roll, pitch, yaw), abs=1)
    assert status.flags & (32 | 64) == 32 and status.flags & LOCK == 12
    assert status.failure_flags == 0 and status.delta_yaw == 0 and status.gimbal_device_id == 0


@pytest.mark.parametrize("flags", [FOLLOW, LOCK, 12, 16])
def test_a_vehicle_that_turns(flags: int, tmp_path: Path) -> None:
    """By 90 degrees, from the 2nd second to the 6th. The board begins with yaw 0, the vehicle heads north-east."""
    motion = tmp_path / "turn.csv"
    motion.write_text("0,0,0,0\n2,0,0,0\n6,0,0,90\n600,0,0,90\n")
    with started(emulator=("--motion", str(motion)), north=45) as rig:
        autopilot, gimbal = rig.autopilot, rig.gimbal
        yaw, wanted = (60, 60 - 135) if flags & 16 else (15, 15)
        aim = autopilot.aim(aircraft(pitch=-10, yaw=yaw), flags=flags)
        while gimbal.data().frame_imu_angle.yaw < 89:
            autopilot.fly(0.1, aim)
        autopilot.fly(2, aim)
        place = pytest.approx((-10, wanted), abs=2)
        autopilot.until(lambda: (gimbal.up, gimbal.right) == place, aim)
        status = autopilot.last(STATUS)
        assert degrees(status.delta_yaw) == pytest.approx(135, abs=1)
        assert abs(remainder(angles_of(status.q).yaw - gimbal.right, 360)) < 1
        assert status.flags & LOCK == (flags or 12)


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
    with started(limit=limit) as rig:
        for yaw, joint in ((90, 90), (170, 170), (-170, way)):
            found, aim = pytest.approx(joint, abs=1), rig.autopilot.aim(aircraft(yaw=yaw))
            while rig.gimbal.joints()[2] != found:
                rig.autopilot.fly(0.1, aim)


@pytest.mark.parametrize("flags", [FOLLOW, LOCK])
def test_a_rate_ends_after_half_a_second(flags: int, autopilot: Station, gimbal: Gimbal) -> None:
    def rates() -> tuple[float, float]:
        # On a busy machine, the rate of some is taken over another time.
        recent = [one.values for one in autopilot.all(STATUS)[-5:]]
        return (
            median(one.angular_velocity_y for one in recent),
            median(one.angular_velocity_z for one in recent),
        )

    aim = autopilot.aim(rates=(nan, 0.2, -0.3), flags=flags)
    autopilot.until(lambda: rates() == pytest.approx((0.2, -0.3), abs=0.05), aim)
    autopilot.until(lambda: gimbal.up > 6, aim)
    up = gimbal.up
    assert gimbal.right == pytest.approx(-1.5 * up, abs=4)
    autopilot.fly(1.2)
    autopilot.until(gimbal.is_still)
    assert 3 < gimbal.up - up < 15, "half a second, and what the camera was behind"
    up = gimbal.up
    autopilot.fly(0.3, autopilot.aim(rates=(nan, 0, nan), flags=flags))
    assert gimbal.is_still() and gimbal.up == pytest.approx(up, abs=1), "0 holds"


def test_retract_comes_with_rates_that_are_none(autopilot: Station, gimbal: Gimbal) -> None:
    down = autopilot.aim(aircraft(pitch=-20))
    autopilot.until(lambda: gimbal.up < -18, down)
    retract, level = autopilot.aim(NO_Q, (0, 0, 0), 1), autopilot.aim(aircraft())
    autopilot.until(lambda: abs(gimbal.up) < 1, lambda: (retract(), level()))
    autopilot.until(lambda: gimbal.up < -18, down)
    autopilot.fly(2, autopilot.aim(aircraft(pitch=30), flags=2))
    assert gimbal.up == pytest.approx(0, abs=1), "neutral takes precedence over angles"
