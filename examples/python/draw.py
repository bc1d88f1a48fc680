"""Records a minute of a gimbal, and draws how still the camera is while its frame moves.

    python3 draw.py /dev/ttyUSB0 minute.sbgc minute.png

With "" as the address, it records an emulated gimbal that is carried by hand. Needs numpy and matplotlib.
"""

import sys
from pathlib import Path

import sbgc
from sbgc import msg


def record(gimbal: sbgc.Gimbal, seconds: float) -> None:
    with gimbal.stream(msg.RealtimeData4, 0.02) as samples:
        for _ in range(round(seconds * 50)):
            next(samples)


def draw(capture: Path, picture: Path) -> None:
    from matplotlib.figure import Figure  # type: ignore[import]

    table = sbgc.read_capture(capture)[msg.RealtimeData4]
    time = table["time"] - table["time"][0]
    figure = Figure(figsize=(8, 5), layout="tight")
    frame, camera = figure.subplots(2, 1, sharex=True, sharey=True)
    for axis in ("roll", "pitch"):
        frame.plot(time, table[f"frame_imu_angle.{axis}"], label=axis, linewidth=0.8)
        camera.plot(time, table[f"angle.{axis}"], label=axis, linewidth=0.8)
    frame.set(title="The frame", ylabel="degrees")
    camera.set(title="The camera", ylabel="degrees", xlabel="seconds")
    frame.legend(loc="upper right")
    figure.savefig(picture)


def main(address: str, capture: str, picture: str, *, seconds: float = 60) -> None:
    if address:
        with sbgc.connect(address, capture=capture) as gimbal:
            record(gimbal, seconds)
    else:
        with sbgc.emulator(motion="handheld", virtual_time=True) as board:
            with sbgc.connect(board, capture=capture) as gimbal:
                gimbal.call(msg.MotorsOn())
                board.sleep(2)
                record(gimbal, seconds)
    draw(Path(capture), Path(picture))


if __name__ == "__main__":
    main(*sys.argv[1:4])
