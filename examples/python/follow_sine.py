"""Makes the camera follow a sine in pitch, with 50 commands a second: python3 follow_sine.py /dev/ttyUSB0"""

import asyncio
import math
import sys

import sbgc
from sbgc import aio, msg


async def follow(place: str | sbgc.Board, seconds: float = 10.0) -> None:
    loop = asyncio.get_running_loop()
    async with aio.connect(place) as gimbal:
        await gimbal.call(msg.MotorsOn())
        async with gimbal.speed_control() as control:
            start = loop.time()
            for step in range(round(50 * seconds)):
                # The speed of 5 degrees * sin(2 t); the camera stops at the end of the block.
                control.set(pitch=10 * math.cos(2 * step / 50))
                await asyncio.sleep(start + (step + 1) / 50 - loop.time())


if __name__ == "__main__":
    asyncio.run(follow(sys.argv[1]))
