"""A scripted autopilot for sbgc-mavlink: steers a gimbal as ArduPilot does, and prints what it reports.

sbgc-mavlink /tmp/gimbal --line udpout:127.0.0.1:14551 &
drone.py udpin:127.0.0.1:14551
"""

from __future__ import annotations

import sys
import time
from importlib import import_module
from math import asin, atan2, cos, degrees, nan, radians, sin
from typing import Any

GIMBAL, FOLLOW, LOCK = 154, 0, 28
HEADING = 40.0
NO_Q, NO_RATES = [nan] * 4, (nan, nan, nan)


def turned(angle: float, axis: int) -> list[float]:
    """The quaternion of a turn about one axis, 1 to 3, in degrees."""
    q = [cos(radians(angle) / 2), 0.0, 0.0, 0.0]
    q[axis] = sin(radians(angle) / 2)
    return q


def fly(line: Any, what: str, seconds: float, *aim: Any) -> None:
    """Say 50 times a second where the nose points, and what the gimbal shall do; tell what it has done."""
    until, beat, status = time.monotonic() + seconds, 0.0, None
    while time.monotonic() < until:
        if time.monotonic() > beat + 1:
            beat = time.monotonic()
            line.mav.heartbeat_send(2, 3, 0, 0, 4)
        now, nose = time.monotonic_ns() // 1000, turned(HEADING, 3)
        rest = (0, 0, 0, 0, 0, nan, 0, 0)
        line.mav.autopilot_state_for_gimbal_device_send(1, 0, now, nose, *rest)
        if aim:
            line.mav.gimbal_device_set_attitude_send(1, GIMBAL, *aim)
        while found := line.recv_match(type="GIMBAL_DEVICE_ATTITUDE_STATUS"):
            status = found
        time.sleep(0.02)
    assert status, "the gimbal reports nothing"
    w, x, y, z = status.q
    pitch = degrees(asin(2 * (w * y - x * z)))
    yaw = degrees(atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))
    print(f"{what:36} pitch {pitch:6.1f}, yaw {yaw:6.1f} from the nose, flags {status.flags}")


def main() -> None:
    mavutil = import_module("pymavlink.mavutil")
    line = mavutil.mavlink_connection(sys.argv[1], source_system=1, source_component=1)
    assert line.wait_heartbeat(timeout=20), "no gimbal"
    fly(line, "the nose is 40 degrees from north:", 2)
    line.mav.command_long_send(1, GIMBAL, 512, 0, 283, 0, 0, 0, 0, 0, 0)
    told = line.recv_match(type="GIMBAL_DEVICE_INFORMATION", blocking=True, timeout=5)
    low, high = degrees(told.pitch_min), degrees(told.pitch_max)
    print(f"{told.vendor_name}, {told.model_name}, pitch from {low:.0f} to {high:.0f}")
    fly(line, "30 degrees down:", 3, FOLLOW, turned(-30, 2), *NO_RATES)
    fly(line, "20 degrees to the right of the nose:", 3, FOLLOW, turned(20, 3), *NO_RATES)
    fly(line, "locked 30 degrees from north:", 3, LOCK, turned(30, 3), *NO_RATES)
    fly(line, "0.2 rad/s up for a second:", 1, FOLLOW, NO_Q, nan, 0.2, nan)
    fly(line, "nothing more said; after a second:", 1)
    fly(line, "and after another one, the same:", 1)


if __name__ == "__main__":
    main()
