"""The settings of the program, from options or a file with the same keys; see the guide."""

from __future__ import annotations

import re
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from configparser import ConfigParser
from difflib import get_close_matches
from pathlib import Path
from typing import NoReturn, Optional

from sbgc import _core

PROGRAM = "sbgc-mavlink"
ADDRESSES = "udpin:HOST:PORT, udpout:HOST:PORT, tcp:HOST:PORT, tcpin:HOST:PORT or /dev/PORT,RATE"
USUAL_LINE = "udpin:127.0.0.1:14550"
COMPONENTS = (154, 171, 172, 173, 174, 175)  # those of gimbals: at most six in one system
RANGES = {"speed": (0, 1000), "rate": (0.1, 50), "rate_timeout": (0.1, 5)}

FLAGS = {"yes": True, "true": True, "no": False, "false": False}


class Keys(ArgumentParser):
    """The keys of a section. Raises ValueError where argparse would end the program."""

    def error(self, message: str) -> NoReturn:
        raise ValueError(re.sub(r"^argument --", "", message))


def system_of(text: str) -> int:
    if not text.isdecimal() or not 1 <= int(text) <= 255:
        raise ArgumentTypeError(f"1 to 255 are possible, not {text!r}")
    return int(text)


VEHICLE, GIMBAL = (Keys(add_help=False) for _ in range(2))
add = VEHICLE.add_argument_group("the vehicle").add_argument
add("--line", action="append", metavar="ADDRESS", help=f"{ADDRESSES}; else {USUAL_LINE}")
text = "its id; without it, that of the autopilot that is heard"
add("--system", type=system_of, default=0, metavar="1..255", help=text)
text = "key of signing, 32 bytes or 64 digits: only signed messages count"
add("--key-file", default="", metavar="FILE", help=text)
add = GIMBAL.add_argument_group("the gimbal").add_argument
add("--component", type=int, choices=COMPONENTS, help="its id; else the first that is free")
add("--manager", action="store_true", help="be the gimbal manager as well")
add("--arm", action="store_true", help="a setpoint turns the motors on, once; the camera jumps")
for axis, usual in (("roll", 1), ("pitch", -1), ("yaw", 1)):
    text = f"1 if the board counts {axis} as MAVLink does, else -1; by default {usual}"
    add(f"--{axis}-sign", type=int, choices=(1, -1), default=usual, help=text)
text = "degrees per second towards an angle; 0, by default, is that of the parameters"
add("--speed", type=float, default=0.0, help=text)
add("--rate", type=float, default=20.0, help="attitudes per second, by default 20")
add("--rate-timeout", type=float, default=0.5, help="seconds until a rate ends, by default 0.5")
IN_FILE = Keys(add_help=False, parents=[GIMBAL])
IN_FILE.add_argument("--port", required=True)
IN_FILE.add_argument("--vehicle", default="")
KINDS = {"vehicle": VEHICLE, "gimbal": IN_FILE}
REQUIRED: dict[str, list[str]] = {"vehicle": [], "gimbal": ["--port="]}


def meant(word: str, known: list[str], otherwise: str) -> str:
    near = get_close_matches(word, known, 1)
    return f"; did you mean {near[0]!r}?" if near else otherwise


def place_of(path: Path, text: str, section: str, key: str = "") -> str:
    """Return "FILE:LINE: " of a key, or without one, of the section."""
    found, is_inside = 0, False
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("["):
            is_inside = line.startswith(f"[{section}]")
            found = number if is_inside else found
        elif is_inside and key and re.match(rf"\s*{re.escape(key)}\s*[=:]", line, re.IGNORECASE):
            return f"{path}:{number}: "
    return f"{path}:{found}: "


def words_of(kind: str, key: str, value: str) -> list[str]:
    """Return the arguments for a key of a section. Raises ValueError."""
    usual = vars(KINDS[kind].parse_args(REQUIRED[kind]))
    known = [name.replace("_", "-") for name in usual]
    if key not in known:
        otherwise = f"; keys of [{kind}] are {', '.join(known)}"
        raise ValueError(f"unknown key {key!r}{meant(key, known, otherwise)}")
    if usual[key.replace("-", "_")] is not False:
        return [f"--{key}={one}" for one in value.split("\n") if one]
    if value.lower() not in FLAGS:
        raise ValueError(f"{key}: it is yes or no, not {value!r}")
    return [f"--{key}"] if FLAGS[value.lower()] else []


class Settings:
    """The results of argparse, by the names of vehicles and gimbals."""

    def __init__(self) -> None:
        self.vehicles: dict[str, Namespace] = {}
        self.gimbals: dict[str, Namespace] = {}
        self._places: dict[str, str] = {}  # of the ports of gimbals in a file

    def read(self, path: Path) -> None:
        """Read a file. Raises OSError, configparser.Error and ValueError."""
        file, text = ConfigParser(interpolation=None), path.read_text(encoding="utf-8")
        file.read_string(text, str(path))
        for section in file.sections():
            kind, _, name = section.partition(" ")
            if kind not in KINDS:
                known = "; there are [vehicle], [vehicle NAME], [gimbal] and [gimbal NAME]"
                wrong = f"unknown section [{section}]{meant(kind.lower(), list(KINDS), known)}"
                raise ValueError(place_of(path, text, section) + wrong)
            key, words = "", list[str]()
            try:
                if kind == "gimbal" and "port" not in file[section]:
                    raise ValueError("its port is missing, such as port = /dev/ttyUSB0")
                for key, value in file[section].items():
                    words += words_of(kind, key, value)
                    KINDS[kind].parse_args([*REQUIRED[kind], *words])
                key = ""
                given = KINDS[kind].parse_args(words)
            except ValueError as error:
                raise ValueError(f"{place_of(path, text, section, key)}{error}") from None
            (self.vehicles if kind == "vehicle" else self.gimbals)[name] = given
            if kind == "gimbal":
                self._places[name] = place_of(path, text, section, "port")

    def write(self, path: Path) -> None:
        """Write the file that read() reads."""
        file = ConfigParser(interpolation=None)
        kinds = ("vehicle", self.vehicles, VEHICLE.parse_args([]))
        for kind, group, keys in (kinds, ("gimbal", self.gimbals, IN_FILE.parse_args(["--port="]))):
            for name, given in group.items():
                file.add_section(section := f"{kind} {name}".strip())
                for key in vars(keys):
                    if value := getattr(given, key):
                        text = "yes" if value is True else str(value)
                        text = "\n".join(value) if isinstance(value, list) else text
                        file.set(section, key.replace("_", "-"), text)
        with path.open("w", encoding="utf-8") as output:
            file.write(output)

    def complete(self) -> None:
        """Assign each gimbal its component. Raises ValueError if that is impossible."""
        if not self.gimbals:
            raise ValueError("there is no gimbal")
        self._check_ports()
        for given in self.vehicles.values():
            given.line = given.line or [USUAL_LINE]
        free = {name: list(COMPONENTS) for name in self.vehicles}
        # Gimbals with an explicit component come first.
        for name, gimbal in sorted(self.gimbals.items(), key=lambda item: not item[1].component):
            for key, (low, high) in RANGES.items():
                if not low <= getattr(gimbal, key) <= high:
                    raise ValueError(f"{key.replace('_', '-')}: {low:g} to {high:g} are possible")
            if gimbal.vehicle not in free:
                raise ValueError(f"gimbal {name}: there is no vehicle {gimbal.vehicle!r}")
            left = free[gimbal.vehicle]
            if not left or gimbal.component not in (None, *left):
                text = "six gimbals are possible, each its own component"
                raise ValueError(f"vehicle {gimbal.vehicle}: {text}")
            gimbal.component = gimbal.component or left[0]
            left.remove(gimbal.component)

    def _check_ports(self) -> None:
        """Raise ValueError if a port is no address, or that of another gimbal."""
        boards: dict[str, str] = {}
        for name, gimbal in self.gimbals.items():
            place, section = self._places.get(name, ""), f"[gimbal {name}]".replace(" ]", "]")
            try:
                board = _core.board_at(gimbal.port)
            except ValueError as error:
                raise ValueError(f"{place}{error}") from None
            if board in boards:
                text = f"{section} has the port of {boards[board]}, {gimbal.port}"
                raise ValueError(place + text)
            boards[board] = section


def key_of(path: str) -> Optional[bytes]:
    """Return the key in a file, if one is given. Raises OSError and ValueError."""
    if not path:
        return None
    data = Path(path).expanduser().read_bytes()
    try:
        key = data if len(data) == 32 else bytes.fromhex(data.decode("ascii"))
    except ValueError:
        key = b""
    if len(key) != 32:
        raise ValueError(f"{path}: a key has 32 bytes, or 64 hexadecimal digits")
    return key
