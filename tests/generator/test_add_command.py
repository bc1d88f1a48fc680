"""Adding a command takes only YAML: docs/10-new-commands.md, step by step."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from sbgcgen.build import load_protocol
from sbgcgen.cli import main
from sbgcgen.model import Quantity, Struct

ROOT = Path(__file__).resolve().parents[2]

COMPARING = (
    "generator/model generator/oracle generator/spec/test_documents.py",
    "docs/test_field_tables.py emulator/device/families_test.py",
)

PROGRAM = """
#include <sbgc/availability.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/lights.hpp>
#include <sbgc/validate.hpp>
#include <sbgc/visit.hpp>

#include <cstdio>

int main() {
%s
  static_assert(sbgc::msg::SetLights::max_size == 5);
  static_assert(!sbgc::is_supported<sbgc::msg::SetLights>(sbgc::Availability{2730, 30}));
  static_assert(sbgc::is_supported<sbgc::msg::SetLights>(sbgc::Availability{2740, 30}));
  if (!sbgc::is_valid(lights)) return 1;
  std::uint8_t frame[sbgc::max_frame_size];
  const sbgc::WriteResult written = sbgc::encode_frame(lights, frame);
  for (std::size_t i = 0; i < written.size; ++i) std::printf("%%02x", frame[i]);
  bool same = false;
  const auto check = [&](const auto& message) {
    if constexpr (requires { message.period; }) same = message == lights;
  };
  const sbgc::Status status =
      sbgc::visit(199, std::span(frame + 4, written.size - 5), sbgc::Direction::to_board, check);
  lights.period = sbgc::msg::Milliseconds(10);
  return status && same && !sbgc::is_valid(lights) ? 0 : 2;
}
"""


def guide_blocks(language: str) -> list[str]:
    """Returns the fenced blocks of the guide in this language."""
    text = (ROOT / "docs/10-new-commands.md").read_text(encoding="utf-8")
    return re.findall(rf"^ *```{re.escape(language)}\n(.*?)^ *```", text, re.MULTILINE | re.DOTALL)


def add_family(spec: Path, name: str, text: str) -> None:
    """Writes a family, and adds it to the list at the end of the main file."""
    if (spec / f"{name}.yaml").is_file():  # someone does what the guide says
        return
    (spec / f"{name}.yaml").write_text(text, encoding="utf-8")
    with (spec / "simplebgc.yaml").open("a", encoding="utf-8") as main_file:
        main_file.write(f"  - {name}\n")


def test_the_steps_of_the_guide(tmp_path: Path) -> None:
    spec = tmp_path / "spec"
    shutil.copytree(ROOT / "spec", spec)
    add_family(spec, "lights", guide_blocks("yaml")[0])
    assert main(["generate", "--root", str(tmp_path)]) == 0

    compiler = os.environ.get("CXX") or shutil.which("g++") or shutil.which("clang++")
    if compiler is None:
        pytest.fail("a C++ compiler is needed")
    source = tmp_path / "lights.cpp"
    source.write_text(PROGRAM % guide_blocks("c++")[0], encoding="utf-8")
    program = tmp_path / "lights"
    includes = [f"-I{ROOT / 'runtime/core/include'}", f"-I{tmp_path / 'generated/include'}"]
    subprocess.run(
        [compiler, "-std=c++20", "-Wall", "-Wextra", "-Werror", *includes, source, "-o", program],
        check=True,
    )
    result = subprocess.run([program], capture_output=True, text=True, check=False)
    assert result.returncode == 0
    # Start, id 199, 5 bytes, their sum; roll, pitch, yaw = blink | 31 << 2, 500 ms; the sum.
    assert result.stdout == "3ec705cc" + "00007e" + "f401" + "73"
    assert (tmp_path / "generated/vectors/lights.jsonl").is_file()


@pytest.mark.long
def test_no_test_refuses_the_command_of_the_guide(tmp_path: Path) -> None:
    """Runs the tests that compare what is generated with other sources, in a copy of the project."""
    unwanted = shutil.ignore_patterns("__pycache__", "node_modules")
    for name in ("docs", "emulator", "examples", "generator", "spec", "tests", "runtime/core"):
        shutil.copytree(ROOT / name, tmp_path / name, ignore=unwanted)
    add_family(tmp_path / "spec", "lights", guide_blocks("yaml")[0])
    assert main(["generate", "--root", str(tmp_path)]) == 0
    for files in COMPARING:
        command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *files.split()]
        done = subprocess.run(
            [*command, "-k", "not is_noticed"],
            cwd=tmp_path / "tests",
            env={**os.environ, "PYTHONPATH": str(tmp_path / "generator")},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stdout


# The ids of commands that the spec does not have.
_FREE_IDS = range(200, 250)
_COMMAND = """commands:
  CMD_EXAMPLE_{id}:
    id: {id}
    summary: An example.
    from_board:
      source: Release notes of firmware 2.74
"""


def example_family(block: str, number: int) -> str:
    """Returns a family with a block of the guide: the body of a message, or types and their uses."""
    head = f"family: example_{number}\nsummary: An example of the guide.\n"
    command = _COMMAND.format(id=_FREE_IDS[number])
    if re.match(r"(enums|flags|packed):\n", block):
        names = re.findall(r"^  (\w+):$", block, re.MULTILINE)
        uses = [
            f"        - {{name: USE_{i}, type: {name}, summary: Its use.}}\n"
            for i, name in enumerate(names)
        ]
        return head + block + command + "      fields:\n" + "".join(uses)
    return head + command + "".join(f"      {line}\n" for line in block.splitlines())


def test_every_example_of_the_guide_is_valid_and_has_an_effect(tmp_path: Path) -> None:
    spec = tmp_path / "spec"
    shutil.copytree(ROOT / "spec", spec)
    first, *blocks = guide_blocks("yaml")
    add_family(spec, "lights", first)
    assert len(blocks) >= 11
    for number, block in enumerate(blocks):
        add_family(spec, f"example_{number}", example_family(block, number))
    layout = load_protocol(spec).layout
    made = [m for m in layout.messages if m.family.startswith("example_")]
    made.sort(key=lambda message: message.id)
    assert len(made) == len(blocks)
    fields = {f"{m.id - _FREE_IDS[0]}.{f.name}": f for m in made for f in m.fields}
    assert fields["0.delay"].appended and made[0].lengths[-1][1] == made[0].max_size
    assert made[1].was_reserved(fields["1.level"])
    assert fields["3.speed"].when and fields["3.data"].when
    assert made[4].unconfirmed and fields["4.temperature"].unconfirmed
    assert fields["5.version"].constant and fields["5.light"].default == 1
    assert [rule.text("") for rule in made[6].body.rules] == ["min_level <= max_level"]
    assert [alias.name for alias in fields["7.brightness"].aliases] == ["level"]
    directions = [field.direction("PITCH") for field in made[9].fields]
    assert [d and d.positive for d in directions] == ["down", "down", None, None]
    assert fields["9.encoder"].directions == () and fields["9.width"].directions is None
    assert fields["10.lamps"].counting == "bytes"
    words = [field.when.words for field in made[14].fields if field.when]
    assert words[0] == "mode.mode is MODE_ANGLE and delay is at least 1"
    assert words[1] == "mode.flags has CONTROL_FLAG_HIGH_RES_SPEED"
    asked = {leaf.path: leaf.when.words for leaf in made[15].leaves if leaf.when}
    assert asked["axes.yaw.level"] == "data_set has YAW_SPEED"
    (later,) = fields["16.fade"].later
    assert isinstance(later.type, Quantity) and later.since.firmware_text == "2.74"
    assert float(later.type.real(70)) == pytest.approx(5 * 52 ** (70 / 255) - 5)
    assert fields["17.motor"].needs == "EXT_MOTORS" and layout.feature_mask("EXT_MOTORS") == 1 << 34
    assert fields["18.password"].secret and fields["18.password"].fits_rest
    lamp = fields["19.lamps"].type
    assert isinstance(lamp, Struct) and lamp.element_sizes == (1, 3)
    used = {leaf.path: leaf.used_when.words for leaf in made[20].leaves if leaf.used_when}
    assert used["period.yaw"] == "light is LIGHT_BLINK and lamps has YAW"
    enums = {e.name: e for e in layout.enums}
    assert enums["LampOptions"].values[1].since.firmware_text == "2.74"
    assert enums["LampEffect"].values[0].former
    (packed,) = [p for p in layout.packed if p.name == "LampState"]
    assert packed.parts[0].limits == (-2048, 2047)
    assert packed.parts[1].limits == (-32767, 32767) and packed.parts[1].quantity
