"""Runs vehicles with their gimbals."""

from __future__ import annotations

import asyncio
import logging
import signal
from collections.abc import Coroutine
from typing import Any

from sbgc.mavlink.device import Device
from sbgc.mavlink.head import Head, Signs
from sbgc.mavlink.lines import line_of, serve
from sbgc.mavlink.manager import Manager
from sbgc.mavlink.options import USUAL_LINE, Settings, key_of
from sbgc.mavlink.steering import Steering
from sbgc.mavlink.vehicle import Vehicle

LOG = logging.getLogger("sbgc.mavlink")
REPORT = 60.0


async def run(settings: Settings) -> None:
    """Run until SIGTERM or Ctrl-C, or a cancellation; a rate that has not ended is stopped then.

    Raises ValueError if the address of a line, or a key, is none, and OSError for its file.
    """
    jobs: list[Coroutine[Any, Any, None]] = []
    vehicles = {}
    for name, given in settings.vehicles.items():
        lines = given.line or [USUAL_LINE]
        for line in lines:
            line_of(line)
        vehicle = vehicles[name] = Vehicle(name or "vehicle", given.system, key_of(given.key_file))
        jobs += [_report(vehicle), *(serve(line, vehicle) for line in lines)]
    for name, given in settings.gimbals.items():
        vehicle = vehicles[given.vehicle]
        signs = Signs(given.roll_sign, given.pitch_sign, given.yaw_sign)
        steering = Steering(given.rate_timeout, given.speed)
        head = Head(given.port, signs, steering, vehicle.counters, given.arm)
        device = Device(vehicle, given.component, head, name or given.port, given.rate)
        jobs += [head.run(), device.run()]
        if given.manager:
            jobs.append(Manager(device).run())
        LOG.info("%s: component %d, at %s", device.name, given.component, given.port)
    tasks = [asyncio.ensure_future(job) for job in jobs]
    running = asyncio.gather(*tasks)
    for number in (signal.SIGINT, signal.SIGTERM):
        asyncio.get_running_loop().add_signal_handler(number, running.cancel)
    try:
        await running
    except asyncio.CancelledError:
        pass  # which all tasks have got
    except BaseException:
        for task in tasks:
            task.cancel()
        raise
    finally:
        # gather() does not wait for the others; who leaves now cancels the stop of a rate.
        await asyncio.gather(*tasks, return_exceptions=True)


async def _report(vehicle: Vehicle) -> None:
    """Tell now and then what has been refused."""
    said: dict[str, int] = {}
    while True:
        await asyncio.sleep(REPORT)
        if vehicle.counters != said:
            said = dict(vehicle.counters)
            LOG.info("%s: refused so far: %s", vehicle.name, said)
