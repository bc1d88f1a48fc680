"""What a gimbal tells about itself."""

from __future__ import annotations

import time
from collections.abc import Callable
from math import isnan, nan, radians
from typing import TYPE_CHECKING, Any, Optional

from sbgc.emulator import Angles
from sbgc.link import Identity
from sbgc.mavlink.geometry import quaternion_of
from sbgc.mavlink.head import version_of
from sbgc.mavlink.protocol import CAPABILITIES, LOCKS, MANAGES_GIMBALS, OF_YAW, ONE_COMPONENT
from sbgc.mavlink.protocol import Failure, Flags, Number
from sbgc.mavlink.steering import Frame, Sample
from sbgc.msg import SystemErrors

if TYPE_CHECKING:
    from sbgc.mavlink.device import Device

GIMBAL, NO_AUTOPILOT, VERSION = 26, 8, 3
STANDBY, ACTIVE, CRITICAL = 3, 4, 5
VENDOR = b"BaseCam Electronics"
NOBODY = 5.0  # seconds without a setpoint after which a gimbal has no manager
FAILURES = {
    "LOW_BAT1 LOW_BAT2": Failure.POWER_ERROR,
    "SET_POWER CALIB_POLES PROTECTION MISS_STEPS EMERGENCY_STOP": Failure.MOTOR_ERROR,
    "NO_SENSOR CALIB_ACC SYSTEM": Failure.SOFTWARE_ERROR,
    "SERIAL": Failure.COMMS_ERROR,
}
ERRORS = {
    int(SystemErrors[f"ERR_{one}"]): int(flag)
    for names, flag in FAILURES.items()
    for one in names.split()
}


class Reports:
    """Sends the messages of a device, and those of its manager."""

    def __init__(self, device: Device) -> None:
        self._device = device
        self._senders: dict[int, Callable[[], bool]] = {
            Number.HEARTBEAT: self._send_heartbeat,
            Number.DEVICE_STATUS: self._send_status,
            Number.DEVICE_INFORMATION: self._send_information,
            Number.COMPONENT_INFORMATION_BASIC: self._send_basic,
        }

    def tell(self, number: float) -> Optional[bool]:
        """Send a message: None if there is no such one, False if what it tells is not known yet."""
        if number in self._senders:
            return self._senders[int(number)]()
        manager = self._device.manager
        if manager is None or number not in (Number.MANAGER_INFORMATION, Number.MANAGER_STATUS):
            return None
        return manager.tell(int(number))

    def send(self, name: str, **fields: Any) -> bool:
        """Send a message of this component."""
        self._device.vehicle.send(self._device.component, name, **fields)
        return True

    def _send_heartbeat(self) -> bool:
        sample = self._device.head.sample
        state = ACTIVE if sample is not None and sample.are_motors_on else STANDBY
        state = state if self._device.head.is_alive else CRITICAL
        kind = {"type": GIMBAL, "autopilot": NO_AUTOPILOT, "mavlink_version": VERSION}
        return self.send("HEARTBEAT", base_mode=0, custom_mode=0, system_status=state, **kind)

    def _send_status(self) -> bool:
        """Send the attitude; none while the board is silent, so that an autopilot notices."""
        head, autopilot = self._device.head, self._device.autopilot
        sample = head.sample
        if sample is None or not head.is_alive:
            return False
        attitude = Angles(sample.angles.roll, sample.angles.pitch, sample.joints.yaw)
        rates = [radians(rate) for rate in head.rates]
        fields: dict[str, Any] = {
            f"angular_velocity_{axis}": rate for axis, rate in zip("xyz", rates)
        }
        fields["delta_yaw"] = heading = radians(autopilot.heading)
        fields["delta_yaw_velocity"] = nan if isnan(heading) else radians(autopilot.turn)
        fields["failure_flags"] = self._failures(sample)
        fields.update(flags=int(self.flags), q=quaternion_of(attitude), **self._time_and_id())
        name = "GIMBAL_DEVICE_ATTITUDE_STATUS"
        return self.send(name, target_system=0, target_component=0, **fields)

    def _time_and_id(self) -> dict[str, int]:
        """The id is 0 unless the manager is the same component."""
        number = ONE_COMPONENT if self._device.is_managed_here else 0
        return {"time_boot_ms": self._device.vehicle.milliseconds, "gimbal_device_id": number}

    @property
    def flags(self) -> Flags:
        """What the gimbal does. Yaw is always told in the frame of the vehicle."""
        frames = self._device.head.steering.frames or [Frame.HORIZON, Frame.HORIZON, Frame.VEHICLE]
        flags = Flags.YAW_IN_VEHICLE_FRAME
        for frame, lock in zip(frames, LOCKS):
            flags |= Flags(0) if frame is Frame.VEHICLE else lock
        is_fresh = self._device.autopilot.is_fresh
        return flags | (Flags.ACCEPTS_YAW_IN_EARTH_FRAME if is_fresh else Flags(0))

    def _failures(self, sample: Sample) -> int:
        device = self._device
        found = sum(on << number for number, on in enumerate(device.head.steering.limited))
        for error, flag in ERRORS.items():
            found |= flag if sample.errors & error else 0
        found |= 0 if sample.are_motors_on else Failure.MOTOR_ERROR
        found |= Failure.CALIBRATION_RUNNING if sample.is_calibrating else 0
        is_alone = time.monotonic() - device.last_setpoint > NOBODY and not device.is_managed_here
        return found | (Failure.NO_MANAGER if is_alone else 0)

    def abilities(self) -> tuple[int, dict[str, float]]:
        """The capabilities; the limits in radians, NaN where there is none."""
        head, limits = self._device.head, {}
        for name, ends in zip(Angles._fields, head.steering.limits):
            for end, value in zip(("min", "max"), ends):
                limits[f"{name}_{end}"] = radians(value) if abs(value) <= 720 else nan
        return CAPABILITIES if head.has_yaw else CAPABILITIES & ~OF_YAW, limits

    def _send_information(self) -> bool:
        who = self._device.head.identity
        if who is None:
            return False
        able, fields = self.abilities()
        names: dict[str, Any] = {"custom_name": self._device.name.encode()[:32], **_names(who)}
        names["firmware_version"] = version_of(who.firmware)
        names["hardware_version"] = version_of(who.board)
        names["uid"] = int(who.serial_number or "0", 16) & 0xFFFFFFFFFFFFFFFF
        fields.update(cap_flags=able & 0xFFFF, cap_flags2=able, custom_cap_flags=0)
        return self.send("GIMBAL_DEVICE_INFORMATION", **names, **fields, **self._time_and_id())

    def _send_basic(self) -> bool:
        who, device = self._device.head.identity, self._device
        if who is None:
            return False
        fields: dict[str, Any] = {"time_boot_ms": device.vehicle.milliseconds, **_names(who)}
        fields["capabilities"] = MANAGES_GIMBALS if device.is_managed_here else 0
        fields.update(software_version=who.firmware.encode(), hardware_version=who.board.encode())
        fields.update(serial_number=who.serial_number.encode()[:32], time_manufacture_s=0)
        return self.send("COMPONENT_INFORMATION_BASIC", **fields)


def _names(who: Identity) -> dict[str, bytes]:
    return {"vendor_name": VENDOR, "model_name": f"SimpleBGC {who.board}".encode()}
