"""Code to copy moves every axis slowly: in an angle mode, speed 0 means the parameters' speed."""

from __future__ import annotations

import re

from sbgcgen.oracle.example import example_of
from sbgcgen.model import Layout

from conftest import PROJECT

AXES = ("roll", "pitch", "yaw")
ANGLE_MODE = re.compile(r"ControlMode(Kind)?::\w*angle\w*")


def sources() -> dict[str, str]:
    """Returns the C++ of guides, README and examples by location."""
    found = {}
    for path in (PROJECT / "README.md", *sorted((PROJECT / "docs").glob("*.md"))):
        text = path.read_text(encoding="utf-8")
        for i, block in enumerate(
            re.findall(r"^```cpp\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
        ):
            found[f"{path.name}, block {i}"] = block
    for path in sorted((PROJECT / "examples").glob("*.cpp")):
        found[path.name] = path.read_text(encoding="utf-8")
    return found


def sets_speed_of(axis: str, code: str) -> bool:
    """Returns True if the code sets the speed of an axis by name, pointer loop or braces."""
    loops = re.findall(r"for \(auto\* (\w+) : \{([^}]*)\}\)\s*\{?\s*\1->speed = ", code)
    in_loop = any(f"axes.{axis}" in members for _, members in loops)
    by_name = rf"axes\.{axis}\.speed = |\.{axis} = \{{\.speed = "
    return in_loop or re.search(by_name, code) is not None


def test_code_with_an_angle_mode_sets_the_speed_of_every_axis() -> None:
    moving = {name: code for name, code in sources().items() if ANGLE_MODE.search(code)}
    assert len(moving) >= 3
    for name, code in moving.items():
        assert [a for a in AXES if not sets_speed_of(a, code)] == [], name


def test_examples_of_the_reference_set_the_speed_of_every_axis_that_moves(layout: Layout) -> None:
    angle_modes = {2, 5}
    moving = 0
    for name in ("Control", "ControlExt"):
        fields = example_of(next(m for m in layout.messages if m.name == name), layout).fields
        for axis in AXES:
            mode = fields["control_mode"]
            mode = mode[axis] if isinstance(mode, dict) else mode
            if mode & 0x0F in angle_modes:
                moving += 1
                assert fields["axes"][axis]["speed"] != 0, f"{name}: {axis}"
    assert moving == 4
