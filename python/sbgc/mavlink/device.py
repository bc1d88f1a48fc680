"""The gimbal device of the Gimbal Protocol v2, one component for one gimbal: what it heeds."""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import Callable
from math import degrees, isfinite, isnan, nan
from typing import TYPE_CHECKING, Any, Optional

from sbgc.emulator import Angles
from sbgc.mavlink.autopilot import Autopilot
from sbgc.mavlink.codec import Message
from sbgc.mavlink.commands import Order, answer, answer_parameters
from sbgc.mavlink.geometry import angles_of, rotation_of
from sbgc.mavlink.head import Head
from sbgc.mavlink.protocol import AUTOPILOT, LEVEL, LOCKS, Command, Flags, Ids, Number, Result
from sbgc.mavlink.reports import Reports
from sbgc.mavlink.steering import Frame, Wish
from sbgc.mavlink.vehicle import Vehicle

if TYPE_CHECKING:
    from sbgc.mavlink.manager import Manager

LOG = logging.getLogger("sbgc.mavlink")
UNKNOWN = Angles(nan, nan, nan)
MOST = 1000.0  # degrees, and degrees per second
FASTEST = 50.0  # statuses per second


class Device:
    """A gimbal device. It heeds the manager in this process, else the autopilot.

    `rate` is that of statuses, per second.
    """

    def __init__(
        self, vehicle: Vehicle, component: int, head: Head, name: str = "", rate: float = 20.0
    ) -> None:
        self.vehicle, self.component, self.head, self.name = vehicle, component, head, name
        self.autopilot, self.reports = Autopilot(), Reports(self)
        self.manager: Optional[Manager] = None
        self.last_setpoint = -1e9
        self._usual_rate = self._rate = rate
        self._has_warned = False
        self._has_new_rate = asyncio.Event()
        head.north = lambda: self.autopilot.north
        vehicle.devices[component] = self

    async def run(self) -> None:
        """Send heartbeats and statuses for ever."""
        await asyncio.gather(self._send_heartbeats(), self._send_statuses())

    @property
    def is_managed_here(self) -> bool:
        return self.manager is not None and self.manager.is_active

    def take(self, message: Message) -> None:
        """Take a message for this component, or for all."""
        is_of_autopilot = message.sender == (self.vehicle.system, AUTOPILOT)
        if message.name in ("COMMAND_LONG", "COMMAND_INT"):
            answer(self, message, self._execute)
        elif message.name.startswith("PARAM_"):
            answer_parameters(self, message, self._rate)
        elif message.name == "AUTOPILOT_STATE_FOR_GIMBAL_DEVICE":
            self.attempt(is_of_autopilot, self._take_state, message.values)
        elif message.name == "GIMBAL_DEVICE_SET_ATTITUDE":
            is_of_manager = is_of_autopilot and not self.is_managed_here
            self.attempt(is_of_manager, self.steer, message.values)
        elif self.manager is not None:
            self.manager.take(message)

    def attempt(self, may: bool, take: Callable[[Any], object], values: Any) -> None:
        """Do what a message asks for if its sender may ask; count why not."""
        try:
            if not may:
                raise ValueError("sender")
            take(values)
        except ValueError as error:
            self.vehicle.counters[str(error)] += 1

    def _take_state(self, values: Any) -> None:
        self.autopilot.take(values)
        self.head.turn = self.autopilot.turn
        if self.head.sample is not None and self.head.is_alive:
            is_held = Frame.NORTH in (self.head.steering.frames or [])
            self.autopilot.correct(self.head.sample, is_held)

    def steer(self, values: Any) -> bool:
        """Do as SET_ATTITUDE of a device or a manager says. Raises ValueError."""
        flags, q = Flags(values.flags), rotation_of(values.q)
        given = values.angular_velocity_x, values.angular_velocity_y, values.angular_velocity_z
        if q is None and not flags & Flags.NEUTRAL and all(isnan(rate) for rate in given):
            raise ValueError("empty")
        rates = Angles(*(degrees(rate) for rate in given))
        return self.aim(flags, UNKNOWN if q is None else angles_of(q), rates)

    def aim(self, flags: Flags, angles: Angles, rates: Angles) -> bool:
        """Turn each axis to its angle, or with its rate if that is NaN; in degrees.

        What is NaN, too, holds still. False if nothing can come of it, because of the line or the motors.
        Raises ValueError for flags that contradict each other, and for what no gimbal does.
        """
        if flags & Flags.NEUTRAL:
            angles, flags = Angles(0.0, 0.0, 0.0), flags & Flags.RETRACT | LEVEL
        if flags & Flags.RETRACT:  # ArduPilot sends rates of 0 with it, which are none
            raise ValueError("retract")
        if flags & Flags.YAW_IN_VEHICLE_FRAME and flags & Flags.YAW_IN_EARTH_FRAME:
            raise ValueError("flags")
        if any(abs(one) > MOST for one in (*angles, *rates)):
            raise ValueError("range")
        self.last_setpoint = time.monotonic()
        # ArduPilot sends no flag for a gimbal that follows; roll and pitch are stabilized all the same.
        locks = flags if flags & (LEVEL | Flags.YAW_LOCK) else LEVEL
        roll, pitch, yaw = (
            Wish(Frame.HORIZON if locks & lock else Frame.VEHICLE, angle, rate)
            for lock, angle, rate in zip(LOCKS, angles, rates)
        )
        if not isnan(yaw.angle):
            yaw = Wish(*self._yaw(flags, yaw.angle))
        return self.head.aim((roll, pitch, yaw))

    def _yaw(self, flags: Flags, yaw: float) -> tuple[Frame, float]:
        """The frame and the angle of a yaw, which is not always given in the frame where it is locked."""
        locks, heading = bool(flags & Flags.YAW_LOCK), self.autopilot.heading
        is_given = flags & (Flags.YAW_IN_VEHICLE_FRAME | Flags.YAW_IN_EARTH_FRAME)
        is_in_earth = bool(flags & Flags.YAW_IN_EARTH_FRAME) if is_given else locks
        is_unknown, sample = isnan(heading) or self.autopilot.north is None, self.head.sample
        if is_unknown and is_in_earth and not self._has_warned:
            LOG.warning("%s: the autopilot tells no heading: yaw follows the vehicle", self.name)
        self._has_warned = is_unknown and (is_in_earth or self._has_warned)
        if is_unknown and locks and not is_in_earth and sample is not None:
            return Frame.HORIZON, yaw + sample.angles.yaw - sample.joints.yaw
        if is_unknown or not locks:
            return Frame.VEHICLE, yaw if is_unknown or not is_in_earth else yaw - heading
        return Frame.NORTH, yaw if is_in_earth else yaw + heading

    def _execute(self, order: Order) -> Optional[Result]:
        number, interval = order.parameters[0], order.parameters[1]
        if order.command == Command.REQUEST_MESSAGE:
            is_told = self.reports.tell(number)
            if is_told is None:
                return None
            return Result.ACCEPTED if is_told else Result.TEMPORARILY_REJECTED
        if order.command == Command.SET_MESSAGE_INTERVAL and number == Number.DEVICE_STATUS:
            if not isfinite(interval):
                return Result.DENIED
            rate = self._usual_rate if interval == 0 else 0.0 if interval < 0 else 1e6 / interval
            self._rate = min(rate, FASTEST)
            self._has_new_rate.set()
            return Result.ACCEPTED
        return None if self.manager is None else self.manager.execute(order)

    async def _send_heartbeats(self) -> None:
        while True:
            self.reports.tell(Number.HEARTBEAT)
            await asyncio.sleep(1)

    async def _send_statuses(self) -> None:
        loop = asyncio.get_running_loop()
        due = loop.time()
        while True:
            self._has_new_rate.clear()
            alarm = loop.call_at(due, self._has_new_rate.set) if self._rate else None
            await self._has_new_rate.wait()
            if alarm is not None:
                alarm.cancel()
            if self._rate and loop.time() >= due:
                self.reports.tell(Number.DEVICE_STATUS)
            due = max(due + 1 / self._rate, loop.time()) if self._rate else loop.time()
