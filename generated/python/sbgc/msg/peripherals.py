# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Pins, servos, sound, I2C and virtual RC channels."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar, Optional, Union

from sbgc.fields import BYTES, RAW, REAL, TEXT, Axes, AxesOf, Elements, Field, GroupOf, ListOf
from sbgc.fields import Structure, ValueOf, Xyz
from sbgc.message import Message, Request
from sbgc.msg.enums import *
from sbgc.msg.packed import *
from sbgc.values import UNSET

if TYPE_CHECKING:
    from sbgc.msg import Confirm

__all__ = [
    "ApiVirtChControl",
    "ApiVirtChHighRes",
    "BeepSound",
    "I2cReadRegBuf",
    "I2cReadRegBufRequest",
    "I2cReadRegBufRequestNoRegister",
    "I2cReadRegBufRequestWideRegister",
    "I2cWriteRegBuf",
    "ReadRcInputs",
    "ReadRcInputsRequest",
    "ServoOut",
    "ServoOutExt",
    "ServoOutFour",
    "TriggerPin",
]

Bytes = Union[bytes, bytearray, memoryview]


class BeepSound(Request["Optional[Confirm]"]):
    """Play a melody through the motors, or a standard sound.

    CMD_BEEP_SOUND (89), to the board; 12 to 112 bytes. Effect: sets. Since firmware 2.59, board
    3.0. Source: Outgoing commands L985-L991; Variables L1222-L1227.
    """

    __slots__ = ()

    NO_ENVELOPE: ClassVar[int] = 0
    """For decay_factor, as raw value: no envelope."""
    PAUSE: ClassVar[int] = 21000
    """For note_freq_hz, as raw value: pause, then the envelope starts again."""
    mode: Field[BeepModes, BeepModes] = Field(ValueOf(BeepModes))
    """Sound to play."""
    note_length: Field[float, float] = Field(REAL)
    """Length of each note of a custom melody. Range: 8 to 2040 ms. Raw value 0: without meaning
    unless a custom melody is played.
    """
    note_length_raw: Field[int, int] = Field(RAW, of="note_length")
    """The number on the wire for note_length."""
    decay_factor: Field[int, int] = Field(RAW)
    """How slowly a note fades after each pause; 0 disables the envelope. Audible only with encoder
    firmware or while the motors are off. Range: 0 to 15. Value 0: no envelope.
    """
    reserved: Field[bytes, Bytes] = Field(BYTES)
    """Reserved; kept as it is."""
    note_freq_hz: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """The notes of a custom melody; at most 30 in firmware of the specification's time. Range: 554
    to 20999 Hz. Raw value 21000: pause, then the envelope starts again. At most 50.
    """
    note_freq_hz_raw: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW), of="note_freq_hz")
    """The number on the wire for note_freq_hz."""

    def __init__(
        self,
        *,
        mode: BeepModes = UNSET,
        note_length: float = UNSET,
        note_length_raw: int = UNSET,
        decay_factor: int = UNSET,
        reserved: Bytes = UNSET,
        note_freq_hz: Iterable[float] = UNSET,
        note_freq_hz_raw: Iterable[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            mode=mode,
            note_length=note_length,
            note_length_raw=note_length_raw,
            decay_factor=decay_factor,
            reserved=reserved,
            note_freq_hz=note_freq_hz,
            note_freq_hz_raw=note_freq_hz_raw,
            tail=tail,
        )


class TriggerPin(Request["Optional[Confirm]"]):
    """Switch an output pin.

    Confirmed only if the pin was switched. A pin in use as an input is not switched. The
    request for an input is always confirmed, with its level, or -1 if the pin is unavailable.

    CMD_TRIGGER_PIN (84), to the board; 2 bytes. Effect: sets. Source: Outgoing commands
    L717-L722; Variables L1153-L1155.
    """

    __slots__ = ()

    pin_id: Field[OutputPin, OutputPin] = Field(ValueOf(OutputPin))
    """The pin."""
    state: Field[PinState, PinState] = Field(ValueOf(PinState))
    """New state of the pin."""

    def __init__(
        self,
        *,
        pin_id: OutputPin = UNSET,
        state: PinState = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(pin_id=pin_id, state=state, tail=tail)


class ServoOut(Request["Optional[Confirm]"]):
    """Send PWM signals to eight servos.

    Outputs 1 to 4 share their pins with FC_ROLL, FC_PITCH, RC_PITCH and AUX1; 5 to 8 are
    reserved. A board may have fewer. Most servos take 500 to 2500 us, with 1500 us as their
    center. A pulse must be shorter than the period that SERVO_RATE sets. From firmware 2.70b8
    on, if an output is a PWM duty cycle, 1000 is 0 % and 2000 is 100 %.

    CMD_SERVO_OUT (36), to the board, simple form; 16 bytes. Effect: moves. Since board 3.0.
    Source: Outgoing commands L813-L824; Variables L1183-L1184.
    """

    __slots__ = ()

    FLOATING: ClassVar[int] = -1
    """For servo_time, as raw value: the pin is set free and floats."""
    LOW: ClassVar[int] = 0
    """For servo_time, as raw value: the pin is low all the time."""
    servo_time: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Pulse of each output. Range: -1 to 20000 us. Raw value -1: the pin is set free and floats.
    Raw value 0: the pin is low all the time.
    """
    servo_time_raw: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW), of="servo_time")
    """The number on the wire for servo_time."""

    def __init__(
        self,
        *,
        servo_time: Iterable[float] = UNSET,
        servo_time_raw: Iterable[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(servo_time=servo_time, servo_time_raw=servo_time_raw, tail=tail)


class ServoOutFour(Request["Optional[Confirm]"]):
    """Send PWM signals to the servos 1 to 4.

    Outputs 1 to 4 share their pins with FC_ROLL, FC_PITCH, RC_PITCH and AUX1; 5 to 8 are
    reserved. A board may have fewer. Most servos take 500 to 2500 us, with 1500 us as their
    center. A pulse must be shorter than the period that SERVO_RATE sets. From firmware 2.70b8
    on, if an output is a PWM duty cycle, 1000 is 0 % and 2000 is 100 %.

    CMD_SERVO_OUT (36), to the board, four form; 8 bytes. Effect: moves. Since board 3.0.
    Source: Vendor's code of 2026.
    """

    __slots__ = ()

    FLOATING: ClassVar[int] = -1
    """For servo_time, as raw value: the pin is set free and floats."""
    LOW: ClassVar[int] = 0
    """For servo_time, as raw value: the pin is low all the time."""
    servo_time: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Pulse of each output. Range: -1 to 20000 us. Raw value -1: the pin is set free and floats.
    Raw value 0: the pin is low all the time.
    """
    servo_time_raw: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW), of="servo_time")
    """The number on the wire for servo_time."""

    def __init__(
        self,
        *,
        servo_time: Iterable[float] = UNSET,
        servo_time_raw: Iterable[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(servo_time=servo_time, servo_time_raw=servo_time_raw, tail=tail)


class ServoOutExt(Request["None"]):
    """Send PWM signals to servos of the board and of its CAN motor drivers.

    Outputs that are not selected keep their signals. Most servos take 500 to 2500 us, with 1500
    us as their center.

    CMD_SERVO_OUT_EXT (133), to the board; 4 to 68 bytes. Effect: moves. Since firmware 2.73.2.
    Source: Later firmware.
    """

    __slots__ = ()

    FLOATING: ClassVar[int] = -1
    """For servo_time, as raw value: the pin is set free and floats."""
    LOW: ClassVar[int] = 0
    """For servo_time, as raw value: the pin is low all the time."""
    servo_bits: Field[ServoOutputs, ServoOutputs] = Field(ValueOf(ServoOutputs))
    """Outputs to set."""
    servo_time: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Pulse of each selected output, from the lowest bit to the highest. Range: -1 to 20000 us. Raw
    value -1: the pin is set free and floats. Raw value 0: the pin is low all the time.
    """
    servo_time_raw: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW), of="servo_time")
    """The number on the wire for servo_time."""

    def __init__(
        self,
        *,
        servo_bits: ServoOutputs = UNSET,
        servo_time: Iterable[float] = UNSET,
        servo_time_raw: Iterable[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            servo_bits=servo_bits,
            servo_time=servo_time,
            servo_time_raw=servo_time_raw,
            tail=tail,
        )


class I2cWriteRegBuf(Request["Confirm"]):
    """Write to a device on an I2C bus.

    The sensors and the EEPROM are on these buses, too. Write only to your own device, as the
    example does: a write to a sensor can make the camera move.

    CMD_I2C_WRITE_REG_BUF (39), to the board; 2 to 255 bytes. Effect: sets, stores. Since board
    3.0. Source: Outgoing commands L826-L835.
    """

    __slots__ = ()

    device_addr: Field[I2cDevice, int] = Field(ValueOf(I2cDevice))
    """The device."""
    reg_addr: Field[int, int] = Field(RAW)
    """First register."""
    data: Field[bytes, Bytes] = Field(BYTES)
    """Data to write."""

    def __init__(
        self,
        *,
        device_addr: int = UNSET,
        reg_addr: int = UNSET,
        data: Bytes = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(device_addr=device_addr, reg_addr=reg_addr, data=data, tail=tail)


class I2cReadRegBuf(Message):
    """Data from a device on an I2C bus.

    CMD_I2C_READ_REG_BUF (40), from the board; 0 to 255 bytes. Since board 3.0. Source: Incoming
    commands L458-L460.
    """

    __slots__ = ()

    data: Field[bytes, Bytes] = Field(BYTES)
    """The data, 1 to 255 bytes: as many as requested. At most 255."""

    def __init__(self, *, data: Bytes = UNSET, tail: Bytes = UNSET) -> None:
        self._start(data=data, tail=tail)


class I2cReadRegBufRequest(Request["I2cReadRegBuf"]):
    """Read from a device on an I2C bus.

    CMD_I2C_READ_REG_BUF (40), to the board, simple form; 3 bytes. Effect: reads. Since board
    3.0. Source: Outgoing commands L837-L845.
    """

    __slots__ = ()

    device_addr: Field[I2cDevice, int] = Field(ValueOf(I2cDevice))
    """The device."""
    reg_addr: Field[int, int] = Field(RAW)
    """First register."""
    data_len: Field[float, float] = Field(REAL)
    """Number of bytes to read. Range: 1 to 255 byte."""
    data_len_raw: Field[int, int] = Field(RAW, of="data_len")
    """The number on the wire for data_len."""

    def __init__(
        self,
        *,
        device_addr: int = UNSET,
        reg_addr: int = UNSET,
        data_len: float = UNSET,
        data_len_raw: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            device_addr=device_addr,
            reg_addr=reg_addr,
            data_len=data_len,
            data_len_raw=data_len_raw,
            tail=tail,
        )


class I2cReadRegBufRequestNoRegister(Request["I2cReadRegBuf"]):
    """Read from a device without registers.

    CMD_I2C_READ_REG_BUF (40), to the board, no_register form; 2 bytes. Effect: reads. Since
    board 3.0. Unconfirmed. Source: Outgoing commands L837-L845.
    """

    __slots__ = ()

    device_addr: Field[I2cDevice, int] = Field(ValueOf(I2cDevice))
    """The device."""
    data_len: Field[float, float] = Field(REAL)
    """Number of bytes to read. Range: 1 to 255 byte."""
    data_len_raw: Field[int, int] = Field(RAW, of="data_len")
    """The number on the wire for data_len."""

    def __init__(
        self,
        *,
        device_addr: int = UNSET,
        data_len: float = UNSET,
        data_len_raw: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            device_addr=device_addr,
            data_len=data_len,
            data_len_raw=data_len_raw,
            tail=tail,
        )


class I2cReadRegBufRequestWideRegister(Request["I2cReadRegBuf"]):
    """Read from a device with 16-bit register addresses.

    CMD_I2C_READ_REG_BUF (40), to the board, wide_register form; 4 bytes. Effect: reads. Since
    board 3.0. Unconfirmed. Source: Outgoing commands L837-L845.
    """

    __slots__ = ()

    device_addr: Field[I2cDevice, int] = Field(ValueOf(I2cDevice))
    """The device."""
    reg_addr: Field[int, int] = Field(RAW)
    """First register."""
    data_len: Field[float, float] = Field(REAL)
    """Number of bytes to read. Range: 1 to 255 byte."""
    data_len_raw: Field[int, int] = Field(RAW, of="data_len")
    """The number on the wire for data_len."""

    def __init__(
        self,
        *,
        device_addr: int = UNSET,
        reg_addr: int = UNSET,
        data_len: float = UNSET,
        data_len_raw: int = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(
            device_addr=device_addr,
            reg_addr=reg_addr,
            data_len=data_len,
            data_len_raw=data_len_raw,
            tail=tail,
        )


class ApiVirtChControl(Request["Optional[Confirm]"]):
    """Set the host's virtual RC channels, which can control the camera and more.

    Send all 32 channels to firmware before 2.70b5.

    CMD_API_VIRT_CH_CONTROL (45), to the board; 2 to 64 bytes. Effect: sets, stores, moves,
    restarts. Since board 3.0. Source: Outgoing commands L859-L865; Variables L1190-L1191.
    """

    __slots__ = ()

    UNDEFINED: ClassVar[int] = -10000
    """For val_ch, as raw value: undefined, as if the signal were lost."""
    val_ch: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Signal of each channel, starting with the first; the board clips values beyond the range.
    Range: -1 to 1. Raw value -10000: undefined, as if the signal were lost. At least 1. At
    most 32.
    """
    val_ch_raw: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW), of="val_ch")
    """The number on the wire for val_ch."""

    def __init__(
        self,
        *,
        val_ch: Iterable[float] = UNSET,
        val_ch_raw: Iterable[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(val_ch=val_ch, val_ch_raw=val_ch_raw, tail=tail)


class ApiVirtChHighRes(Request["None"]):
    """Set the host's virtual RC channels in high resolution; they can control the camera and more.

    These are the channels that CMD_API_VIRT_CH_CONTROL sets.

    CMD_API_VIRT_CH_HIGH_RES (116), to the board; 2 to 64 bytes. Effect: sets, stores, moves,
    restarts. Since firmware 2.68b7. Source: Later firmware.
    """

    __slots__ = ()

    UNDEFINED: ClassVar[int] = -32768
    """For val_ch, as raw value: undefined, as if the signal were lost."""
    val_ch: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Signal of each channel, starting with the first. Range: -1 to 1. Raw value -32768: undefined,
    as if the signal were lost. At least 1. At most 32.
    """
    val_ch_raw: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW), of="val_ch")
    """The number on the wire for val_ch."""

    def __init__(
        self,
        *,
        val_ch: Iterable[float] = UNSET,
        val_ch_raw: Iterable[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(val_ch=val_ch, val_ch_raw=val_ch_raw, tail=tail)


class ReadRcInputs(Message):
    """RC signals of selected inputs.

    CMD_READ_RC_INPUTS (100), from the board; 0 to 254 bytes. Since firmware 2.60. Source: Later
    firmware.
    """

    __slots__ = ()

    UNDEFINED: ClassVar[int] = -32768
    """For rc_val, as raw value: undefined."""
    rc_val: Field[Elements[float], Iterable[float]] = Field(ListOf(REAL))
    """Signal of each requested input, in the order of the request. Range: -1 to 1. Raw value
    -32768: undefined. At most 127.
    """
    rc_val_raw: Field[Elements[int], Iterable[int]] = Field(ListOf(RAW), of="rc_val")
    """The number on the wire for rc_val."""

    def __init__(
        self,
        *,
        rc_val: Iterable[float] = UNSET,
        rc_val_raw: Iterable[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(rc_val=rc_val, rc_val_raw=rc_val_raw, tail=tail)


class ReadRcInputsRequest(Request["ReadRcInputs"]):
    """Request the RC signals of selected inputs.

    CMD_READ_RC_INPUTS (100), to the board; 2 to 129 bytes. Effect: sets. Since firmware 2.60.
    Source: Later firmware.
    """

    __slots__ = ()

    cfg_flags: Field[RcInputOptions, RcInputOptions] = Field(ValueOf(RcInputOptions))
    """Options."""
    rc_src: Field[Elements[RcMap], Iterable[int]] = Field(ListOf(ValueOf(RcMap)))
    """The inputs; more than 127 signals do not fit into the response. At most 127."""

    def __init__(
        self,
        *,
        cfg_flags: RcInputOptions = UNSET,
        rc_src: Iterable[int] = UNSET,
        tail: Bytes = UNSET,
    ) -> None:
        self._start(cfg_flags=cfg_flags, rc_src=rc_src, tail=tail)
