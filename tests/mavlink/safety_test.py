"""What the camera does when something dies, lies or is lost: mostly nothing."""

from __future__ import annotations

import random
import signal
import time
from math import inf, nan

import pytest
from drone import LOCK, NO_Q, STATUS, Gimbal, Rig, Station, aircraft, started

KEY = bytes(range(32))


def test_nothing_moves_while_the_motors_are_off() -> None:
    with started(motors=False) as rig:
        rig.autopilot.fly(1, rig.autopilot.aim(aircraft(pitch=-40)))
        before = rig.gimbal.up
        assert rig.autopilot.last("HEARTBEAT").system_status == 3
        assert rig.autopilot.last(STATUS).failure_flags == 32
        rig.gimbal.host.motors_on()
        rig.autopilot.fly(0.5)
        assert rig.gimbal.up == pytest.approx(before, abs=5), "what was wanted before is forgotten"
        assert rig.gimbal.up > -20


def test_arm_permits_a_setpoint_to_turn_the_motors_on() -> None:
    with started("--arm", motors=False) as rig:
        rig.autopilot.fly(0.5)
        assert not rig.gimbal.data().other_flags, "nobody wants anything"
        aim = rig.autopilot.aim(aircraft(pitch=-20))
        rig.autopilot.until(lambda: rig.gimbal.up == pytest.approx(-20, abs=1), aim)
        rig.gimbal.host.motors_off()
        rig.autopilot.fly(1, aim)
        assert not rig.gimbal.data().other_flags, "who turns them off wants them off"


def test_a_killed_program_ends_a_rate_and_leaves_an_angle(rig: Rig) -> None:
    autopilot, gimbal = rig.autopilot, rig.gimbal
    autopilot.fly(0.7, autopilot.aim(rates=(nan, -0.2, 0.3)))
    rig.process.kill()
    at = gimbal.up, gimbal.right
    time.sleep(1)
    assert gimbal.is_still()
    assert at[0] - 9 < gimbal.up < at[0] and at[1] < gimbal.right < at[1] + 13


def test_a_killed_program_lets_a_move_go_on_to_its_angle(rig: Rig) -> None:
    rig.autopilot.fly(0.2, rig.autopilot.aim(aircraft(pitch=-40)))
    rig.process.kill()
    time.sleep(2)
    assert rig.gimbal.up == pytest.approx(-40, abs=1)


def test_a_program_that_is_asked_to_end_stops_a_rate(rig: Rig) -> None:
    rig.autopilot.fly(0.7, rig.autopilot.aim(rates=(nan, -0.3, nan)))
    rig.process.send_signal(signal.SIGTERM)
    assert rig.process.wait(10) == 0
    at = rig.gimbal.up
    time.sleep(1)
    # It brakes; a rate that nobody stops goes on for half a second, 8 degrees.
    assert abs(rig.gimbal.up - at) < 4 and rig.gimbal.is_still()


def test_a_lost_autopilot_ends_a_rate_and_leaves_an_angle(rig: Rig) -> None:
    """Also a killed ground station: in both cases, nothing more comes."""
    autopilot, gimbal = rig.autopilot, rig.gimbal
    autopilot.fly(0.7, autopilot.aim(rates=(nan, -0.3, nan), flags=LOCK))
    time.sleep(1)
    assert gimbal.is_still()
    place = gimbal.up
    time.sleep(1.5)
    assert gimbal.up == pytest.approx(place, abs=0.5)


def test_who_may_not_steer_moves_nothing(rig: Rig) -> None:
    autopilot, gimbal = rig.autopilot, rig.gimbal
    aims = [
        Station(255, 190).attitude(aircraft(pitch=-30), to=(1, 154)),
        Station(2, 1).attitude(aircraft(pitch=-30), to=(1, 154)),
        Station(1, 191).attitude(aircraft(pitch=-30), to=(1, 154)),
        Station(1, 154).attitude(aircraft(pitch=-30), to=(1, 154)),
        autopilot.attitude(aircraft(pitch=-30), to=(2, 154)),
        autopilot.attitude(aircraft(pitch=-30), to=(1, 171)),
        Station(2, 1).state(90),
    ]
    for data in aims:
        autopilot.put(data)
        autopilot.fly(0.3)
    assert gimbal.up == pytest.approx(0, abs=0.5) and autopilot.last(STATUS).delta_yaw == 0
    assert {one.sender for one in autopilot.all(STATUS)} == {(1, 154)}


def test_what_makes_no_sense_moves_nothing(rig: Rig) -> None:
    no_rates, down = (nan, nan, nan), aircraft(pitch=-30)
    for q, rates, flags in (
        ([2.0, 0, 0, 0], no_rates, 0),
        ([0.0, 0, 0, 0], no_rates, 0),
        ([1.0, nan, 0, 0], no_rates, 0),
        ([inf, 0, 0, 0], no_rates, 0),
        (NO_Q, (nan, inf, nan), 0),
        (NO_Q, (nan, -inf, nan), 28),
        (NO_Q, (nan, 1e30, nan), 0),
        (NO_Q, no_rates, 0),
        (down, no_rates, 32 | 64),
        (down, (0, inf, 0), 0),
        (down, no_rates, 1),
    ):
        rig.autopilot.fly(0.5, rig.autopilot.aim(q, rates, flags))
        assert rig.gimbal.up == pytest.approx(0, abs=0.5), (q, rates, flags)


def test_damaged_bytes_move_nothing_and_end_nothing(rig: Rig) -> None:
    autopilot, dice = rig.autopilot, random.Random(1)

    def harm() -> None:
        for kind in [0, 1, 2, 3] * 3:
            data = bytearray(autopilot.attitude(aircraft(pitch=-40)))
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
    assert rig.gimbal.up == pytest.approx(0, abs=0.5)
    autopilot.until(lambda: rig.gimbal.up < -18, autopilot.aim(aircraft(pitch=-20)))


def test_duplicates_and_what_was_overtaken_move_nothing(rig: Rig) -> None:
    autopilot, gimbal = rig.autopilot, rig.gimbal
    old = [autopilot.attitude(aircraft(pitch=-40)) for _ in range(3)]
    level = autopilot.aim(aircraft())
    autopilot.fly(0.3, level)
    for _ in range(3):
        for data in old:
            autopilot.put(data)
        autopilot.fly(0.1, level)
    autopilot.until(
        lambda: gimbal.up == pytest.approx(-20, abs=1), autopilot.aim(aircraft(pitch=-20))
    )
    last = autopilot.put(autopilot.attitude(rates=(nan, -0.5, nan)))
    for _ in range(30):
        autopilot.put(last)
        autopilot.listen(0.02)
    autopilot.fly(1)
    assert gimbal.is_still() and gimbal.up > -50, "one message is one message"


def test_lost_messages_cost_nothing(rig: Rig) -> None:
    dice = random.Random(2)

    def some() -> None:
        data = rig.autopilot.attitude(aircraft(pitch=-20))
        if dice.random() < 0.3:
            rig.autopilot.put(data)

    rig.autopilot.until(lambda: rig.gimbal.up == pytest.approx(-20, abs=1), some)


def test_with_a_key_only_signed_messages_count(tmp_path: object) -> None:
    path = f"{tmp_path}/key"
    with open(path, "w", encoding="ascii") as file:
        file.write(KEY.hex())
    with started("--key-file", path, key=KEY) as rig:
        autopilot, gimbal = rig.autopilot, rig.gimbal
        recorded = autopilot.put(autopilot.attitude(aircraft(pitch=-10)))
        autopilot.until(lambda: gimbal.up == pytest.approx(-10, abs=1))
        other = Station(key=KEY[::-1])
        other.codec._mav.signing.timestamp += (
            10**9
        )  # a forged time must not lock the autopilot out
        for data in (Station().attitude(aircraft(pitch=-40)), other.attitude(aircraft(pitch=-40))):
            autopilot.put(data)
            autopilot.fly(0.5)
        autopilot.until(lambda: abs(gimbal.up) < 1, autopilot.aim(aircraft()))
        autopilot.fly(1.2)
        autopilot.put(recorded)
        autopilot.fly(0.5)
        assert abs(gimbal.up) < 1, "a replay is older than what has come since"


def test_a_lost_gimbal_is_told_and_found_again_and_keeps_no_setpoint(rig: Rig) -> None:
    autopilot = rig.autopilot
    autopilot.fly(0.3, autopilot.aim(rates=(nan, -0.3, nan)))
    port = rig.gimbal.address.rsplit(":", 1)[1]
    rig.gimbal.close()
    autopilot.fly(1)
    count = len(autopilot.all(STATUS))
    autopilot.until(lambda: autopilot.last("HEARTBEAT").system_status == 5)
    assert len(autopilot.all(STATUS)) == count, "ArduPilot notices this"
    rig.gimbal = again = Gimbal(port=port)
    try:
        autopilot.until(lambda: len(autopilot.all(STATUS)) > count)
        autopilot.fly(0.5)
        assert again.up == pytest.approx(0, abs=0.5)
        autopilot.until(lambda: again.up < -18, autopilot.aim(aircraft(pitch=-20)))
    finally:
        rig.process.terminate()
        rig.process.wait(10)
        again.close()
