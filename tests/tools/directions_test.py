"""Every named motion turns the camera where it says: by its optical axis, computed from the angles of the
motors, and by the direction of gravity in its accelerometer.
"""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from math import cos, radians, sin
from pathlib import Path

import pytest
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from gimbal_observer import Observer, observer_of
from optical_axis import Vector, degrees_down, degrees_right, in_frame, optical_axis
from sbgc_command import run


@pytest.fixture(name="gimbal")
def one_gimbal() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal() as gimbal:
        yield gimbal


@pytest.fixture(name="observer")
def one_observer(gimbal: EmulatedGimbal) -> Iterator[Observer]:
    with observer_of(gimbal) as observer:
        yield observer


def test_the_geometry_of_these_tests() -> None:
    assert optical_axis((0, 0, 0)) == (0, 1, 0)
    assert optical_axis((0, 90, 0)) == pytest.approx((0, 0, -1), abs=1e-9), "down"
    assert optical_axis((0, 0, 90)) == pytest.approx((1, 0, 0), abs=1e-9), "right"
    assert optical_axis((40, 0, 0)) == (0, 1, 0)
    assert in_frame(Vector(1, 0, 0), (90, 0, 0)) == pytest.approx((0, 0, -1), abs=1e-9)


@pytest.mark.parametrize(
    "arguments, down, right",
    [
        (("--pitch", "20"), 20, 0),
        (("--pitch", "-20"), -20, 0),
        (("--yaw", "20"), 0, 20),
        (("--yaw", "-20"), 0, -20),
        (("--pitch", "20", "--yaw", "-10"), 20, -10),
    ],
)
def test_moves(
    arguments: tuple[str, ...],
    down: float,
    right: float,
    gimbal: EmulatedGimbal,
    observer: Observer,
) -> None:
    options = ("--wait", "--speed", "40", "--yes", "-p", gimbal.address)
    assert run("move", *arguments, *options).status == 0
    motors = observer.motors()
    assert degrees_down(motors) == pytest.approx(down, abs=4)
    assert degrees_right(motors) == pytest.approx(right, abs=4)


def test_speeds(gimbal: EmulatedGimbal, observer: Observer) -> None:
    def turn(*speed: str) -> tuple[float, float]:
        options = ("--for", "1s", "--yes", "-p", gimbal.address)
        assert run("speed", *speed, *options).status == 0
        motors = observer.motors()
        return degrees_down(motors), degrees_right(motors)

    # On a busy machine, a second may be longer.
    down, right = turn("--pitch", "20")
    assert down > 15 and right == pytest.approx(0, abs=4)
    still_down, right = turn("--yaw", "-20")
    assert still_down == pytest.approx(down, abs=4) and right < -15


def test_look_down(gimbal: EmulatedGimbal, observer: Observer) -> None:
    assert run("menu", "look_down", "--yes", "-p", gimbal.address).status == 0
    assert observer.stands_still_within(30)
    assert degrees_down(observer.motors()) == pytest.approx(90, abs=2)
    assert observer.acceleration() == pytest.approx((0, -1, 0), abs=0.05)


@pytest.mark.skipif("SBGC_EXAMPLES" not in os.environ, reason="the examples are not built")
@pytest.mark.parametrize("example", ["quickstart", "tilt", "tour"])
def test_an_example_tilts_down(
    example: str, gimbal: EmulatedGimbal, observer: Observer, tmp_path: Path
) -> None:
    """Also that of README, which is tilt, and the demo, which runs the tour."""
    files = [tmp_path / "capture", tmp_path / "backup"] if example == "tour" else []
    program = Path(os.environ["SBGC_EXAMPLES"]) / f"example_{example}"
    with subprocess.Popen(
        [program, gimbal.address, *files], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL
    ) as process:
        assert process.stdin is not None
        process.stdin.write(b"yes\n")
        process.stdin.close()
        seen = []
        while process.poll() is None:
            seen.append(degrees_down(observer.motors()))
        assert process.returncode == 0
    assert min(seen) == pytest.approx(0, abs=2), "level"
    assert max(seen) == pytest.approx(30, abs=2), "down"


@pytest.mark.parametrize("down", [-40, 40])
def test_gravity_tells_whether_the_camera_looks_up_or_down(
    down: float, gimbal: EmulatedGimbal, observer: Observer
) -> None:
    arguments = ("move", "--pitch", str(down), "--speed", "60", "--wait", "--yes")
    assert run(*arguments, "-p", gimbal.address).status == 0
    up = (0, -sin(radians(down)), cos(radians(down)))
    assert observer.acceleration() == pytest.approx(up, abs=0.05)


@pytest.mark.parametrize("roll", [-30, 30])
def test_gravity_tells_which_side_is_low(
    roll: float, gimbal: EmulatedGimbal, observer: Observer
) -> None:
    """Assumption of the emulator: positive roll lowers the right side."""
    arguments = ("move", "--roll", str(roll), "--speed", "60", "--wait", "--yes")
    assert run(*arguments, "-p", gimbal.address).status == 0
    up = (-sin(radians(roll)), 0, cos(radians(roll)))
    assert observer.acceleration() == pytest.approx(up, abs=0.05)
