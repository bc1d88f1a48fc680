"""Gimbals as devices of MAVLink, for autopilots and ground stations; see the guide "Drones"."""

from __future__ import annotations

import asyncio
import logging
import sys
from argparse import ArgumentParser
from configparser import Error as FileError
from importlib.util import find_spec
from pathlib import Path

from sbgc.errors import Error
from sbgc.mavlink.options import PROGRAM, Settings, add_gimbal, add_vehicle


def main() -> int:
    parser = ArgumentParser(PROGRAM, description=__doc__, allow_abbrev=False)
    text = "its address: /dev/ttyUSB0, tcp:HOST:PORT, or another one of sbgc"
    parser.add_argument("port", nargs="?", help=text)
    parser.add_argument("--config", type=Path, metavar="FILE", help="read all of this from a file")
    text = "turn each axis by 5 degrees, ask what was seen, and write this configuration file"
    parser.add_argument("--check", type=Path, metavar="FILE", help=text)
    parser.add_argument("-v", "--verbose", action="store_true", help="log more")
    add_vehicle(parser)
    add_gimbal(parser)
    given = parser.parse_args()
    if (given.port is None) == (given.config is None):
        parser.error("either the address of a gimbal is needed, or --config")
    level = logging.DEBUG if given.verbose else logging.INFO
    logging.basicConfig(level=level, format="%(levelname)s %(message)s")
    settings = Settings()
    try:
        if given.config:
            settings.read(given.config)
        else:
            given.vehicle = ""
            settings.vehicles[""] = settings.gimbals[""] = given
            settings.complete()
        if find_spec("pymavlink") is None:
            raise ValueError("pymavlink is missing: pip install sbgc[mavlink]")
        from sbgc.mavlink import check, program

        if given.check:
            asyncio.run(check.check(settings, given.check))
        else:
            asyncio.run(program.run(settings))
    except (Error, FileError, OSError, ValueError, EOFError) as error:
        print(f"{PROGRAM}: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
