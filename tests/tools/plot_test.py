"""Tests of sbgc plot."""

from __future__ import annotations

import math
import random
import re
import xml.etree.ElementTree as xml
from pathlib import Path

import pytest

from emulated_gimbal import emulated_gimbal
from sbgc_command import run


def table(
    values: list[float], rate: float = 250, late: float = 0, name: str = "gyro[deg/s]"
) -> str:
    """Samples at equal distances that arrive up to `late` seconds later."""
    chance = random.Random(1)
    rows = [f"time[s],{name}"]
    last = 0.0
    for number, value in enumerate(values):
        last = max(last, number / rate + chance.random() * late)
        rows.append(f"{last:.6f},{value:.6f}")
    return "\n".join(rows) + "\n"


def sine(hertz: float, amplitude: float, count: int = 1000, rate: float = 250) -> list[float]:
    return [amplitude * math.sin(math.tau * hertz * at / rate) for at in range(count)]


def one_line(text: str) -> str:
    return " ".join(text.split())


@pytest.mark.parametrize("rate", [98.1, 333.3, 62.5, 1000 / 7])
def test_any_rate_is_even(rate: float) -> None:
    result = run("plot", "-", "--spectrum", stdin=table(sine(12, 1, 1000, rate), rate))
    assert result.status == 0, result.error
    assert strongest(result.text)[0] == pytest.approx(12, abs=0.2)


def strongest(text: str) -> tuple[float, float]:
    found = re.search(r"strongest: ([\d.]+) Hz with ([\d.]+)", one_line(text))
    assert found, text
    return float(found[1]), float(found[2])


@pytest.mark.parametrize("late", [0, 0.02], ids=["in time", "late"])
def test_a_spectrum_names_the_frequency(late: float) -> None:
    result = run("plot", "-", "--spectrum", stdin=table(sine(37, 0.4), late=late))
    assert result.status == 0
    alias = r"3[67]\.\d Hz may be an alias of 21[23]\.\d or 28[67]\.\d Hz"
    assert re.search(alias, one_line(result.text))
    hertz, amplitude = strongest(result.text)
    assert hertz == pytest.approx(37, abs=0.5) and amplitude == pytest.approx(0.4, rel=0.1)
    assert re.search(r"0 Hz .* 112(\.\d)? Hz", result.text), "45 % of the rate"


def test_a_curve_in_the_terminal() -> None:
    result = run("plot", "-", "--height", "4", "--ascii", stdin=table([0, 1, 2, 3], rate=1))
    lines = result.text.splitlines()
    assert lines[0] == "gyro [deg/s]"
    assert [line.split("+")[0].strip() for line in (lines[1], lines[4])] == ["3", "0"]
    assert lines[1].endswith("*") and lines[4].split("+")[1].startswith("*")
    assert re.fullmatch(r" +\+ 0 s -+ 1\.5 s -+ 3 s", lines[5])
    assert any("\u2801" <= c <= "\u28ff" for c in run("plot", "-", stdin=table([0, 1])).text)


def test_a_picture(tmp_path: Path) -> None:
    file = tmp_path / "picture.svg"
    values = table([0, 5, 0], rate=1, name="a&<b")
    assert run("plot", "-", "--svg", str(file), stdin=values).status == 0
    picture = xml.parse(file).getroot()
    assert "a&<b" in {text.text for text in picture.iter("{http://www.w3.org/2000/svg}text")}
    (path,) = picture.iter("{http://www.w3.org/2000/svg}path")
    heights = [float(point.split()[1]) for point in re.split("[ML]", path.attrib["d"])[1:]]
    assert heights[0] == heights[2] == heights[1] + 200
    hovered = [title.text for title in picture.iter("{http://www.w3.org/2000/svg}title")]
    assert "1 s: 5" in hovered


def test_live() -> None:
    with emulated_gimbal("--fault", "resonance=37Hz:0.5:pitch") as gimbal:
        angles = run("plot", "live", "--for", "300ms", "-p", gimbal.address)
        shaking = run(
            *("plot", "live", "gyro_data.pitch", "--stream", "RealtimeDataCustom", "--spectrum"),
            *("--rate", "250", "--for", "1s", "-p", gimbal.address),
        )
    assert angles.status == 0
    assert re.findall(r"^angle\.(\w+) \[deg\]", angles.text, re.MULTILINE) == [
        "roll",
        "pitch",
        "yaw",
    ]
    assert shaking.status == 0, shaking.error
    assert strongest(shaking.text)[0] == pytest.approx(37, abs=1)


@pytest.mark.parametrize(
    "rows",
    [
        "0,1e308\n1,-1e308\n2,5",
        "0,inf\n1,1\n2,nan",
        "1700000000,1\n1700000000,2",
        "0,5\n1,5",
        "0,1\n1,2\n1e19,3",
    ],
)
def test_odd_numbers(rows: str, tmp_path: Path) -> None:
    file = tmp_path / "picture.svg"
    for options in ((), ("--ascii",), ("--svg", str(file))):
        assert run("plot", "-", *options, stdin=f"time[s],a\n{rows}\n").status == 0
    assert "nan" not in file.read_text("utf-8")


@pytest.mark.parametrize("place", [999, 1000, 1001])
def test_a_single_spike_is_drawn(place: int) -> None:
    values = [0.0] * 2000
    values[place] = 1
    top = run("plot", "-", "--ascii", stdin=table(values)).text.splitlines()[1]
    assert top.replace("+", " ").split() == ["1", "*"]


def columns_of(text: str) -> set[int]:
    """The columns of the chart that have a star."""
    return {x - 11 for line in text.splitlines() for x, one in enumerate(line) if one == "*"}


def test_a_curve_is_drawn_over_time() -> None:
    # Five of six samples are in the first tenth of the time.
    rows = "time[s],a\n" + "".join(
        f"{t},{v}\n" for t, v in [(0, 0), (1, 5), (2, 0), (3, 5), (4, 0), (40, 9)]
    )
    text = run("plot", "-", "--ascii", stdin=rows).text
    highest = text.splitlines()[1]
    assert (
        highest.replace("+", " ").split() == ["9", "*"] and len(highest) == 79
    ), "at the right end"
    between = columns_of("\n".join(text.splitlines()[1:-1]))
    assert max(x for x in between if x < 66) < 10, "nothing is known between 4 s and 40 s"


def test_a_picture_is_drawn_over_time(tmp_path: Path) -> None:
    file = tmp_path / "picture.svg"
    rows = "time[s],a\n0,0\n1,1\n2,0\n8,1\n"
    assert run("plot", "-", "--svg", str(file), stdin=rows).status == 0
    (path,) = xml.parse(file).getroot().iter("{http://www.w3.org/2000/svg}path")
    places = [float(point.split()[0]) for point in re.split("[ML]", path.attrib["d"])[1:]]
    width = places[-1] - places[0]
    assert [(x - places[0]) / width for x in places] == pytest.approx(
        [0, 1 / 8, 1 / 4, 1], abs=1e-3
    )


def test_columns_of_other_messages_do_not_interrupt_a_curve() -> None:
    rows = "time[s],a,b\n" + "".join(
        f"{t},{t if t % 2 else ''},{'' if t % 2 else -t}\n" for t in range(100)
    )
    text = run("plot", "-", "a", "--ascii", stdin=rows).text
    assert len(columns_of("\n".join(text.splitlines()[1:-1]))) > 60


def test_numbers_near_the_largest(tmp_path: Path) -> None:
    for least, most in (("0", "1.79e308"), ("-1.79e308", "1.79e308"), ("1e300", "-1e300")):
        for options in (("--svg", str(tmp_path / "a.svg")), ()):
            result = run("plot", "-", *options, stdin=f"t,a,b\n0,{least},0\n1,{most},1\n")
            assert result.status == 0 and len(result.out) < 10_000
        assert (tmp_path / "a.svg").stat().st_size < 20_000


def test_no_more_curves_than_can_be_seen() -> None:
    names = [f"c{i}" for i in range(100_000)]
    rows = "\n".join(
        [",".join(["t", *names]), *(",".join(100_001 * [str(i)]) for i in range(3)), ""]
    )
    many = run("plot", "-", stdin=rows)
    assert many.status == 2 and "has 100000 curves, more than 500" in many.error
    assert "c0, c1, c2, ..." in many.error
    assert run("plot", "-", "c7,c99999", stdin=rows).status == 0
    first_line_alone = run("plot", "-", stdin=rows[: rows.index("\n") + 1] + "1,2\n")
    assert "more than 500" in first_line_alone.error, "before any value is read"
