"""The gimbal manager: how it is found, who steers, and what ends that."""

from __future__ import annotations

from collections.abc import Iterator
from math import nan, radians
from typing import Any

import pytest
from drone import STATUS, Gimbal, Rig, Station, aircraft, started

PITCHYAW, CONFIGURE = 1000, 1001
TARGET = {"target_system": 1, "target_component": 154, "gimbal_device_id": 1, "flags": 12}


@pytest.fixture(name="rig")
def managed() -> Iterator[Rig]:
    with started("--manager") as made:
        made.autopilot.until(lambda: made.autopilot.all("GIMBAL_MANAGER_STATUS"))
        yield made


def owners(station: Station) -> list[int]:
    station.fly(0.5)
    status = station.last("GIMBAL_MANAGER_STATUS")
    primary = [status.primary_control_sysid, status.primary_control_compid]
    return [*primary, status.secondary_control_sysid]


def test_it_is_found_and_describes_itself(autopilot: Station) -> None:
    assert [autopilot.command(512, number) for number in (396, 280, 281)] == [0, 0, 0]
    assert autopilot.last("COMPONENT_INFORMATION_BASIC").capabilities == 0x40000
    told = autopilot.last("GIMBAL_MANAGER_INFORMATION")
    assert told.gimbal_device_id == 1 and told.pitch_min == pytest.approx(radians(-90))
    assert autopilot.last(STATUS).gimbal_device_id == 1, "one component with the manager"
    assert 140 < autopilot.interval("GIMBAL_MANAGER_STATUS", 9) < 600, "5 per second"


def test_only_who_has_control_steers(autopilot: Station, gimbal: Gimbal) -> None:
    level, down = (0, 0, nan, nan, 12), (-30, 0, nan, nan, 12)
    autopilot.fly(1, autopilot.aim(aircraft(pitch=-30)))  # as ArduPilot does all the time
    assert autopilot.command(PITCHYAW, *down) == 2, "nobody has control"
    assert gimbal.up == pytest.approx(0, abs=0.5)
    station, nobody = Station(245, 190, line=autopilot), Station(0, 0, line=autopilot)
    assert station.command(CONFIGURE, 1, 1, -1, -1) == 2, "nobody decides for others"
    assert station.command(CONFIGURE, nan, nan, nan, nan) == 2
    assert station.command(CONFIGURE, 245, 190, 245, 190) == 0, "as MAVSDK asks"
    assert owners(station) == [245, 190, 245]
    assert autopilot.command(PITCHYAW, *down) == nobody.command(PITCHYAW, *down) == 2
    assert station.command(PITCHYAW, -20, 30, nan, nan, 12, is_int=True) == 0
    autopilot.until(lambda: (gimbal.up, gimbal.right) == pytest.approx((-20, 30), abs=1))
    for pitch, yaw, rate, flags in ((-20, 30, nan, 1), (2000, 0, nan, 12), (0, 0, nan, 96)):
        assert station.command(PITCHYAW, pitch, yaw, rate, rate, flags) == 2
    assert station.command(PITCHYAW, 0, 0, 0, 0, -1) == 2
    place = (154, 0, 0, 0, 473977000, 85455000, 500)
    assert station.command(195, *place, is_int=True) == station.command(197) == 3, "unsupported"
    assert autopilot.command(CONFIGURE, -2, -2, -1, -1) == 0, "who asks gets it"
    assert owners(autopilot) == [1, 1, 245]
    assert station.command(PITCHYAW, *level) == 2
    assert autopilot.command(CONFIGURE, -3, -3, -3, -3) == 0
    assert owners(autopilot) == [0, 0, 245]
    assert station.command(PITCHYAW, *level) == 0, "secondary control, while nobody has primary"
    assert station.command(CONFIGURE, -3, -3, -3, -3) == 0
    assert nobody.command(PITCHYAW, *down) == 2, "nobody has control"


def test_control_ends_with_silence(autopilot: Station, gimbal: Gimbal) -> None:
    """A ground station is killed while the camera turns."""
    station = Station(255, 190, line=autopilot)
    assert station.command(CONFIGURE, 255, 190, -1, -1) == 0
    fields = {"pitch": nan, "yaw": nan, "pitch_rate": -0.3, **TARGET}
    for _ in range(5):
        station.put(station.encode("GIMBAL_MANAGER_SET_PITCHYAW", **fields))
        autopilot.fly(0.1)
    autopilot.fly(1)
    assert gimbal.is_still() and -30 < gimbal.up < -5
    autopilot.until(lambda: owners(autopilot) == [0, 0, 0])


SETPOINTS: dict[str, dict[str, Any]] = {
    "PITCHYAW": {"pitch": radians(-30), "yaw": radians(20)},
    "MANUAL_CONTROL": {"pitch": -1 / 3, "yaw": 1 / 9},
    "ATTITUDE": {"q": aircraft(pitch=-30, yaw=20)},
}


@pytest.mark.parametrize("name", SETPOINTS)
def test_setpoints(name: str, autopilot: Station, gimbal: Gimbal) -> None:
    autopilot.command(CONFIGURE, 1, 1, -1, -1)

    def send(**changed: Any) -> bytes:
        data = {**SETPOINTS[name], **TARGET, **changed}
        return autopilot.put(autopilot.encode(f"GIMBAL_MANAGER_SET_{name}", **data))

    autopilot.fly(0.5, lambda: send(gimbal_device_id=2))
    if name == "MANUAL_CONTROL":
        autopilot.fly(0.5, lambda: send(pitch=-1.5))
    assert gimbal.up == pytest.approx(0, abs=0.5)
    place = pytest.approx((-30, 20), abs=1)
    autopilot.until(lambda: (gimbal.up, gimbal.right) == place, send)


def test_it_does_not_manage_what_another_one_announces(autopilot: Station, gimbal: Gimbal) -> None:
    autopilot.put(autopilot.encode("GIMBAL_MANAGER_STATUS", gimbal_device_id=1))
    autopilot.fly(0.5)
    assert autopilot.command(CONFIGURE, 1, 1, -1, -1) == 0, "ArduPilot numbers its mounts so"
    autopilot.put(autopilot.encode("GIMBAL_MANAGER_STATUS", gimbal_device_id=154))
    assert autopilot.command(CONFIGURE, 1, 1, -1, -1) == 2
    autopilot.until(lambda: gimbal.up < -18, autopilot.aim(aircraft(pitch=-20)))
    assert autopilot.last(STATUS).gimbal_device_id == 0
