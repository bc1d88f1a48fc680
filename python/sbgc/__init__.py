"""The SimpleBGC gimbal protocol: messages and their bytes.

    from sbgc import Direction, decode, encode, msg

    request = msg.Control(axes=msg.Axes(pitch=msg.ControlAxis(angle=30)))
    frame = encode(request)
    decode(frame, Direction.TO_BOARD).axes.pitch.angle

`msg` has a class for every message and structure of the protocol. Fields are numbers in their units;
the field beside them with the suffix `_raw` is the number on the wire.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from sbgc import _core, msg
from sbgc.captures import read_capture
from sbgc.codec import (
    Direction,
    Frame,
    Parser,
    ParserCounters,
    Violation,
    decode,
    decode_body,
    describe,
    encode,
    encode_body,
    validate,
)
from sbgc.errors import (
    CodecError,
    DecodeError,
    EncodeError,
    Error,
    FieldError,
    GimbalDisconnected,
    GimbalError,
    GimbalInterrupted,
    GimbalSuperseded,
    GimbalTimeout,
)
from sbgc.message import Contexts, Message, Request
from sbgc.msg.protocol import Framing

if TYPE_CHECKING or hasattr(_core, "Link"):
    from sbgc.bode import BodeRecording, ResponsePoint, read_bode
    from sbgc.client import Gimbal, Stream, connect
    from sbgc.emulator import Angles, Board, emulator
    from sbgc.link import Calibration, Identity, Move, SpeedControl
    from sbgc.parameters import Profile, diff
    from sbgc.search import Found, Port, Usb, find, ports

if TYPE_CHECKING:
    from sbgc import aio

    __version__: str
else:

    def __getattr__(name: str) -> object:
        """Import slow parts on first use: asyncio, and the description of the package."""
        if name == "aio":
            return import_module("sbgc.aio")
        if name == "__version__":
            return import_module("importlib.metadata").version("sbgc")
        if name in __all__:
            raise AttributeError(f"sbgc.{name} needs the client, which is only for Linux")
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


__all__ = [
    "Angles",
    "Board",
    "BodeRecording",
    "Calibration",
    "CodecError",
    "Contexts",
    "DecodeError",
    "Direction",
    "EncodeError",
    "Error",
    "FieldError",
    "Found",
    "Frame",
    "Framing",
    "Gimbal",
    "GimbalDisconnected",
    "GimbalError",
    "GimbalInterrupted",
    "GimbalSuperseded",
    "GimbalTimeout",
    "Identity",
    "Message",
    "Move",
    "Parser",
    "ParserCounters",
    "Port",
    "Profile",
    "Request",
    "ResponsePoint",
    "SpeedControl",
    "Stream",
    "Usb",
    "Violation",
    "aio",
    "connect",
    "decode",
    "decode_body",
    "describe",
    "diff",
    "emulator",
    "encode",
    "encode_body",
    "find",
    "msg",
    "ports",
    "read_bode",
    "read_capture",
    "validate",
]
