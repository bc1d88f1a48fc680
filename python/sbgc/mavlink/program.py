"""Runs vehicles with their gimbals, or checks the directions of the gimbals."""

from __future__ import annotations

import asyncio
import signal
from collections.abc import Coroutine
from pathlib import Path
from typing import Any

from sbgc import aio
from sbgc.mavlink import LOG
from sbgc.mavlink.device import Device
from sbgc.mavlink.lines import serve
from sbgc.mavlink.manager import Manager
from sbgc.mavlink.options import Settings
from sbgc.mavlink.vehicle import Vehicle

TURN, SPEED = 5.0, 5.0  # degrees, and degrees per second
SEEN = {"roll": "its right side went down", "pitch": "it looked up", "yaw": "it looked right"}


async def run(settings: Settings) -> None:
    """Run until SIGTERM or Ctrl-C. Raises OSError and ValueError for invalid lines and keys."""
    jobs: list[Coroutine[Any, Any, None]] = []
    vehicles = {name: Vehicle(name, given) for name, given in settings.vehicles.items()}
    for name, vehicle in vehicles.items():
        jobs += [vehicle.report(), *(serve(one, vehicle) for one in settings.vehicles[name].line)]
    for name, given in settings.gimbals.items():
        vehicle, kind = vehicles[given.vehicle], Manager if given.manager else Device
        device = kind(vehicle, name or given.port, given)
        vehicle.devices[given.component] = device.take
        jobs += [device.head.run(), device.run()]
        LOG.info("%s: component %d, at %s", device.name, given.component, given.port)
    tasks = [asyncio.ensure_future(job) for job in jobs]
    for number in (signal.SIGINT, signal.SIGTERM):
        asyncio.get_running_loop().add_signal_handler(number, tasks[0].cancel)
    try:
        await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    finally:
        for task in tasks:
            task.cancel()
        # Exiting earlier would cancel the stop of a rate.
        await asyncio.gather(*tasks, return_exceptions=True)
    for task in tasks:
        if not task.cancelled():
            task.result()


async def check(settings: Settings, path: Path) -> None:
    """Turn each axis a little, ask what the user saw, and write the signs into a configuration."""
    for name, gimbal in settings.gimbals.items():
        print(f"Gimbal {name or gimbal.port}: each axis turns by {TURN:g} degrees and back.")
        if not await _answer("Are the motors on, and hands and cables clear?"):
            print("Nothing has turned; its signs stay as they were.")
            continue
        async with aio.connect(gimbal.port) as board:
            for axis, seen in SEEN.items():
                begin = getattr(await board.angles(), axis)
                await board.move_to(**{axis: begin + TURN}, speed=SPEED)
                setattr(gimbal, f"{axis}_sign", 1 if await _answer(f"{axis}: {seen}?") else -1)
                await board.move_to(**{axis: begin}, speed=SPEED)
    settings.write(path)
    print(f"written: {path}")


async def _answer(question: str) -> bool:
    while True:
        said = (await asyncio.to_thread(input, f"{question} [y/n] ")).strip().lower()
        if said in ("y", "yes", "n", "no"):
            return said[0] == "y"
