"""Connects to a gimbal, reads its angles and, if you agree, moves the camera.

    python3 move.py /dev/ttyUSB0

A real gimbal has motors that can injure people: see docs/2-safety.md.
"""

import sys

import sbgc
from sbgc import msg


def main(place: str | sbgc.Board) -> None:
    with sbgc.connect(place) as gimbal:
        print(f"board {gimbal.identity.board}, firmware {gimbal.identity.firmware}")
        angles = gimbal.call(msg.GetAnglesRequest())
        assert isinstance(angles, msg.GetAngles)
        pitch = angles.axes.pitch.imu_angle
        target = pitch + 10
        print(f"The camera turns to pitch {target:.1f} (now {pitch:.1f}: down by 10).")
        if input("Is it free to move? [y/N] ") != "y":
            return
        gimbal.call(msg.MotorsOn())
        moved = gimbal.move_to(pitch=target, speed=10)
        print(f"pitch: {moved.angles.pitch:.1f} degrees")


if __name__ == "__main__":
    main(*sys.argv[1:])
