"""Whatever ends a motion, and whenever: the camera stands before the exception goes on."""

from __future__ import annotations

import asyncio
import dis
import os
import random
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any, Optional

import pytest

import sbgc
from conftest import is_still
from sbgc import Board, Gimbal, aio, msg
from sbgc.testing import emulator_options as emulator_options
from sbgc.testing import gimbal as gimbal
from sbgc.testing import gimbal_board as gimbal_board

RETURN_VALUE = dis.opmap["RETURN_VALUE"]
PACKAGE = str(Path(sbgc.__file__).parent)


class Interrupter:
    """Raises KeyboardInterrupt at a step of the bytecode of the package."""

    def __init__(self, step: int) -> None:
        self.left = step

    def trace(self, frame: FrameType, event: str, _: object) -> Optional[Callable[..., Any]]:
        if not frame.f_code.co_filename.startswith(PACKAGE):
            return None
        frame.f_trace_opcodes = True
        # The interpreter handles no signal between the last call of a function and its return.
        if event == "opcode" and frame.f_code.co_code[frame.f_lasti] != RETURN_VALUE:
            self.left -= 1
            if self.left == 0:
                sys.settrace(None)
                raise KeyboardInterrupt
        return self.trace

    def run(self, use: Callable[[], object]) -> bool:
        """Returns whether there was such a step."""
        sys.settrace(self.trace)
        try:
            use()
        except KeyboardInterrupt:
            return True
        finally:
            sys.settrace(None)
        return False


@pytest.mark.parametrize("kind", ["move_to", "begin_move", "turn", "speed_control"])
def test_ctrl_c_at_each_step_stops_the_camera(
    gimbal: Gimbal, gimbal_board: Board, kind: str
) -> None:
    sign = 1

    def control_speed() -> None:
        with gimbal.speed_control() as control:
            control.set(yaw=sign * 20)
            gimbal_board.sleep(0.1)

    uses: dict[str, Callable[[], object]] = {
        "move_to": lambda: gimbal.move_to(pitch=sign * 60, speed=30, timeout=3),
        "begin_move": lambda: gimbal.begin_move(pitch=sign * 60, speed=30),
        "turn": lambda: gimbal.turn(yaw=sign * 20, seconds=0.3),
        "speed_control": control_speed,
    }
    gimbal.call(msg.MotorsOn())
    step = 1
    while step < 200 and Interrupter(step).run(uses[kind]):
        sign = -sign
        step += 1
        gimbal_board.sleep(0.3)
        assert max(abs(speed) for speed in gimbal_board.speeds) < 0.5, step
    assert step > 30


@pytest.mark.filterwarnings("ignore:coroutine .* was never awaited")
@pytest.mark.parametrize("kind", ["move_to", "begin_move", "turn"])
def test_ctrl_c_in_a_task_stops_the_camera_first(board: Board, kind: str) -> None:
    """KeyboardInterrupt passes through the task; asyncio.run() cancels the task instead."""

    async def main(interrupter: Optional[Interrupter]) -> None:
        async with aio.connect(board) as gimbal:
            await gimbal.call(msg.MotorsOn())
            moves: dict[str, Callable[[], Any]] = {
                "move_to": lambda: gimbal.move_to(pitch=sign * 60, speed=30, timeout=3),
                "begin_move": lambda: gimbal.begin_move(pitch=sign * 60, speed=30),
                "turn": lambda: gimbal.turn(yaw=sign * 20, seconds=1),
            }
            sys.settrace(interrupter.trace if interrupter else None)
            try:
                await moves[kind]()
            except KeyboardInterrupt:
                sys.settrace(None)
                assert is_still(board), interrupter
                raise
            finally:
                sys.settrace(None)

    sign = 1
    for step in range(1, 140, 13):
        sign = -sign
        with pytest.raises(KeyboardInterrupt):
            asyncio.run(main(Interrupter(step)))


class Recorder:
    """The link of a client, and the calibrations that it has made."""

    def __init__(self, gimbal: Any) -> None:
        self.link, self.made = gimbal._link, list[Any]()
        gimbal._link = self

    def __getattr__(self, name: str) -> Any:
        return getattr(self.link, name)

    def calibrate(self, *arguments: Any) -> Any:
        self.made.append(self.link.calibrate(*arguments))
        return self.made[-1]


def test_ctrl_c_at_each_step_ends_a_calibration(gimbal: Gimbal, gimbal_board: Board) -> None:
    """The board goes on, because nothing stops it; the client waits for it no longer."""
    recorder = Recorder(gimbal)
    step = 1
    while step < 200 and Interrupter(step).run(lambda: gimbal.calibrate(msg.CalibGyro())):
        assert not any(operation.is_running() for operation in recorder.made), step
        step += 1
        gimbal_board.sleep(6)  # until the board can calibrate again
    assert step > 30


@pytest.mark.filterwarnings("ignore:coroutine .* was never awaited")
def test_ctrl_c_in_a_task_ends_a_calibration(board: Board) -> None:
    async def main(interrupter: Interrupter) -> None:
        async with aio.connect(board) as gimbal:
            recorder = Recorder(gimbal)
            sys.settrace(interrupter.trace)
            try:
                await gimbal.calibrate(msg.CalibGyro(), timeout=0.05)
            finally:
                sys.settrace(None)
                assert not any(operation.is_running() for operation in recorder.made), interrupter

    for step in range(1, 80, 3):
        with pytest.raises(KeyboardInterrupt):
            asyncio.run(main(Interrupter(step)))


KINDS = ["move_to", "begin_move", "turn", "hold"]
ENDS = (sbgc.GimbalSuperseded, sbgc.GimbalInterrupted)


def test_a_stop_ends_every_earlier_motion_of_all_threads(board: Board, gimbal: Gimbal) -> None:
    chance = random.Random(1)
    outcomes: list[object] = []

    def hold(speed: float) -> None:
        with gimbal.speed_control() as control:
            while True:
                control.set(yaw=speed)
                time.sleep(0.02)

    def run(kind: str, size: float) -> None:
        uses: dict[str, Callable[[], object]] = {
            "move_to": lambda: gimbal.move_to(pitch=size, speed=20),
            "begin_move": lambda: gimbal.begin_move(pitch=size, speed=20),
            "turn": lambda: gimbal.turn(yaw=size, seconds=20),
            "hold": lambda: hold(size),
        }
        try:
            uses[kind]()
        except BaseException as error:
            outcomes.append(error)

    for _ in range(8):
        drawn = [(chance.choice(KINDS), chance.choice([-1, 1]) * 40) for _ in range(3)]
        threads = [threading.Thread(target=run, args=one) for one in drawn]
        for thread in threads:
            thread.start()
            time.sleep(chance.uniform(0, 0.1))
        time.sleep(0.05)
        gimbal.stop()
        assert is_still(board)
        for thread in threads:
            thread.join(2)
            if thread.is_alive():  # on a busy machine, it has begun after the stop
                gimbal.stop()
                thread.join(20)
            assert not thread.is_alive(), drawn
        assert is_still(board)
    assert outcomes and all(isinstance(one, ENDS) for one in outcomes), outcomes


def test_a_stop_ends_every_earlier_motion_of_all_tasks(board: Board) -> None:
    chance = random.Random(2)

    async def main() -> None:
        async with aio.connect(board) as gimbal:
            await gimbal.call(msg.MotorsOn())

            async def hold(speed: float) -> None:
                async with gimbal.speed_control() as control:
                    while True:
                        control.set(yaw=speed)
                        await asyncio.sleep(0.02)

            uses: dict[str, Callable[[float], Any]] = {
                "move_to": lambda size: gimbal.move_to(pitch=size, speed=20),
                "begin_move": lambda size: gimbal.begin_move(pitch=size, speed=20),
                "turn": lambda size: gimbal.turn(yaw=size, seconds=20),
                "hold": hold,
            }
            for _ in range(8):
                tasks = []
                for _ in range(3):
                    size = chance.choice([-1, 1]) * 40
                    tasks.append(asyncio.create_task(uses[chance.choice(KINDS)](size)))
                    await asyncio.sleep(chance.uniform(0, 0.1))
                await asyncio.sleep(0.05)
                await gimbal.stop()
                assert is_still(board)
                ends = await asyncio.wait_for(asyncio.gather(*tasks, return_exceptions=True), 2)
                assert all(isinstance(one, (*ENDS, sbgc.Move)) for one in ends), ends
                assert is_still(board)

    asyncio.run(main())
