"""Programs that nobody here wrote: MAVSDK steers the gimbal, node-mavlink decodes what it sends."""

from __future__ import annotations

import json
import shutil
import subprocess
import time
from contextlib import closing
from math import degrees, isnan
from pathlib import Path
from typing import Any

import pytest
from drone import STATUS, Gimbal, Station, aircraft, program

PEERS = Path(__file__).parent / "peers"


def test_mavsdk_steers_and_sees() -> None:
    mavsdk = pytest.importorskip("mavsdk", reason="./dev installs it")
    plugin: Any = pytest.importorskip("mavsdk.plugins.gimbal.gimbal")
    free, until = Station(), Station().until
    free.socket.close()
    follow, once = plugin.GimbalMode.YAW_FOLLOW, plugin.SendMode.ONCE
    kind = mavsdk.Configuration.create_with_component_type(mavsdk.ComponentType.GROUND_STATION)
    options = f"--line=udpout:127.0.0.1:{free.port}", "--manager", "--system=1"
    with closing(Gimbal()) as camera, program(camera.address, *options), mavsdk.Mavsdk(
        kind
    ) as ground:
        ground.add_any_connection(f"udpin://127.0.0.1:{free.port}")
        system = until(lambda: [one for one in ground.get_systems() if one.has_gimbal()])[0]
        gimbal = plugin.Gimbal(system)
        (item,) = until(lambda: gimbal.gimbal_list().gimbals)
        who = item.vendor_name, item.gimbal_manager_component_id
        assert who == ("BaseCam Electronics", 154)
        with pytest.raises(plugin.GimbalError):
            gimbal.set_angles(item.gimbal_id, 0, -30, 20, follow, once)
        gimbal.take_control(item.gimbal_id, plugin.ControlMode.PRIMARY)
        until(lambda: gimbal.get_control_status(item.gimbal_id).control_mode == 1)
        gimbal.set_angles(item.gimbal_id, 0, -30, 20, follow, once)
        place = pytest.approx((-30, 20), abs=1)
        until(lambda: (camera.up, camera.right) == place)
        attitude: Any = lambda: gimbal.get_attitude(item.gimbal_id).euler_angle_forward
        until(lambda: (attitude().pitch_deg, attitude().yaw_deg) == place)
        gimbal.set_angular_rates(item.gimbal_id, 0, 10, -10, follow, once)
        time.sleep(1.2)
        assert camera.is_still(), "sent once, a rate ends after half a second"
        assert (camera.up, camera.right) == pytest.approx((-25, 15), abs=1.5)
        for _ in range(10):
            gimbal.set_angular_rates(item.gimbal_id, 0, -10, 10, follow, plugin.SendMode.STREAM)
            time.sleep(0.1)
        assert -60 < camera.up < -30 and 20 < camera.right < 50
        gimbal.release_control(item.gimbal_id)
        until(lambda: gimbal.get_control_status(item.gimbal_id).control_mode == 0)
        gimbal.destroy()


def test_node_mavlink_decodes_the_same(autopilot: Station) -> None:
    node = shutil.which("node")
    if node is None or not (PEERS / "node_modules").exists():
        pytest.skip("node-mavlink is missing: ./dev installs it")
    autopilot.fly(1.5, autopilot.aim(aircraft(pitch=-20, yaw=10)))
    assert autopilot.command(512, 283) == 0 and autopilot.command(512, 77) == 3
    data = b"".join(bytes(one.values.get_msgbuf()) for one in autopilot.got)
    done = subprocess.run([node, PEERS / "decode.js"], input=data, capture_output=True, check=True)
    lines = [json.loads(line) for line in done.stdout.decode().splitlines()]
    names = {"HEARTBEAT", "COMMAND_ACK", STATUS, "GIMBAL_DEVICE_INFORMATION"}
    assert {one["name"] for one in lines} >= names
    assert len(lines) == len(autopilot.got)
    for ours, theirs in zip(autopilot.got, lines):
        assert (theirs["name"], theirs["system"], theirs["component"]) == (ours.name, *ours.sender)
        for name in ours.values.get_fieldnames():
            expected = getattr(ours.values, name)
            head, *rest = name.split("_")
            found = theirs["fields"].get(head + "".join(word.capitalize() for word in rest))
            if name == "cap_flags2":
                assert found is None, "now it knows this field, too"
            elif isinstance(expected, float) and isnan(expected):
                assert found == "NaN"
            elif isinstance(expected, (float, list)):
                assert found == pytest.approx(expected, rel=1e-6), name
            else:
                assert str(found).rstrip("\0") == str(expected), name
    assert degrees(autopilot.last(STATUS).delta_yaw) == 0
