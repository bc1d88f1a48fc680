"""The settings of the program, from options or a file with the same keys; see the guide."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from configparser import ConfigParser
from pathlib import Path
from typing import Optional

PROGRAM = "sbgc-mavlink"
ADDRESSES = "udpin:HOST:PORT, udpout:HOST:PORT, tcp:HOST:PORT, tcpin:HOST:PORT or /dev/PORT,RATE"
USUAL_LINE = "udpin:127.0.0.1:14550"
COMPONENTS = (154, 171, 172, 173, 174, 175)  # those of gimbals: at most six in one system
RANGES = {"speed": (0, 1000), "rate": (0.1, 50), "rate_timeout": (0.1, 5)}

VEHICLE, GIMBAL = (ArgumentParser(usage="", add_help=False) for _ in range(2))
add = VEHICLE.add_argument_group("the vehicle").add_argument
add("--line", action="append", metavar="ADDRESS", help=f"{ADDRESSES}; else {USUAL_LINE}")
text = "its id; without it, that of the autopilot that is heard"
add("--system", type=int, choices=range(1, 256), default=0, metavar="1..255", help=text)
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
IN_FILE = ArgumentParser(usage="", add_help=False, parents=[GIMBAL])
IN_FILE.add_argument("--port", required=True)
IN_FILE.add_argument("--vehicle", default="")


class Settings:
    """The results of argparse, by the names of vehicles and gimbals."""

    def __init__(self) -> None:
        self.vehicles: dict[str, Namespace] = {}
        self.gimbals: dict[str, Namespace] = {}

    def read(self, path: Path) -> None:
        """Read a file. Raises OSError and configparser.Error; ends the program if it is invalid."""
        file = ConfigParser(interpolation=None)
        file.read_string(path.read_text(encoding="utf-8"), str(path))
        for section in file.sections():
            kind, _, name = section.partition(" ")
            is_vehicle, words = kind == "vehicle", list[str]()
            for key, value in file[section].items():
                is_flag = value.lower() in ("yes", "no")
                words += [f"--{key}={one}" for one in value.split("\n") if one and not is_flag]
                words += [f"--{key}"] if value.lower() == "yes" else []
            parser = VEHICLE if is_vehicle else IN_FILE
            parser.prog = f"{PROGRAM}: {path}: [{section}]"
            (self.vehicles if is_vehicle else self.gimbals)[name] = parser.parse_args(words)

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


def key_of(path: str) -> Optional[bytes]:
    """Return the key in a file, if one is given. Raises OSError and ValueError."""
    if not path:
        return None
    data = Path(path).expanduser().read_bytes()
    key = data if len(data) == 32 else bytes.fromhex(data.decode("ascii"))
    if len(key) != 32:
        raise ValueError(f"{path}: a key has 32 bytes, or 64 hexadecimal digits")
    return key
