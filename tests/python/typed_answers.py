"""Programs whose types mypy and pyright know: they are checked, not run."""

from __future__ import annotations

from typing import Optional

import sbgc
from sbgc import aio, msg


def answers(gimbal: sbgc.Gimbal) -> tuple[msg.GetAngles, msg.Confirm, float]:
    angles = gimbal.call(msg.GetAnglesRequest())
    saved: Optional[msg.Confirm] = gimbal.call(msg.BeepSound())
    assert saved is None or saved.cmd
    return angles, gimbal.call(msg.MotorsOn()), angles.axes.pitch.imu_angle


async def the_same(gimbal: aio.Gimbal) -> msg.GetAngles:
    return await gimbal.call(msg.GetAnglesRequest())


def mistakes(gimbal: sbgc.Gimbal) -> None:
    gimbal.call(msg.GetAngles())  # type: ignore[arg-type]
    gimbal.get_angles()  # type: ignore[attr-defined]
