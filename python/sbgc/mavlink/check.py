"""`--check`: turns each axis a little, asks what was seen, and writes the signs into a configuration file."""

from __future__ import annotations

import asyncio
from argparse import Namespace
from pathlib import Path

from sbgc import aio
from sbgc.mavlink.options import USUAL_LINE, Settings

TURN, SPEED = 5.0, 5.0  # degrees, and degrees per second
SEEN = {
    "roll": "its right side went down",
    "pitch": "it looked up",
    "yaw": "it looked to the right",
}


async def check(settings: Settings, path: Path) -> None:
    """Check all gimbals, and write the file. Raises GimbalError, and EOFError if nobody answers."""
    for name, gimbal in settings.gimbals.items():
        print(f"Gimbal {name or gimbal.port}: each axis turns by {TURN:g} degrees and back.")
        if await _answer("Are the motors on, and hands and cables clear?"):
            await _check_gimbal(gimbal)
        else:
            print("Nothing has turned; its signs stay as they were.")
    path.write_text(text_of(settings), encoding="utf-8")
    print(f"written: {path}")


async def _check_gimbal(gimbal: Namespace) -> None:
    async with aio.connect(gimbal.port) as board:
        for axis, seen in SEEN.items():
            begin = getattr(await board.angles(), axis)
            await board.move_to(**{axis: begin + TURN}, speed=SPEED)
            setattr(gimbal, f"{axis}_sign", 1 if await _answer(f"{axis}: {seen}?") else -1)
            await board.move_to(**{axis: begin}, speed=SPEED)


async def _answer(question: str) -> bool:
    while True:
        said = (await asyncio.to_thread(input, f"{question} [y/n] ")).strip().lower()
        if said in ("y", "yes", "n", "no"):
            return said[0] == "y"


def text_of(settings: Settings) -> str:
    """What read() reads."""
    text = ""
    for name, vehicle in settings.vehicles.items():
        lines = "\n       ".join(vehicle.line or [USUAL_LINE])
        system = f"system = {vehicle.system}\n" if vehicle.system else ""
        key_file = f"key-file = {vehicle.key_file}\n" if vehicle.key_file else ""
        text += f"[{f'vehicle {name}'.strip()}]\nline = {lines}\n{system}{key_file}\n"
    for name, gimbal in settings.gimbals.items():
        text += f"[{f'gimbal {name}'.strip()}]\nport = {gimbal.port}\n"
        text += f"vehicle = {gimbal.vehicle}\n" if gimbal.vehicle else ""
        for key in (
            "component",
            "speed",
            "rate",
            "rate_timeout",
            *(f"{axis}_sign" for axis in SEEN),
        ):
            text += f"{key.replace('_', '-')} = {getattr(gimbal, key)}\n"
        for key in ("manager", "arm"):
            text += f"{key} = yes\n" if getattr(gimbal, key) else ""
        text += "\n"
    return text
