"""The gimbal manager of the Gimbal Protocol v2: one component with its device. It arbitrates control.

A request for primary control with DO_GIMBAL_MANAGER_CONFIGURE always succeeds, even if another component has it;
the owner loses it by returning it, or after five seconds of silence. The owner of secondary control steers while
nobody has primary control. Locations (ROI) are not supported.
"""

from __future__ import annotations

import asyncio
from math import degrees
from typing import Any, Optional

from sbgc.emulator import Angles
from sbgc.mavlink import LOG
from sbgc.mavlink.codec import Ids, Message, Result, mav
from sbgc.mavlink.device import ONE_COMPONENT, Device, Fields

INTERVAL = 0.2
SEARCH = 1.0  # seconds in which another manager is searched for
MANUAL_RATE = 30.0  # degrees per second for a stick at its end, which is also the limit of the axis
NOBODY = (0, 0)
UNCHANGED, MYSELF, NO_LONGER_ME = (-1, -1), (-2, -2), (-3, -3)


class Manager(Device):
    """A device that manages itself, unless another component announces that it does."""

    _owners: list[Ids] = [NOBODY, NOBODY]  # of primary and secondary control; it is replaced
    _has_rival = False

    async def run(self) -> None:
        await asyncio.gather(super().run(), self._manage())

    async def _manage(self) -> None:
        """Search for another manager; manage until one is heard."""
        while not self.vehicle.system:
            await asyncio.sleep(INTERVAL)
        wanted = mav.MAVLINK_MSG_ID_GIMBAL_MANAGER_INFORMATION
        self.send("COMMAND_LONG", command=mav.MAV_CMD_REQUEST_MESSAGE, param1=wanted)
        await asyncio.sleep(SEARCH)
        self.is_managed = not self._has_rival
        while self.is_managed:
            # Owners that are silent lose control.
            self._own([one if self.vehicle.hears(one) else NOBODY for one in self._owners])
            self.tell("GIMBAL_MANAGER_STATUS")
            await asyncio.sleep(INTERVAL)

    def _gimbal_manager_information(self) -> Fields:
        fields = self._gimbal_device_information()
        return fields and {**fields, "cap_flags": fields["cap_flags2"]}

    def _gimbal_manager_status(self) -> Fields:
        fields = {"flags": self._flags()}
        for name, owner in zip(("primary", "secondary"), self._owners):
            fields[f"{name}_control_sysid"], fields[f"{name}_control_compid"] = owner
        return fields

    def take(self, message: Message) -> None:
        name, values = message.name, message.values
        if name in ("GIMBAL_MANAGER_INFORMATION", "GIMBAL_MANAGER_STATUS"):
            is_near = message.sender[0] == self.vehicle.system
            if is_near and values.gimbal_device_id == self.component:
                self._has_rival, self.is_managed = True, False
                text = "%s: component %d manages it already; this program does not"
                LOG.error(text, self.name, message.sender[1])
        elif name.startswith("GIMBAL_MANAGER_SET_"):
            self._require(values.gimbal_device_id, message.sender)
            if name == "GIMBAL_MANAGER_SET_ATTITUDE":
                self.steer(values)
            else:
                self._turn(name, values)
        else:
            super().take(message)

    def execute(self, command: int, parameters: list[float], sender: Ids) -> int:
        if command == mav.MAV_CMD_DO_GIMBAL_MANAGER_CONFIGURE:
            self._require(parameters[6])
            self._configure(parameters, sender)
            return Result.ACCEPTED
        if command != mav.MAV_CMD_DO_GIMBAL_MANAGER_PITCHYAW:
            return super().execute(command, parameters, sender)
        self._require(parameters[6], sender)
        pitch, yaw, pitch_rate, yaw_rate, flags = parameters[:5]
        if not 0 <= flags < 1 << 32:
            raise ValueError("flags")
        angles, rates = Angles(0.0, pitch, yaw), Angles(0.0, pitch_rate, yaw_rate)
        return Result.ACCEPTED if self.aim(int(flags), angles, rates) else Result.FAILED

    def _require(self, device_id: float, sender: Optional[Ids] = None) -> None:
        """Raise ValueError unless this gimbal is addressed, and the sender, if given, may steer it."""
        if not self.is_managed or device_id not in (0, ONE_COMPONENT, self.component):
            raise ValueError("for_others")
        primary, secondary = self._owners
        owner = secondary if primary == NOBODY else primary
        if sender not in (None, owner) or sender == NOBODY:
            raise ValueError("not_in_control")

    def _configure(self, parameters: list[float], sender: Ids) -> None:
        wanted = []
        for owner, asked in zip(self._owners, (tuple(parameters[:2]), tuple(parameters[2:4]))):
            if asked in (MYSELF, sender):
                wanted.append(sender)
            elif asked in (NO_LONGER_ME, NOBODY) and owner == sender:
                wanted.append(NOBODY)
            elif asked in (UNCHANGED, NO_LONGER_ME, owner):
                wanted.append(owner)
            else:
                raise ValueError("of_others")  # nobody decides for them
        self._own(wanted)

    def _own(self, owners: list[Ids]) -> None:
        if owners != self._owners:
            LOG.info("%s: in control are %s", self.name, owners)
            self._owners = owners
            self.tell("GIMBAL_MANAGER_STATUS")

    def _turn(self, name: str, values: Any) -> None:
        """Execute SET_PITCHYAW or SET_MANUAL_CONTROL."""
        given = [values.pitch, values.yaw, values.pitch_rate, values.yaw_rate]
        if name == "GIMBAL_MANAGER_SET_PITCHYAW":
            given = [degrees(one) for one in given]
        elif any(abs(stick) > 1 for stick in given):
            raise ValueError("range")
        else:
            rates = [MANUAL_RATE * stick for stick in given[2:]]
            ends = zip(given, self.head.steering.limits[1:])
            angles = [stick * min(high if stick > 0 else -low, 180) for stick, (low, high) in ends]
            given = angles + rates
        self.aim(values.flags, Angles(0.0, *given[:2]), Angles(0.0, *given[2:]))
