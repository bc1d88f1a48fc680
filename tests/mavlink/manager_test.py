"""The gimbal manager: how it is found, who steers, and what ends that."""

from __future__ import annotations

from collections.abc import Iterator
from math import nan, radians
from typing import Any

import pytest
from drone import STATUS, Rig, Station, aircraft, started

PITCHYAW, CONFIGURE = 1000, 1001


@pytest.fixture(name="rig")
def managed() -> Iterator[Rig]:
    with started("--manager") as made:
        made.autopilot.until(lambda: made.autopilot.all("GIMBAL_MANAGER_STATUS"))
        yield made


def owners(station: Station) -> list[int]:
    station.fly(0.5)
    status = station.last("GIMBAL_MANAGER_STATUS")
    return [
        status.primary_control_sysid,
        status.primary_control_compid,
        status.secondary_control_sysid,
    ]


def join(rig: Rig, system: int, component: int) -> Station:
    """Another station on the line of the autopilot."""
    station = Station(system, component)
    station.socket.close()
    station.socket, station.peer = rig.autopilot.socket.dup(), rig.autopilot.peer
    return station


def test_it_is_found_and_describes_itself(rig: Rig) -> None:
    autopilot = rig.autopilot
    assert (
        autopilot.command(512, 396)
        == autopilot.command(512, 280)
        == autopilot.command(512, 281)
        == 0
    )
    assert autopilot.last("COMPONENT_INFORMATION_BASIC").capabilities == 0x40000
    told = autopilot.last("GIMBAL_MANAGER_INFORMATION")
    assert told.gimbal_device_id == 1 and told.pitch_min == pytest.approx(radians(-90))
    assert autopilot.last(STATUS).gimbal_device_id == 1, "one component with the manager"
    before = len(autopilot.all("GIMBAL_MANAGER_STATUS"))
    autopilot.fly(2)
    assert 8 <= len(autopilot.all("GIMBAL_MANAGER_STATUS")) - before <= 11


def test_only_who_has_control_steers(rig: Rig) -> None:
    autopilot, gimbal = rig.autopilot, rig.gimbal
    autopilot.fly(1, autopilot.aim(aircraft(pitch=-30)))  # as ArduPilot does all the time
    assert autopilot.command(PITCHYAW, -30, 0, nan, nan, 12) == 2, "nobody has control"
    assert gimbal.up == pytest.approx(0, abs=0.5)
    station = join(rig, 245, 190)
    assert station.command(CONFIGURE, 1, 1, -1, -1) == 2, "nobody decides for others"
    assert station.command(CONFIGURE, 245, 190, 245, 190) == 0, "as MAVSDK asks"
    assert owners(station) == [245, 190, 245]
    assert autopilot.command(PITCHYAW, -30, 0, nan, nan, 12) == 2
    assert station.command(PITCHYAW, -20, 30, nan, nan, 12, is_int=True) == 0
    autopilot.until(lambda: (gimbal.up, gimbal.right) == pytest.approx((-20, 30), abs=1))
    for refused in (
        (-20, 30, nan, nan, 1),
        (2000, 0, nan, nan, 12),
        (0, 0, nan, nan, 96),
        (0, 0, 0, 0, -1),
    ):
        assert station.command(PITCHYAW, *refused) == 2
    assert autopilot.command(CONFIGURE, -2, -2, -1, -1) == 0, "who asks gets it"
    assert owners(autopilot) == [1, 1, 245]
    assert station.command(PITCHYAW, 0, 0, nan, nan, 12) == 2
    assert autopilot.command(CONFIGURE, -3, -3, -3, -3) == 0
    assert owners(autopilot) == [0, 0, 245]
    assert (
        station.command(PITCHYAW, 0, 0, nan, nan, 12) == 0
    ), "secondary control, while nobody has primary"
    assert station.command(CONFIGURE, nan, nan, nan, nan) == 2


def test_control_ends_with_silence(rig: Rig) -> None:
    """A ground station is killed while the camera turns."""
    station = join(rig, 255, 190)
    assert station.command(CONFIGURE, 255, 190, -1, -1) == 0
    fields = {"target_system": 1, "target_component": 154, "gimbal_device_id": 0, "flags": 12}
    for _ in range(5):
        rates = {"pitch": nan, "yaw": nan, "pitch_rate": -0.3, "yaw_rate": nan}
        station.put(station.encode("GIMBAL_MANAGER_SET_PITCHYAW", **fields, **rates))
        rig.autopilot.fly(0.1)
    rig.autopilot.fly(1)
    assert rig.gimbal.is_still() and -30 < rig.gimbal.up < -5
    rig.autopilot.until(lambda: owners(rig.autopilot) == [0, 0, 0])


@pytest.mark.parametrize(
    "name, fields",
    [
        (
            "SET_PITCHYAW",
            {"pitch": radians(-30), "yaw": radians(20), "pitch_rate": nan, "yaw_rate": nan},
        ),
        ("SET_MANUAL_CONTROL", {"pitch": -1 / 3, "yaw": 1 / 9, "pitch_rate": nan, "yaw_rate": nan}),
        ("SET_ATTITUDE", {"q": aircraft(pitch=-30, yaw=20)}),
    ],
)
def test_setpoints(name: str, fields: dict[str, Any], rig: Rig) -> None:
    autopilot, gimbal = rig.autopilot, rig.gimbal
    if name == "SET_ATTITUDE":
        fields = {**fields, **{f"angular_velocity_{axis}": nan for axis in "xyz"}}
    autopilot.command(CONFIGURE, 1, 1, -1, -1)
    target = {"target_system": 1, "target_component": 154, "flags": 12}

    def send(number: int, **changed: Any) -> None:
        data = {**fields, **target, "gimbal_device_id": number, **changed}
        autopilot.put(autopilot.encode(f"GIMBAL_MANAGER_{name}", **data))

    autopilot.fly(0.5, lambda: send(2))
    if name == "SET_MANUAL_CONTROL":
        autopilot.fly(0.5, lambda: send(1, pitch=-1.5))
    assert gimbal.up == pytest.approx(0, abs=0.5)
    place = pytest.approx((-30, 20), abs=1)
    autopilot.until(lambda: (gimbal.up, gimbal.right) == place, lambda: send(1))


def test_places_are_not_supported(rig: Rig) -> None:
    rig.autopilot.command(CONFIGURE, 1, 1, -1, -1)
    assert rig.autopilot.command(195, 154, 0, 0, 0, 473977000, 85455000, 500, is_int=True) == 3
    assert rig.autopilot.command(197) == 3


def test_it_does_not_manage_what_another_one_announces(rig: Rig) -> None:
    autopilot = rig.autopilot
    ids = {"primary_control_sysid": 0, "primary_control_compid": 0}
    ids.update(secondary_control_sysid=0, secondary_control_compid=0, flags=12, time_boot_ms=0)
    autopilot.put(autopilot.encode("GIMBAL_MANAGER_STATUS", gimbal_device_id=1, **ids))
    autopilot.fly(0.5)
    assert autopilot.command(CONFIGURE, 1, 1, -1, -1) == 0, "ArduPilot numbers its mounts so"
    autopilot.put(autopilot.encode("GIMBAL_MANAGER_STATUS", gimbal_device_id=154, **ids))
    assert autopilot.command(CONFIGURE, 1, 1, -1, -1) == 2
    autopilot.until(lambda: rig.gimbal.up < -18, autopilot.aim(aircraft(pitch=-20)))
    assert autopilot.last(STATUS).gimbal_device_id == 0
