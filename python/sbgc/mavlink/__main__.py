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
from sbgc.mavlink import LOG
from sbgc.mavlink.options import GIMBAL, PROGRAM, VEHICLE, Settings

SAID: dict[str, float] = {}


def is_new(record: logging.LogRecord) -> bool:
    """Return False for messages logged within the last minute: a lost line is tried each second."""
    text = record.getMessage()
    is_old = record.created - SAID.get(text, 0.0) < 60
    SAID[text] = SAID[text] if is_old else record.created
    return not is_old


def main() -> int:
    parser = ArgumentParser(PROGRAM, description=__doc__, parents=[VEHICLE, GIMBAL])
    parser.allow_abbrev = False
    text = "its address: /dev/ttyUSB0, tcp:HOST:PORT, or another one of sbgc"
    parser.add_argument("port", nargs="?", help=text)
    parser.add_argument("--config", type=Path, metavar="FILE", help="read all of this from a file")
    text = "turn each axis by 5 degrees, ask what was seen, and write this configuration file"
    parser.add_argument("--check", type=Path, metavar="FILE", help=text)
    given = parser.parse_args()
    if (given.port is None) == (given.config is None):
        parser.error("either the address of a gimbal is needed, or --config")
    logging.basicConfig(level=logging.INFO, format="%(levelname)s %(message)s")
    LOG.addFilter(is_new)
    settings, given.vehicle = Settings(), ""
    try:
        if given.config:
            settings.read(given.config)
        else:
            settings.vehicles[""] = settings.gimbals[""] = given
        settings.complete()
        if find_spec("pymavlink") is None:
            raise ValueError("pymavlink is missing: pip install sbgc[mavlink]")
        from sbgc.mavlink.program import check, run

        asyncio.run(check(settings, given.check) if given.check else run(settings))
    except (Error, FileError, OSError, ValueError, EOFError) as error:
        print(f"{PROGRAM}: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
