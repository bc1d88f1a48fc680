# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Integers of the protocol that have several parts."""

from __future__ import annotations

from sbgc.msg.enums import *
from sbgc.values import UNSET, Packed, Part

__all__ = [
    "AhrsReferences",
    "AxisTuningOptions",
    "BoardVersion",
    "CanDeviceType",
    "ControlMode",
    "DebugPortLine",
    "DebugVarType",
    "EncoderConfigExt",
    "EncoderType",
    "EulerOrderChoice",
    "EulerOrderSetting",
    "ExtImuOrientation",
    "ExtImuStatus",
    "ExtMotorStatus",
    "ExtraButton",
    "FirmwareVersion",
    "ForcePositionConfig",
    "HelperCoordinates",
    "I2cDevice",
    "InputStates",
    "InterruptConfig",
    "MavConfig",
    "ModuleVersion",
    "PackedQuaternion",
    "RcMap",
    "RcMix",
    "RcMode",
    "StabAxis",
    "StartupAction",
    "StepSignalConfig",
    "TransparentTarget",
]


class BoardVersion(Packed):
    """Hardware version as a two-digit decimal number: 31 is 3.1."""

    major: Part[int] = Part(int)
    """Major version."""
    minor: Part[int] = Part(int)
    """Minor version."""

    def __new__(cls, raw: int = 0, *, major: int = UNSET, minor: int = UNSET) -> BoardVersion:
        return int.__new__(cls, raw)._with(major=major, minor=minor)


class FirmwareVersion(Packed):
    """Firmware version as a decimal number: 2439 is 2.43b9, 2745 is 2.74.5."""

    major: Part[int] = Part(int)
    """Major version."""
    minor: Part[int] = Part(int)
    """Minor version."""
    beta: Part[int] = Part(int)
    """Beta version, from 2.73 on a release; 0 is the first release."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        major: int = UNSET,
        minor: int = UNSET,
        beta: int = UNSET,
    ) -> FirmwareVersion:
        return int.__new__(cls, raw)._with(major=major, minor=minor, beta=beta)


class EulerOrderSetting(Packed):
    """Order of the Euler angles with its options."""

    order: Part[EulerOrder] = Part(EulerOrder)
    """The order."""
    flags: Part[EulerOrderFlags] = Part(EulerOrderFlags)
    """Options."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        order: EulerOrder = UNSET,
        flags: EulerOrderFlags = UNSET,
    ) -> EulerOrderSetting:
        return int.__new__(cls, raw)._with(order=order, flags=flags)


class RcMode(Packed):
    """How an RC signal controls an axis."""

    mode: Part[RcModeKind] = Part(RcModeKind)
    """What the signal controls."""
    inverted: Part[bool] = Part(bool)
    """The signal is inverted."""

    def __new__(cls, raw: int = 0, *, mode: RcModeKind = UNSET, inverted: bool = UNSET) -> RcMode:
        return int.__new__(cls, raw)._with(mode=mode, inverted=inverted)


class RcMap(Packed):
    """Source of an RC signal."""

    channel: Part[int] = Part(int)
    """Number of the input or virtual channel."""
    source: Part[RcSource] = Part(RcSource)
    """Kind of signal."""

    def __new__(cls, raw: int = 0, *, channel: int = UNSET, source: RcSource = UNSET) -> RcMap:
        return int.__new__(cls, raw)._with(channel=channel, source=source)


class RcMix(Packed):
    """Share of the flight controller's signal in an RC channel."""

    rate: Part[int] = Part(int)
    """0 is RC only, 32 half and half, 63 the flight controller only."""
    target: Part[MixTarget] = Part(MixTarget)
    """Target channel of the mix."""

    def __new__(cls, raw: int = 0, *, rate: int = UNSET, target: MixTarget = UNSET) -> RcMix:
        return int.__new__(cls, raw)._with(rate=rate, target=target)


class EncoderType(Packed):
    """Kind and options of an encoder."""

    model: Part[EncoderModel] = Part(EncoderModel)
    """Kind of encoder."""
    flags: Part[EncoderFlags] = Part(EncoderFlags)
    """Options."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        model: EncoderModel = UNSET,
        flags: EncoderFlags = UNSET,
    ) -> EncoderType:
        return int.__new__(cls, raw)._with(model=model, flags=flags)


class MavConfig(Packed):
    """Settings of a MAVLink channel."""

    baud: Part[SerialSpeed] = Part(SerialSpeed)
    """Baud rate."""
    parity_even: Part[bool] = Part(bool)
    """The parity is even."""
    heartbeat: Part[bool] = Part(bool)
    """Send heartbeats."""
    debug: Part[bool] = Part(bool)
    """Debug the channel."""
    rc: Part[bool] = Part(bool)
    """Take RC signals from the channel."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        baud: SerialSpeed = UNSET,
        parity_even: bool = UNSET,
        heartbeat: bool = UNSET,
        debug: bool = UNSET,
        rc: bool = UNSET,
    ) -> MavConfig:
        return int.__new__(
            cls,
            raw)._with(baud=baud,
            parity_even=parity_even,
            heartbeat=heartbeat,
            debug=debug,
            rc=rc,
        )


class StabAxis(Packed):
    """Axis that a motor stabilizes."""

    axis: Part[StabilizedAxis] = Part(StabilizedAxis)
    """The axis."""
    automatic_roll: Part[bool] = Part(bool)
    """The board may select roll."""
    automatic_pitch: Part[bool] = Part(bool)
    """The board may select pitch."""
    automatic_yaw: Part[bool] = Part(bool)
    """The board may select yaw."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        axis: StabilizedAxis = UNSET,
        automatic_roll: bool = UNSET,
        automatic_pitch: bool = UNSET,
        automatic_yaw: bool = UNSET,
    ) -> StabAxis:
        return int.__new__(
            cls,
            raw)._with(axis=axis,
            automatic_roll=automatic_roll,
            automatic_pitch=automatic_pitch,
            automatic_yaw=automatic_yaw,
        )


class StartupAction(Packed):
    """Action at start-up and its condition."""

    action: Part[MenuCommand] = Part(MenuCommand)
    """The action."""
    button_pressed: Part[bool] = Part(bool)
    """Only while the menu button is pressed."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        action: MenuCommand = UNSET,
        button_pressed: bool = UNSET,
    ) -> StartupAction:
        return int.__new__(cls, raw)._with(action=action, button_pressed=button_pressed)


class ForcePositionConfig(Packed):
    """When and how an axis snaps to a fixed position."""

    snap: Part[SnapAngle] = Part(SnapAngle)
    """Distance between the positions."""
    on_button: Part[bool] = Part(bool)
    """When the menu button is pressed."""
    at_startup: Part[bool] = Part(bool)
    """At start-up."""
    ignore_limits: Part[bool] = Part(bool)
    """Even beyond the limits of the axis."""
    fine_adjust: Part[bool] = Part(bool)
    """The position can be adjusted finely."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        snap: SnapAngle = UNSET,
        on_button: bool = UNSET,
        at_startup: bool = UNSET,
        ignore_limits: bool = UNSET,
        fine_adjust: bool = UNSET,
    ) -> ForcePositionConfig:
        return int.__new__(
            cls,
            raw)._with(snap=snap,
            on_button=on_button,
            at_startup=at_startup,
            ignore_limits=ignore_limits,
            fine_adjust=fine_adjust,
        )


class StepSignalConfig(Packed):
    """Steps of a step signal, and what triggers them."""

    steps: Part[StepCount] = Part(StepCount)
    """Number of steps."""
    button_pressed: Part[bool] = Part(bool)
    """Only while the menu button is pressed."""
    start_at_zero: Part[bool] = Part(bool)
    """The signal starts at 0."""
    trigger: Part[StepTrigger] = Part(StepTrigger)
    """Level that triggers a step."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        steps: StepCount = UNSET,
        button_pressed: bool = UNSET,
        start_at_zero: bool = UNSET,
        trigger: StepTrigger = UNSET,
    ) -> StepSignalConfig:
        return int.__new__(
            cls,
            raw)._with(steps=steps,
            button_pressed=button_pressed,
            start_at_zero=start_at_zero,
            trigger=trigger,
        )


class InterruptConfig(Packed):
    """Pin that signals an event to other devices."""

    pin: Part[int] = Part(int)
    """Number of the pin, as in CMD_TRIGGER_PIN."""
    on_emergency_stop: Part[bool] = Part(bool)
    """On an emergency stop."""
    on_parking: Part[bool] = Part(bool)
    """On reaching the parking position."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        pin: int = UNSET,
        on_emergency_stop: bool = UNSET,
        on_parking: bool = UNSET,
    ) -> InterruptConfig:
        return int.__new__(
            cls,
            raw)._with(pin=pin,
            on_emergency_stop=on_emergency_stop,
            on_parking=on_parking,
        )


class ExtImuOrientation(Packed):
    """Orientation of the external IMU."""

    top: Part[ExtImuAxis] = Part(ExtImuAxis)
    """Axis that points up."""
    right: Part[ExtImuAxis] = Part(ExtImuAxis)
    """Axis that points right."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        top: ExtImuAxis = UNSET,
        right: ExtImuAxis = UNSET,
    ) -> ExtImuOrientation:
        return int.__new__(cls, raw)._with(top=top, right=right)


class ExtraButton(Packed):
    """Pin of an additional button."""

    pin: Part[BoardPin] = Part(BoardPin)
    """The pin."""
    latching: Part[bool] = Part(bool)
    """The button latches."""
    inverted: Part[bool] = Part(bool)
    """The signal is inverted."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        pin: BoardPin = UNSET,
        latching: bool = UNSET,
        inverted: bool = UNSET,
    ) -> ExtraButton:
        return int.__new__(cls, raw)._with(pin=pin, latching=latching, inverted=inverted)


class EncoderConfigExt(Packed):
    """Resolution and turns of an encoder."""

    resolution: Part[int] = Part(int)
    """Bits of resolution, less 12."""
    multi_turn: Part[MultiTurn] = Part(MultiTurn)
    """Bits that count turns."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        resolution: int = UNSET,
        multi_turn: MultiTurn = UNSET,
    ) -> EncoderConfigExt:
        return int.__new__(cls, raw)._with(resolution=resolution, multi_turn=multi_turn)


class InputStates(Packed):
    """State of eight inputs."""

    input_1: Part[InputState] = Part(InputState)
    """Input 1."""
    input_2: Part[InputState] = Part(InputState)
    """Input 2."""
    input_3: Part[InputState] = Part(InputState)
    """Input 3."""
    input_4: Part[InputState] = Part(InputState)
    """Input 4."""
    input_5: Part[InputState] = Part(InputState)
    """Input 5."""
    input_6: Part[InputState] = Part(InputState)
    """Input 6."""
    input_7: Part[InputState] = Part(InputState)
    """Input 7."""
    input_8: Part[InputState] = Part(InputState)
    """Input 8."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        input_1: InputState = UNSET,
        input_2: InputState = UNSET,
        input_3: InputState = UNSET,
        input_4: InputState = UNSET,
        input_5: InputState = UNSET,
        input_6: InputState = UNSET,
        input_7: InputState = UNSET,
        input_8: InputState = UNSET,
    ) -> InputStates:
        return int.__new__(
            cls,
            raw)._with(input_1=input_1,
            input_2=input_2,
            input_3=input_3,
            input_4=input_4,
            input_5=input_5,
            input_6=input_6,
            input_7=input_7,
            input_8=input_8,
        )


class ControlMode(Packed):
    """Control mode and options, for one axis or for all."""

    mode: Part[ControlModeKind] = Part(ControlModeKind)
    """Meaning of speed and angle."""
    flags: Part[ControlFlags] = Part(ControlFlags)
    """Options."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        mode: ControlModeKind = UNSET,
        flags: ControlFlags = UNSET,
    ) -> ControlMode:
        return int.__new__(cls, raw)._with(mode=mode, flags=flags)


class EulerOrderChoice(Packed):
    """Order of the Euler angles of serial control."""

    order: Part[EulerOrderChange] = Part(EulerOrderChange)
    """The order."""
    flags: Part[EulerOrderFlags] = Part(EulerOrderFlags)
    """Options."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        order: EulerOrderChange = UNSET,
        flags: EulerOrderFlags = UNSET,
    ) -> EulerOrderChoice:
        return int.__new__(cls, raw)._with(order=order, flags=flags)


class HelperCoordinates(Packed):
    """Coordinate system and options of CMD_HELPER_DATA."""

    system: Part[CoordinateSystem] = Part(CoordinateSystem)
    """Coordinate system of all the vectors."""
    flags: Part[HelperDataFlags] = Part(HelperDataFlags)
    """Options."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        system: CoordinateSystem = UNSET,
        flags: HelperDataFlags = UNSET,
    ) -> HelperCoordinates:
        return int.__new__(cls, raw)._with(system=system, flags=flags)


class PackedQuaternion(Packed):
    """Attitude as a quaternion of length 1 without its largest component, which follows from the
    others.
    """

    a: Part[float] = Part(float)
    """The first of the other three components, in the order W, X, Y, Z."""
    b: Part[float] = Part(float)
    """The second one."""
    c: Part[float] = Part(float)
    """The third one."""
    largest: Part[QuaternionComponent] = Part(QuaternionComponent)
    """The omitted component."""
    largest_sign: Part[bool] = Part(bool)
    """1 if the omitted component is negative."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        a: float = UNSET,
        b: float = UNSET,
        c: float = UNSET,
        largest: QuaternionComponent = UNSET,
        largest_sign: bool = UNSET,
    ) -> PackedQuaternion:
        return int.__new__(
            cls,
            raw)._with(a=a,
            b=b,
            c=c,
            largest=largest,
            largest_sign=largest_sign,
        )


class ExtMotorStatus(Packed):
    """State of an external motor."""

    power: Part[ExtMotorPower] = Part(ExtMotorPower)
    """Whether it has power."""
    pins: Part[ExtMotorPins] = Part(ExtMotorPins)
    """Pins of its driver."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        power: ExtMotorPower = UNSET,
        pins: ExtMotorPins = UNSET,
    ) -> ExtMotorStatus:
        return int.__new__(cls, raw)._with(power=power, pins=pins)


class AxisTuningOptions(Packed):
    """What to tune on an axis."""

    enabled: Part[bool] = Part(bool)
    """Tune the axis."""
    tune_lpf: Part[bool] = Part(bool)
    """Tune its low-pass filter."""
    notch_filters: Part[int] = Part(int)
    """Number of notch filters to tune, 0 to 3."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        enabled: bool = UNSET,
        tune_lpf: bool = UNSET,
        notch_filters: int = UNSET,
    ) -> AxisTuningOptions:
        return int.__new__(
            cls,
            raw)._with(enabled=enabled,
            tune_lpf=tune_lpf,
            notch_filters=notch_filters,
        )


class AhrsReferences(Packed):
    """What corrects the estimated attitude of an IMU."""

    attitude: Part[AhrsReference] = Part(AhrsReference)
    """Reference of the attitude."""
    heading: Part[AhrsReference] = Part(AhrsReference)
    """Reference of the heading."""
    internal_used: Part[bool] = Part(bool)
    """The internal sensor is connected and used."""
    enabled: Part[bool] = Part(bool)
    """The estimation is enabled."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        attitude: AhrsReference = UNSET,
        heading: AhrsReference = UNSET,
        internal_used: bool = UNSET,
        enabled: bool = UNSET,
    ) -> AhrsReferences:
        return int.__new__(
            cls,
            raw)._with(attitude=attitude,
            heading=heading,
            internal_used=internal_used,
            enabled=enabled,
        )


class ExtImuStatus(Packed):
    """State of the external IMU."""

    state: Part[ExtImuState] = Part(ExtImuState)
    """State of the external IMU."""
    bad_mag: Part[bool] = Part(bool)
    """Its magnetometer is unreliable."""
    no_gps_signal: Part[bool] = Part(bool)
    """It receives no GPS signal."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        state: ExtImuState = UNSET,
        bad_mag: bool = UNSET,
        no_gps_signal: bool = UNSET,
    ) -> ExtImuStatus:
        return int.__new__(
            cls,
            raw)._with(state=state,
            bad_mag=bad_mag,
            no_gps_signal=no_gps_signal,
        )


class I2cDevice(Packed):
    """A device on one of the I2C buses."""

    port: Part[I2cPort] = Part(I2cPort)
    """Bus of the device."""
    address: Part[int] = Part(int)
    """7-bit address of the device."""

    def __new__(cls, raw: int = 0, *, port: I2cPort = UNSET, address: int = UNSET) -> I2cDevice:
        return int.__new__(cls, raw)._with(port=port, address=address)


class ModuleVersion(Packed):
    """Version as a decimal number: 120 is 1.20."""

    major: Part[int] = Part(int)
    """Major version."""
    minor: Part[int] = Part(int)
    """Minor version."""

    def __new__(cls, raw: int = 0, *, major: int = UNSET, minor: int = UNSET) -> ModuleVersion:
        return int.__new__(cls, raw)._with(major=major, minor=minor)


class CanDeviceType(Packed):
    """Kind of a device on the CAN bus, and how it got its id."""

    kind: Part[CanDeviceKind] = Part(CanDeviceKind)
    """Kind of the device."""
    hardware_assigned: Part[bool] = Part(bool)
    """The hardware of the device determines its id."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        kind: CanDeviceKind = UNSET,
        hardware_assigned: bool = UNSET,
    ) -> CanDeviceType:
        return int.__new__(cls, raw)._with(kind=kind, hardware_assigned=hardware_assigned)


class TransparentTarget(Packed):
    """Far end of a transparent connection."""

    port: Part[int] = Part(int)
    """Serial port of the device."""
    device: Part[TransparentDevice] = Part(TransparentDevice)
    """The device."""
    wait: Part[bool] = Part(bool)
    """1 waits until the port is free, 0 drops the data if it is not."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        port: int = UNSET,
        device: TransparentDevice = UNSET,
        wait: bool = UNSET,
    ) -> TransparentTarget:
        return int.__new__(cls, raw)._with(port=port, device=device, wait=wait)


class DebugPortLine(Packed):
    """Where a copied message was seen."""

    port: Part[int] = Part(int)
    """Index of the port."""
    direction: Part[bool] = Part(bool)
    """Direction of the message."""

    def __new__(cls, raw: int = 0, *, port: int = UNSET, direction: bool = UNSET) -> DebugPortLine:
        return int.__new__(cls, raw)._with(port=port, direction=direction)


class DebugVarType(Packed):
    """Type, axis and properties of a debug variable."""

    kind: Part[DebugVarKind] = Part(DebugVarKind)
    """Type of each value."""
    axis: Part[DebugVarAxis] = Part(DebugVarAxis)
    """Axis of the variable."""
    flags: Part[DebugVarFlags] = Part(DebugVarFlags)
    """Properties of the variable."""

    def __new__(
        cls,
        raw: int = 0,
        *,
        kind: DebugVarKind = UNSET,
        axis: DebugVarAxis = UNSET,
        flags: DebugVarFlags = UNSET,
    ) -> DebugVarType:
        return int.__new__(cls, raw)._with(kind=kind, axis=axis, flags=flags)
