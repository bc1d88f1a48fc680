"""The asynchronous client, with an emulated board."""

from __future__ import annotations

import asyncio
import gc
import inspect
import random
import time
from collections.abc import Awaitable, Callable
from contextlib import suppress
from typing import Any

import pytest

import sbgc
from conftest import is_still
from sbgc import Board, aio, msg


async def until_it_moves(board: Board) -> None:
    while board.angles.pitch < 3:
        await asyncio.sleep(0.01)


async def turned_loop(work: Awaitable[object]) -> int:
    """Returns how often the loop did something else while it waited."""
    ticks = 0

    async def tick() -> None:
        nonlocal ticks
        while True:
            await asyncio.sleep(0.01)
            ticks += 1

    ticking = asyncio.create_task(tick())
    await work
    ticking.cancel()
    return ticks


def with_gimbal(
    board: Board, use: Callable[[aio.Gimbal], Awaitable[None]], reconnect: bool = False
) -> None:
    async def main() -> None:
        async with aio.connect(board, reconnect=reconnect) as gimbal:
            await gimbal.call(msg.MotorsOn())
            await use(gimbal)

    asyncio.run(main())


def test_both_clients_have_the_same_calls() -> None:
    """One is made of the other, but not the base classes of both."""

    def calls(type_: type) -> dict[str, inspect.Signature]:
        public = inspect.getmembers(type_, inspect.isfunction)
        return {name: inspect.signature(f) for name, f in public if not name.startswith("_")}

    names = calls(sbgc.Gimbal)
    assert calls(aio.Gimbal).keys() == names.keys() and len(names) > 30
    for name in names.keys() - {"close", "edit_profile", "speed_control"}:  # their results differ
        assert calls(aio.Gimbal)[name] == names[name], name


def test_calls_run_concurrently_with_the_loop(board: Board) -> None:
    async def use(gimbal: aio.Gimbal) -> None:
        assert await turned_loop(gimbal.move_to(pitch=10, speed=30)) > 10
        assert board.angles.pitch == pytest.approx(10, abs=0.6)
        answers = await asyncio.gather(*(gimbal.call(msg.GetAnglesRequest()) for _ in range(20)))
        assert all(isinstance(answer, msg.GetAngles) for answer in answers)

    with_gimbal(board, use)


def test_waiting_again_after_a_timeout_leaves_the_loop_to_others(board: Board) -> None:
    async def use(gimbal: aio.Gimbal) -> None:
        async def wait() -> None:
            for _ in range(3):
                with suppress(sbgc.GimbalTimeout):
                    await anext(samples)

        async with await gimbal.stream(msg.RealtimeData4, 1.0, timeout=0.2) as samples:
            assert await turned_loop(wait()) > 20

    with_gimbal(board, use)


def test_a_cancelled_move_stops_the_camera_first(board: Board) -> None:
    async def use(gimbal: aio.Gimbal) -> None:
        move = asyncio.create_task(gimbal.move_to(pitch=80, speed=20))
        await until_it_moves(board)
        begin = time.monotonic()
        move.cancel()
        with pytest.raises(asyncio.CancelledError):
            await move
        assert time.monotonic() - begin < 3  # of 4 that it takes
        assert is_still(board)

    with_gimbal(board, use)


def test_a_cancelled_speed_stops_the_camera_first(board: Board) -> None:
    async def use(gimbal: aio.Gimbal) -> None:
        async def turn() -> None:
            async with gimbal.speed_control() as control:
                while True:
                    control.set(yaw=20)
                    await asyncio.sleep(0.05)

        turning = asyncio.create_task(turn())
        while abs(board.speeds.yaw) < 10:
            await asyncio.sleep(0.01)
        turning.cancel()
        with pytest.raises(asyncio.CancelledError):
            await turning
        assert is_still(board)

    with_gimbal(board, use)


def test_a_cancelled_calibration_ends_within_a_second(board: Board) -> None:
    async def use(gimbal: aio.Gimbal) -> None:
        calibrating = asyncio.create_task(gimbal.calibrate(msg.CalibPoles()))
        await asyncio.sleep(0.3)
        begin = time.monotonic()
        calibrating.cancel()
        with pytest.raises(asyncio.CancelledError):
            await calibrating
        assert time.monotonic() - begin < 5  # of 10 that it takes

    with_gimbal(board, use)


def test_a_stream_ends_with_its_line_and_says_that_nothing_comes(board: Board) -> None:
    async def use(gimbal: aio.Gimbal) -> None:
        async with await gimbal.stream(msg.RealtimeData4, 10, timeout=0.2) as samples:
            with pytest.raises(sbgc.GimbalTimeout, match="no sample for 0.2 seconds"):
                while True:
                    await anext(samples)
            gimbal.close()
            with pytest.raises(sbgc.GimbalDisconnected):
                await anext(samples)

    with_gimbal(board, use)


@pytest.mark.parametrize(
    "motion",
    [lambda it: it.move_to(pitch=80, speed=20), lambda it: it.turn(yaw=20, seconds=60)],
    ids=["move_to", "turn"],
)
def test_close_ends_all_tasks_and_does_not_block_the_loop(
    board: Board, motion: Callable[[aio.Gimbal], Any]
) -> None:
    async def main() -> None:
        gimbal = await aio.connect(board)
        await gimbal.call(msg.MotorsOn())
        samples = await gimbal.stream(msg.RealtimeData4, 30, timeout=60)
        uses = [
            motion(gimbal),
            gimbal.calibrate(msg.CalibPoles(), timeout=60),
            anext(samples),
        ]
        tasks = [asyncio.create_task(use) for use in uses]
        await asyncio.sleep(0.3)
        closing = gimbal.close()
        for end in await asyncio.wait_for(asyncio.gather(*tasks, return_exceptions=True), 10):
            assert type(end) is sbgc.GimbalDisconnected, end
        await closing
        assert is_still(board) and not gimbal.is_connected
        await gimbal.close()
        with pytest.raises(sbgc.GimbalDisconnected):
            await gimbal.wait_until_connected()

    asyncio.run(main())


def test_a_client_serves_only_its_own_loop(board: Board) -> None:
    gimbal = asyncio.run(aio.connect(board).__aenter__())
    uses: list[Callable[[], Any]] = [
        lambda: gimbal.call(msg.GetAnglesRequest()),
        gimbal.wait_until_connected,
        gimbal.speed_control().__aenter__,
    ]

    async def use() -> None:
        for one in uses:
            with pytest.raises(RuntimeError, match="belongs to another event loop"):
                await one()

    asyncio.run(use())
    gimbal.close()


def test_a_second_cancellation_waits_for_the_camera_too(board: Board) -> None:
    async def use(gimbal: aio.Gimbal) -> None:
        move = asyncio.create_task(gimbal.move_to(pitch=80, speed=20))
        await until_it_moves(board)
        move.cancel()
        await asyncio.sleep(0)
        move.cancel()
        with pytest.raises(asyncio.CancelledError):
            await move
        assert is_still(board)

    with_gimbal(board, use)


def test_what_is_abandoned_ends_with_a_warning(board: Board) -> None:
    async def main() -> None:
        gimbal: Any = await aio.connect(board)
        with pytest.warns(ResourceWarning, match="aio.client.Gimbal of memory link> was not"):
            del gimbal
            gc.collect()
        await asyncio.sleep(0)

    asyncio.run(main())


@pytest.mark.parametrize("reconnect, calls", [(False, 1000), (True, 200)])
def test_random_interleavings_neither_crash_nor_hang(
    board: Board, reconnect: bool, calls: int
) -> None:
    """Calls that are begun, awaited and cancelled at random times, also while the line is lost."""
    chance = random.Random(1)

    async def use(gimbal: aio.Gimbal) -> None:
        async def stream() -> None:
            async with await gimbal.stream(msg.RealtimeData4, 0.02) as samples:
                async for _ in samples:
                    break

        async def turn() -> None:
            async with gimbal.speed_control() as control:
                control.set(yaw=chance.uniform(-20, 20))
                await asyncio.sleep(chance.uniform(0, 0.01))

        kinds: list[Callable[[], Awaitable[object]]] = [
            lambda: gimbal.call(msg.GetAnglesRequest()),
            lambda: gimbal.begin_move(pitch=chance.uniform(-20, 20), speed=30),
            lambda: gimbal.get_variables("P_PITCH", "P_ROLL"),
            lambda: gimbal.calibrate(msg.CalibGyro(), timeout=0.01, progress=lambda _: None),
            lambda: gimbal.read_eeprom(chance.randrange(1000), 10),
            gimbal.profile_names,
            stream,
            turn,
        ]

        async def one() -> None:
            await chance.choice(kinds)()

        running: list[asyncio.Task[None]] = []
        for number in range(calls):
            if reconnect and number % 100 == 50:
                board.unplug()
                with suppress(sbgc.GimbalDisconnected):
                    await gimbal.call(msg.GetAnglesRequest())
            if reconnect and number % 100 == 60:
                await gimbal.wait_until_connected(timeout=20)
            running.append(asyncio.create_task(one()))
            if chance.random() < 0.5:
                chance.choice(running).cancel()
            if len(running) > 8:
                await asyncio.gather(running.pop(0), return_exceptions=True)
            if chance.random() < 0.1:
                await asyncio.sleep(chance.uniform(0, 0.01))
        for result in await asyncio.gather(*running, return_exceptions=True):
            assert result is None or isinstance(result, (asyncio.CancelledError, sbgc.GimbalError))

    with_gimbal(board, use, reconnect)
