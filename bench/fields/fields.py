"""Measure reading the fields of messages in Python.

usage: fields.py PACKAGE_FOLDER    (writes the format of Google Benchmark)

The case "read" is a number in its unit at the top of a message, "group" one of an axis in a group, "variable" one
whose unit a flag selects. "property" is a property of a Python class that returns a number.
"""

from __future__ import annotations

import json
import sys
import time
import timeit
from collections.abc import Callable
from importlib import import_module
from typing import Any

sys.path.insert(0, sys.argv[1] if len(sys.argv) == 2 else sys.exit(__doc__))

sbgc: Any = import_module("sbgc")

READS, REPETITIONS = 20_000, 9


class Plain:
    @property
    def value(self) -> float:
        return 0.5


def main() -> int:
    data, angles, control = sbgc.msg.RealtimeData4(), sbgc.msg.GetAngles(), sbgc.msg.Control()
    axis, plain = control.axes.roll, Plain()
    cases: dict[str, Callable[[], object]] = {
        "property": lambda: plain.value,
        "read": lambda: data.bat_level,
        "group": lambda: angles.axes.roll.imu_angle,
        "variable": lambda: axis.speed,
    }
    measured = [
        {"name": f"fields/{name}", "cpu_time": seconds / READS * 1e9, "time_unit": "ns"}
        for name, read in cases.items()
        for seconds in timeit.repeat(
            read, timer=time.process_time, number=READS, repeat=REPETITIONS
        )
    ]
    json.dump({"benchmarks": measured}, sys.stdout, indent=1)
    return 0


if __name__ == "__main__":
    sys.exit(main())
