"""What the program is told, by options or by a file, whose keys are the same:

    [vehicle]
    line = udpin:0.0.0.0:14550
           /dev/ttyAMA0,921600
    [gimbal front]
    port = /dev/ttyUSB0
    roll-sign = -1

Several vehicles have names, `[vehicle left]`, and their gimbals a key `vehicle = left`.
"""

from __future__ import annotations

from argparse import ArgumentParser, ArgumentTypeError, Namespace
from collections.abc import Callable
from configparser import ConfigParser
from pathlib import Path
from typing import Optional

from sbgc.mavlink.protocol import GIMBALS

PROGRAM = "sbgc-mavlink"
USUAL_LINE = "udpin:127.0.0.1:14550"


def within(low: float, high: float) -> Callable[[str], float]:
    def number(text: str) -> float:
        value = float(text)
        if not low <= value <= high:
            raise ArgumentTypeError(f"{low:g} to {high:g} are possible")
        return value

    return number


def key_of(path: str) -> Optional[bytes]:
    """The key in a file, if one is named. Raises OSError, and ValueError if it is none."""
    if not path:
        return None
    data = Path(path).expanduser().read_bytes()
    key = data if len(data) == 32 else bytes.fromhex(data.decode("ascii"))
    if len(key) != 32:
        raise ValueError(f"{path}: a key has 32 bytes, or 64 hexadecimal digits")
    return key


def add_vehicle(parser: ArgumentParser) -> None:
    add = parser.add_argument_group("the vehicle").add_argument
    text = "udpin:HOST:PORT, udpout:HOST:PORT, tcp:HOST:PORT, tcpin:HOST:PORT or /dev/PORT,RATE"
    add("--line", action="append", metavar="ADDRESS", help=f"{text}; {USUAL_LINE} if there is none")
    text = "its id; without it, that of the autopilot that is heard"
    add("--system", type=int, choices=range(1, 256), default=0, metavar="1..255", help=text)
    text = "key of signing, 32 bytes or 64 digits: only signed messages count"
    add("--key-file", default="", metavar="FILE", help=text)


def add_gimbal(parser: ArgumentParser) -> None:
    add = parser.add_argument_group("the gimbal").add_argument
    add("--component", type=int, choices=GIMBALS, help="its id; by default the first that is free")
    add("--manager", action="store_true", help="be the gimbal manager as well")
    add(
        "--arm",
        action="store_true",
        help="let a setpoint turn the motors on, once; the camera jumps then",
    )
    for axis, usual in (("roll", 1), ("pitch", -1), ("yaw", 1)):
        text = f"1 if the board counts {axis} as MAVLink does, else -1; by default {usual}"
        add(f"--{axis}-sign", type=int, choices=(1, -1), default=usual, help=text)
    text = "degrees per second towards an angle; 0, by default, is that of the parameters"
    add("--speed", type=within(0, 1000), default=0.0, help=text)
    text = "attitudes per second, by default 20"
    add("--rate", type=within(0.1, 50), default=20.0, help=text)
    text = "seconds after which a rate ends by itself, by default 0.5"
    add("--rate-timeout", type=within(0.1, 5), default=0.5, help=text)


class Settings:
    """What argparse has found: by the names of vehicles, and those of gimbals."""

    def __init__(self) -> None:
        self.vehicles: dict[str, Namespace] = {}
        self.gimbals: dict[str, Namespace] = {}

    def read(self, path: Path) -> None:
        """Read a file. Raises OSError and configparser.Error; ends the program if it is wrong."""
        file = ConfigParser(interpolation=None)
        file.read_string(path.read_text(encoding="utf-8"), str(path))
        for section in file.sections():
            kind, _, name = section.partition(" ")
            parser = ArgumentParser(f"{PROGRAM}: {path}: [{section}]", usage="", add_help=False)
            if kind == "vehicle":
                add_vehicle(parser)
                self.vehicles[name] = parser.parse_args(_words(file, section))
            else:
                parser.add_argument("--port", required=True)
                parser.add_argument("--vehicle", default="")
                add_gimbal(parser)
                self.gimbals[name] = parser.parse_args(_words(file, section))
        self.complete()

    def complete(self) -> None:
        """Give each gimbal its component. Raises ValueError if that is impossible."""
        for name, gimbal in self.gimbals.items():
            if gimbal.vehicle not in self.vehicles:
                raise ValueError(f"gimbal {name}: there is no vehicle {gimbal.vehicle!r}")
        for vehicle in self.vehicles:
            own = [one for one in self.gimbals.values() if one.vehicle == vehicle]
            taken = [one.component for one in own if one.component]
            free = [one for one in GIMBALS if one not in taken]
            if len(own) > len(GIMBALS) or len(set(taken)) < len(taken):
                raise ValueError(
                    f"vehicle {vehicle}: six gimbals are possible, each its own component"
                )
            for gimbal in own:
                gimbal.component = gimbal.component or free.pop(0)


def _words(file: ConfigParser, section: str) -> list[str]:
    """The keys of a section as options."""
    words = []
    for name, value in file[section].items():
        if value.lower() in ("yes", "no"):
            words += [f"--{name}"] if value.lower() == "yes" else []
        else:
            words += [f"--{name}={one}" for one in value.split("\n") if one]
    return words
