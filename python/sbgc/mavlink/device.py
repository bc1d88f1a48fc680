"""The gimbal device of the Gimbal Protocol v2: one component for one gimbal."""

from __future__ import annotations

import asyncio
import re
import time
from argparse import Namespace
from collections.abc import Callable
from math import degrees, inf, isfinite, isnan, nan, radians
from typing import Any, Optional

from sbgc.emulator import Angles
from sbgc.mavlink import LOG
from sbgc.mavlink.codec import TYPES, Constants, Flags, Ids, Message, Result, mav
from sbgc.mavlink.geometry import angles_of, quaternion_of, rotation_of
from sbgc.mavlink.head import Head
from sbgc.mavlink.steering import YAW, Sample, Wish
from sbgc.mavlink.vehicle import AUTOPILOT, Vehicle
from sbgc.msg import BoardFeatures, SystemErrors

MOST = 1000.0  # degrees, and degrees per second
FASTEST = 50.0  # statuses per second
STATUS = "GIMBAL_DEVICE_ATTITUDE_STATUS"
Fields = Optional[dict[str, Any]]
LOCKS = Flags.ROLL_LOCK, Flags.PITCH_LOCK, Flags.YAW_LOCK
LEVEL = Flags.ROLL_LOCK | Flags.PITCH_LOCK
# GIMBAL_DEVICE_CAP_FLAGS: neutral; axis, follow and lock of roll, pitch and yaw; yaw in the earth frame.
CAPABILITIES, OF_YAW = 0x17FE, 0x1700
MANAGES_GIMBALS = 0x40000  # the capability COMPONENT_IMPLEMENTS_GIMBAL_MANAGER
ONE_COMPONENT = 1  # the gimbal_device_id of a gimbal that is one component with its manager
VERSION = 3  # of MAVLink, in heartbeats
NOBODY = 5.0  # seconds without a setpoint after which a gimbal has no manager
Failures, E = Constants("GIMBAL_DEVICE_ERROR_FLAGS"), SystemErrors
MOTORS = E.ERR_SET_POWER | E.ERR_CALIB_POLES | E.ERR_MISS_STEPS | E.ERR_EMERGENCY_STOP
ERRORS = {  # of the board, by what tells them
    Failures.POWER_ERROR: E.ERR_LOW_BAT1 | E.ERR_LOW_BAT2,
    Failures.MOTOR_ERROR: MOTORS | E.ERR_PROTECTION,
    Failures.SOFTWARE_ERROR: E.ERR_NO_SENSOR | E.ERR_CALIB_ACC | E.ERR_SYSTEM,
    Failures.COMMS_ERROR: E.ERR_SERIAL,
}


class Device:
    """A gimbal device, with the options of argparse. It obeys the autopilot, if not its manager."""

    is_managed = False  # by this component itself

    def __init__(self, vehicle: Vehicle, name: str, given: Namespace) -> None:
        self.vehicle, self.name, self.component = vehicle, name, given.component
        self.head = Head(given, vehicle.counters)
        self._rate = self._usual_rate = given.rate
        self._due = time.monotonic()  # when the next status is
        self._last_setpoint = -inf

    async def run(self) -> None:
        """Send heartbeats and statuses forever."""
        await self.vehicle.has_had_a_line.wait()  # or the first heartbeat would be lost
        beat = time.monotonic()
        while True:
            if (now := time.monotonic()) >= beat:
                self.tell("HEARTBEAT")
                beat = now + 1
            if self._rate and now >= self._due:
                self.tell(STATUS)
                self._due = max(self._due + 1 / self._rate, now)
            await asyncio.sleep(min(beat, self._due if self._rate else inf) - now)

    def send(self, name: str, **fields: Any) -> None:
        self.vehicle.send(self.component, name, **fields)

    def tell(self, name: str) -> int:
        """Send the message that a method of this name provides; returns a MAV_RESULT."""
        fields_of: Optional[Callable[[], Fields]] = getattr(self, f"_{name.lower()}", None)
        if fields_of is None:
            return Result.UNSUPPORTED
        if (fields := fields_of()) is None:
            return Result.TEMPORARILY_REJECTED
        fields["time_boot_ms"] = time.monotonic_ns() // 1_000_000 % 2**32
        is_managed = self.is_managed or name.startswith("GIMBAL_MANAGER")
        fields["gimbal_device_id"] = ONE_COMPONENT if is_managed else 0
        self.send(name, **{key: fields.get(key, 0) for key in TYPES[name].fieldnames})
        return Result.ACCEPTED

    def _heartbeat(self) -> Fields:
        sample, state = self.head.sample, mav.MAV_STATE_CRITICAL
        if sample is not None:
            state = mav.MAV_STATE_ACTIVE if sample.are_motors_on else mav.MAV_STATE_STANDBY
        kind = {"type": mav.MAV_TYPE_GIMBAL, "autopilot": mav.MAV_AUTOPILOT_INVALID}
        return {"system_status": state, "mavlink_version": VERSION, **kind}

    def _gimbal_device_attitude_status(self) -> Fields:
        """None while the board is silent, so that an autopilot notices."""
        if (sample := self.head.sample) is None:
            return None
        autopilot, fields = self.head.autopilot, dict[str, Any]()
        for axis, rate in zip("xyz", self.head.rates):
            fields[f"angular_velocity_{axis}"] = radians(rate)
        fields["delta_yaw"] = heading = radians(autopilot.heading)
        fields["delta_yaw_velocity"] = nan if isnan(heading) else radians(autopilot.turn)
        fields["q"] = quaternion_of(sample.angles._replace(yaw=sample.joints.yaw))
        return {"flags": self._flags(), "failure_flags": self._failures(sample), **fields}

    def _flags(self) -> int:
        """Return the state of the gimbal. Yaw is always in the frame of the vehicle."""
        found, heading = Flags.YAW_IN_VEHICLE_FRAME, self.head.autopilot.heading
        found |= 0 if isnan(heading) else Flags.ACCEPTS_YAW_IN_EARTH_FRAME
        wishes = self.head.steering.wishes
        locks = sum(lock for wish, lock in zip(wishes, LOCKS) if not wish.follows)
        return found | (locks if wishes else LEVEL)

    def _failures(self, sample: Sample) -> int:
        found = sum(on << number for number, on in enumerate(self.head.steering.limited))
        is_alone = time.monotonic() - self._last_setpoint > NOBODY and not self.is_managed
        found |= Failures.NO_MANAGER if is_alone else 0
        for flag, errors in ERRORS.items():
            found |= flag if sample.data.system_error & errors else 0
        found |= 0 if sample.are_motors_on else Failures.MOTOR_ERROR
        found |= Failures.CALIBRATION_RUNNING if int(sample.data.calib_mode) else 0
        return found

    def _gimbal_device_information(self) -> Fields:
        """Return all information about the gimbal: limits in radians, NaN where there is none."""
        if (who := self.head.identity) is None:
            return None
        has_yaw = who.info.board_features & BoardFeatures.BOARD_FEATURE_3AXIS
        able = CAPABILITIES if has_yaw else CAPABILITIES & ~OF_YAW
        fields: dict[str, Any] = {"cap_flags": able & 0xFFFF, "cap_flags2": able}
        for axis, ends in zip(Angles._fields, self.head.steering.limits):
            for end, value in zip(("min", "max"), ends):
                fields[f"{axis}_{end}"] = radians(value) if abs(value) <= 720 else nan
        fields.update(vendor_name=b"BaseCam Electronics", custom_name=self.name.encode()[:32])
        fields.update(model_name=f"SimpleBGC {who.board}".encode(), board=who.board.encode())
        fields.update(software_version=who.firmware.encode())
        fields.update(serial_number=who.serial_number.encode()[:32])
        fields["firmware_version"] = version_of(who.firmware)
        fields["hardware_version"] = version_of(who.board)
        fields["uid"] = int(who.serial_number or "0", 16) & 0xFFFFFFFFFFFFFFFF
        fields["capabilities"] = MANAGES_GIMBALS if self.is_managed else 0
        return fields

    def _component_information_basic(self) -> Fields:
        if (fields := self._gimbal_device_information()) is not None:
            fields["hardware_version"] = fields["board"]
        return fields

    def take(self, message: Message) -> None:
        """Process a message for this component, or a broadcast. Raises ValueError if it is rejected."""
        name, values = message.name, message.values
        if name in ("COMMAND_LONG", "COMMAND_INT"):
            self._answer(message)
        elif name in ("PARAM_REQUEST_LIST", "PARAM_REQUEST_READ", "PARAM_SET"):
            # The rate of statuses is the only parameter. It is constant: requests get its value.
            place = {"param_type": mav.MAV_PARAM_TYPE_REAL32, "param_count": 1, "param_index": 0}
            self.send("PARAM_VALUE", param_id=b"STATUS_RATE", param_value=self._rate, **place)
        elif name in ("AUTOPILOT_STATE_FOR_GIMBAL_DEVICE", "GIMBAL_DEVICE_SET_ATTITUDE"):
            is_setpoint = name == "GIMBAL_DEVICE_SET_ATTITUDE"
            is_of_autopilot = message.sender == (self.vehicle.system, AUTOPILOT)
            if not is_of_autopilot or is_setpoint and self.is_managed:
                raise ValueError("sender")
            if is_setpoint:
                self.steer(values)
            else:
                self.head.autopilot.take(values)

    def _answer(self, message: Message) -> None:
        """Execute a command and acknowledge it. Unsupported broadcast commands are not answered."""
        values = message.values
        parameters = [getattr(values, name) for name in values.get_fieldnames()[-7:]]
        try:
            result = self.execute(values.command, parameters, message.sender)
        except ValueError as error:
            self.vehicle.counters[str(error)] += 1
            result = Result.DENIED
        if result == Result.UNSUPPORTED:
            self.vehicle.counters["unsupported"] += 1
            if not values.target_component:
                return
        to = dict(zip(("target_system", "target_component"), message.sender))
        self.send("COMMAND_ACK", command=values.command, result=result, **to)

    def execute(self, command: int, parameters: list[float], sender: Ids) -> int:
        """Execute a command; returns a MAV_RESULT. Raises ValueError if it is denied."""
        name, interval = getattr(mav.mavlink_map.get(parameters[0]), "msgname", ""), parameters[1]
        if command == mav.MAV_CMD_REQUEST_MESSAGE:
            return self.tell(name)
        if command != mav.MAV_CMD_SET_MESSAGE_INTERVAL or name != STATUS:
            return Result.UNSUPPORTED
        if not isfinite(interval):
            raise ValueError("range")
        rate = self._usual_rate if interval == 0 else max(0.0, 1e6 / interval)
        self._rate, self._due = min(rate, FASTEST), time.monotonic()
        return Result.ACCEPTED

    def steer(self, values: Any) -> None:
        """Execute SET_ATTITUDE of a device or a manager. Raises ValueError."""
        q, flags = rotation_of(values.q), values.flags
        rates = Angles(*(degrees(getattr(values, f"angular_velocity_{axis}")) for axis in "xyz"))
        if q is None and not flags & Flags.NEUTRAL and all(isnan(rate) for rate in rates):
            raise ValueError("empty")
        self.aim(flags, Angles(nan, nan, nan) if q is None else angles_of(q), rates)

    def aim(self, flags: int, angles: Angles, rates: Angles) -> bool:
        """Turn each axis to its angle, or with its rate if the angle is NaN; in degrees.

        Axes where both are NaN hold still. Returns False if it has no effect; raises ValueError if invalid.
        """
        if flags & Flags.NEUTRAL:
            angles, flags = Angles(0.0, 0.0, 0.0), flags & Flags.RETRACT | LEVEL
        if flags & Flags.RETRACT:  # ArduPilot sends meaningless rates of 0 with it
            raise ValueError("retract")
        if flags & Flags.YAW_IN_VEHICLE_FRAME and flags & Flags.YAW_IN_EARTH_FRAME:
            raise ValueError("flags")
        if any(abs(one) > MOST for one in (*angles, *rates)):
            raise ValueError("range")
        self._last_setpoint = time.monotonic()
        # ArduPilot sends no flag for a gimbal that follows; roll and pitch are stabilized nevertheless.
        locks = flags if flags & (LEVEL | Flags.YAW_LOCK) else LEVEL
        axes = zip(LOCKS, angles, rates)
        wishes = [Wish(not locks & lock, angle, rate) for lock, angle, rate in axes]
        if not isnan(angles.yaw):
            wishes[YAW] = self._yaw(flags, angles.yaw)
        return self.head.aim(wishes)

    def _yaw(self, flags: int, yaw: float) -> Wish:
        """Return frame and angle of a yaw, which is not always given in the frame where it is locked."""
        locks, autopilot = bool(flags & Flags.YAW_LOCK), self.head.autopilot
        is_given = flags & (Flags.YAW_IN_VEHICLE_FRAME | Flags.YAW_IN_EARTH_FRAME)
        is_in_earth = bool(flags & Flags.YAW_IN_EARTH_FRAME) if is_given else locks
        if isnan(autopilot.heading + autopilot.north):
            if is_in_earth:
                text = "%s: the autopilot tells no heading: yaw follows the vehicle"
                LOG.warning(text, self.name)
            elif locks and (sample := self.head.sample) is not None:
                return Wish(False, yaw + sample.angles.yaw - sample.joints.yaw)
            return Wish(True, yaw)
        if not locks:
            return Wish(True, yaw - autopilot.heading if is_in_earth else yaw)
        return Wish(False, yaw if is_in_earth else yaw + autopilot.heading, is_north=True)


def version_of(text: str) -> int:
    """Encode a version such as 2.59, 2.74.5 or 2.43b9 for MAVLink: dev, patch, minor, major."""
    found = re.match(r"(\d+)\.(\d+)(?:\.(\d+))?(?:b(\d+))?", text)
    parts = [min(int(part), 255) for part in found.groups("0")] if found else []
    return int.from_bytes(bytes(parts), "little")
