"""The camera stays safe when a component dies, lies or is lost: mostly, it does nothing."""

from __future__ import annotations

import random
import time
from math import inf, nan
from pathlib import Path
from typing import Any

import pytest
from drone import LOCK, NO_Q, STATUS, Aim, Gimbal, Rig, Station, aircraft, started

KEY = bytes(range(32))
DOWN = aircraft(pitch=-30)


def test_nothing_moves_while_the_motors_are_off() -> None:
    with started(motors=False) as rig:
        rig.autopilot.fly(1, rig.autopilot.aim(DOWN))
        before = rig.gimbal.up
        assert rig.autopilot.last("HEARTBEAT").system_status == 3
        assert rig.autopilot.last(STATUS).failure_flags == 32
        rig.gimbal.host.motors_on()
        rig.autopilot.fly(0.5)
        assert (
            max(-20, before - 5) < rig.gimbal.up < before + 5
        ), "what was wanted before is forgotten"


def test_arm_permits_a_setpoint_to_turn_the_motors_on() -> None:
    with started("--arm", motors=False) as rig:
        rig.autopilot.fly(0.5)
        assert not rig.gimbal.data().other_flags, "nobody wants anything"
        aim = rig.autopilot.aim(DOWN)
        rig.autopilot.until(lambda: rig.gimbal.up == pytest.approx(-30, abs=1), aim)
        rig.gimbal.host.motors_off()
        rig.autopilot.fly(1, aim)
        assert not rig.gimbal.data().other_flags, "who turns them off wants them off"


@pytest.mark.parametrize("end, most", [("kill", 16), ("terminate", 4), ("poll", 16)])
def test_what_ends_a_rate(end: str, most: float, rig: Rig) -> None:
    """The program is killed, or asked to end; or (poll) the autopilot or ground station is silent."""
    gimbal = rig.gimbal
    rig.autopilot.fly(0.7, rig.autopilot.aim(rates=(nan, -0.3, 0.3), flags=LOCK))
    getattr(rig.process, end)()
    if end == "terminate":  # what nobody stops goes on for half a second, 8 degrees
        assert rig.process.wait(10) == 0
    up, right = gimbal.up, gimbal.right
    time.sleep(1)
    assert gimbal.is_still()
    assert abs(gimbal.up - up) < most and abs(gimbal.right - right) < most
    assert gimbal.is_still(1.5)


def test_a_killed_program_lets_a_move_go_on_to_its_angle(rig: Rig) -> None:
    rig.autopilot.fly(0.2, rig.autopilot.aim(DOWN))
    rig.process.kill()
    time.sleep(2)
    assert rig.gimbal.up == pytest.approx(-30, abs=1)


def test_who_may_not_steer_moves_nothing(autopilot: Station, gimbal: Gimbal) -> None:
    others = [Station(255, 190), Station(2, 1), Station(1, 191), Station(1, 154)]
    aims = [other.attitude(DOWN, to=(1, 154)) for other in others]
    aims += [autopilot.attitude(DOWN, to=to) for to in ((2, 154), (1, 171))]
    for data in (*aims, Station(2, 1).state(90)):
        autopilot.put(data)
        autopilot.fly(0.3)
    assert gimbal.up == pytest.approx(0, abs=0.5) and autopilot.last(STATUS).delta_yaw == 0
    assert {one.sender for one in autopilot.all(STATUS)} == {(1, 154)}


@pytest.mark.parametrize(
    "wrong",
    [
        [(q, (), 0) for q in ([2.0, 0, 0, 0], [0.0] * 4, [1, nan, 0, 0], [inf, 0, 0, 0])],
        [(NO_Q, (nan, rate, nan), flags) for rate in (inf, -inf, 1e30, nan) for flags in (0, 28)],
        [(DOWN, (), 32 | 64), (DOWN, (0, inf, 0), 0), (DOWN, (), 1)],
    ],
)
def test_nonsense_moves_nothing(wrong: list[Any], autopilot: Station, gimbal: Gimbal) -> None:
    for q, rates, flags in wrong:
        autopilot.fly(0.4, autopilot.aim(q, rates, flags))
        assert gimbal.up == pytest.approx(0, abs=0.5), (q, rates, flags)


def test_damaged_and_lost_bytes_end_nothing(autopilot: Station, gimbal: Gimbal) -> None:
    dice = random.Random(1)

    def harm() -> None:
        for kind in [0, 1, 2, 3] * 3:
            data = bytearray(autopilot.attitude(DOWN))
            if kind == 0:
                data[dice.randrange(1, len(data))] ^= 1 << dice.randrange(8)
            elif kind == 1:
                del data[dice.randrange(1, len(data)) :]
            elif kind == 2:
                data = bytearray(dice.randbytes(dice.randrange(300)))
            else:
                data[1] = (data[1] + dice.randrange(1, 256)) % 256
            autopilot.put(bytes(data))

    # A flipped bit of the sequence or of the sender does not pass the checksum either.
    autopilot.fly(4, harm)
    assert gimbal.up == pytest.approx(0, abs=0.5)
    aim: Aim = lambda: dice.random() < 0.7 or autopilot.put(b"\xfd\xfe" + autopilot.attitude(DOWN))
    autopilot.until(lambda: gimbal.up < -18, aim)


def test_duplicates_and_what_was_overtaken_move_nothing(autopilot: Station, gimbal: Gimbal) -> None:
    old = [autopilot.attitude(DOWN) for _ in range(3)]
    level = autopilot.aim(aircraft())
    autopilot.fly(0.3, level)
    for data in old * 3:
        autopilot.put(data)
        autopilot.fly(0.04, level)
    assert gimbal.up == pytest.approx(0, abs=1)
    last = autopilot.put(autopilot.attitude(rates=(nan, -0.5, nan)))
    for _ in range(30):
        autopilot.put(last)
        autopilot.listen(0.02)
    autopilot.fly(1)
    assert gimbal.is_still() and gimbal.up > -30, "one message is one message"


def test_with_a_key_only_signed_messages_count(tmp_path: Path) -> None:
    path = tmp_path / "key"
    path.write_text(KEY.hex())
    with started(f"--key-file={path}", key=KEY) as rig:
        autopilot, gimbal = rig.autopilot, rig.gimbal
        recorded = autopilot.put(autopilot.attitude(aircraft(pitch=-10)))
        autopilot.until(lambda: gimbal.up == pytest.approx(-10, abs=1))
        other = Station(key=KEY[::-1])
        other.codec.signing.timestamp += 10**9  # a forged time must not lock the autopilot out
        for forger in (Station(), other):
            autopilot.put(forger.attitude(DOWN))
            autopilot.fly(0.5)
        autopilot.until(lambda: abs(gimbal.up) < 1, autopilot.aim(aircraft()))
        autopilot.fly(1.2)
        autopilot.put(recorded)
        autopilot.fly(0.5)
        assert abs(gimbal.up) < 1, "a replay is older than what has come since"


def test_a_lost_gimbal_is_told_and_found_again_and_keeps_no_setpoint(rig: Rig) -> None:
    autopilot = rig.autopilot
    autopilot.fly(0.3, autopilot.aim(rates=(nan, -0.3, nan)))
    rig.gimbal.close()
    autopilot.fly(1)
    count = len(autopilot.all(STATUS))
    autopilot.until(lambda: autopilot.last("HEARTBEAT").system_status == 5)
    assert len(autopilot.all(STATUS)) == count, "ArduPilot notices this"
    rig.gimbal.open()
    autopilot.until(lambda: len(autopilot.all(STATUS)) > count)
    autopilot.fly(0.5)
    assert rig.gimbal.up == pytest.approx(0, abs=0.5)
    autopilot.until(lambda: rig.gimbal.up < -18, autopilot.aim(DOWN))
