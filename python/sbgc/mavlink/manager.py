"""The gimbal manager of the Gimbal Protocol v2, one component with its device: who may steer, and how.

Whoever asks for primary control with DO_GIMBAL_MANAGER_CONFIGURE gets it, also from somebody else; the owner
loses it by giving it back, or by five seconds of silence. The owner of secondary control steers while nobody has
primary control. Places (ROI) are not supported.
"""

from __future__ import annotations

import asyncio
import logging
from functools import partial
from math import degrees
from typing import Any, Optional

from sbgc.emulator import Angles
from sbgc.mavlink.codec import Message
from sbgc.mavlink.commands import Order
from sbgc.mavlink.device import Device
from sbgc.mavlink.protocol import ONE_COMPONENT, Command, Flags, Ids, Number, Result

LOG = logging.getLogger("sbgc.mavlink")
INTERVAL = 0.2
SEARCH = 1.0  # seconds in which another manager is searched for
MANUAL_RATE, MANUAL_ANGLE = 30.0, 90.0
"""Degrees per second, and degrees where there is no limit, for a stick at its end."""
NOBODY = (0, 0)
UNCHANGED, MYSELF, NO_LONGER_ME = (-1, -1), (-2, -2), (-3, -3)


class Manager:
    """Manages a device of this process, unless another component announces that it manages it."""

    def __init__(self, device: Device) -> None:
        self.is_active = False
        self._device, self._vehicle = device, device.vehicle
        self._owners: list[Ids] = [NOBODY, NOBODY]  # primary, secondary
        self._has_rival = False
        device.manager = self

    async def run(self) -> None:
        """Search for another manager; manage until one is heard."""
        while not self._vehicle.system:
            await asyncio.sleep(INTERVAL)
        fields = {f"param{number}": 0 for number in range(2, 8)}
        fields.update(target_system=0, target_component=0, confirmation=0)
        fields.update(command=Command.REQUEST_MESSAGE, param1=Number.MANAGER_INFORMATION)
        self._device.reports.send("COMMAND_LONG", **fields)
        await asyncio.sleep(SEARCH)
        self.is_active = not self._has_rival
        while self.is_active:
            for place, owner in enumerate(self._owners):
                if owner != NOBODY and not self._vehicle.hears(owner):
                    LOG.info("%s: %d/%d is silent, so its control ends", self._device.name, *owner)
                    self._owners[place] = NOBODY
            self.tell(Number.MANAGER_STATUS)
            await asyncio.sleep(INTERVAL)

    def take(self, message: Message) -> None:
        """Take a message for this component, or for all."""
        values = message.values
        if message.name in ("GIMBAL_MANAGER_INFORMATION", "GIMBAL_MANAGER_STATUS"):
            if message.system == self._vehicle.system and not self._has_rival:
                self._has_rival = values.gimbal_device_id == self._device.component
                if self._has_rival:
                    self.is_active = False
                    text = "%s: component %d manages it already; this program does not"
                    LOG.error(text, self._device.name, message.component)
        elif not self.is_active or not self._is_for_us(values.gimbal_device_id):
            self._vehicle.counters["for_others"] += 1
        else:
            may = self._may_steer(message.sender)
            self._device.attempt(may, partial(self._steer, message.name), values)

    def execute(self, order: Order) -> Optional[Result]:
        """Execute a command; None if it is none of a manager."""
        if order.command not in (Command.MANAGER_PITCHYAW, Command.MANAGER_CONFIGURE):
            return None
        if not self.is_active or not self._is_for_us(order.parameters[6]):
            return Result.DENIED
        if order.command == Command.MANAGER_CONFIGURE:
            return self._configure(order)
        if not self._may_steer(order.sender):
            self._vehicle.counters["not_in_control"] += 1
            return Result.DENIED
        pitch, yaw, pitch_rate, yaw_rate, flags = order.parameters[:5]
        if not 0 <= flags < 1 << 32:
            return Result.DENIED
        try:
            angles, rates = Angles(0.0, pitch, yaw), Angles(0.0, pitch_rate, yaw_rate)
            is_possible = self._device.aim(Flags(int(flags)), angles, rates)
        except ValueError as error:
            self._vehicle.counters[str(error)] += 1
            return Result.DENIED
        return Result.ACCEPTED if is_possible else Result.FAILED

    def tell(self, number: int) -> bool:
        """Send the information or the status."""
        reports = self._device.reports
        fields: dict[str, Any] = {"time_boot_ms": self._vehicle.milliseconds}
        fields["gimbal_device_id"] = ONE_COMPONENT
        if number == Number.MANAGER_INFORMATION:
            able, limits = reports.abilities()
            return reports.send("GIMBAL_MANAGER_INFORMATION", cap_flags=able, **limits, **fields)
        for name, owner in zip(("primary", "secondary"), self._owners):
            fields[f"{name}_control_sysid"], fields[f"{name}_control_compid"] = owner
        return reports.send("GIMBAL_MANAGER_STATUS", flags=int(reports.flags), **fields)

    def _is_for_us(self, device_id: float) -> bool:
        return device_id in (0, ONE_COMPONENT, self._device.component)

    def _may_steer(self, sender: Ids) -> bool:
        primary, secondary = self._owners
        return sender == (secondary if primary == NOBODY else primary)

    def _configure(self, order: Order) -> Result:
        asked = [order.parameters[0:2], order.parameters[2:4]]
        wanted = []
        for owner, ids in zip(self._owners, asked):
            if ids in (MYSELF, order.sender):
                wanted.append(order.sender)
            elif ids in (NO_LONGER_ME, NOBODY) and owner == order.sender:
                wanted.append(NOBODY)
            elif ids in (UNCHANGED, NO_LONGER_ME) or ids == owner:
                wanted.append(owner)
            else:
                return Result.DENIED  # nobody decides for others
        if wanted != self._owners:
            LOG.info("%s: in control are %s", self._device.name, wanted)
            self._owners = wanted
            self.tell(Number.MANAGER_STATUS)
        return Result.ACCEPTED

    def _steer(self, name: str, values: Any) -> None:
        if name == "GIMBAL_MANAGER_SET_ATTITUDE":
            self._device.steer(values)
            return
        given = values.pitch, values.yaw, values.pitch_rate, values.yaw_rate
        if name == "GIMBAL_MANAGER_SET_PITCHYAW":
            pitch, yaw, pitch_rate, yaw_rate = map(degrees, given)
        else:
            if any(abs(stick) > 1 for stick in given):
                raise ValueError("range")
            pitch, yaw = self._angle(1, given[0]), self._angle(2, given[1])
            pitch_rate, yaw_rate = MANUAL_RATE * given[2], MANUAL_RATE * given[3]
        rates = Angles(0.0, pitch_rate, yaw_rate)
        self._device.aim(Flags(values.flags), Angles(0.0, pitch, yaw), rates)

    def _angle(self, number: int, stick: float) -> float:
        """Where a stick points; its end is the limit of the axis."""
        low, high = self._device.head.steering.limits[number]
        end = high if stick > 0 else -low
        return stick * (end if end <= 180 else MANUAL_ANGLE)
