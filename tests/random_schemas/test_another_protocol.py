"""A protocol of another vendor: the folder, the commands and the program of docs/16-another-protocol.md."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
from pathlib import Path

import pytest

from random_schemas import ROOT, WARNINGS, Trial, options_of
from sbgcgen.build import load_protocol
from sbgcgen.cli import main
from sbgcgen.oracle.example import example_of
from sbgcgen.output import Output
from sbgcgen.targets import outputs, target

COMPILER = os.environ.get("CXX", "g++")
LAUNCHER = os.environ.get("SBGC_LAUNCHER", "")


def blocks(language: str) -> list[str]:
    """Returns the fenced blocks of the guide in this language."""
    text = (ROOT / "docs/16-another-protocol.md").read_text(encoding="utf-8")
    return re.findall(rf"^```{re.escape(language)}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


def write_spec(folder: Path, size: int = 60, more: str = "") -> Path:
    """Writes the spec of the guide, with another largest body, or with more in its family."""
    main_file, lights = blocks("yaml")
    spec = folder / "spec"
    spec.mkdir()
    main_file = main_file.replace("max_body: 60", f"max_body: {size}")
    for name, text in (("lamp", main_file), ("lights", lights + more)):
        (spec / f"{name}.yaml").write_text(text, encoding="utf-8")
    return spec


@pytest.fixture(scope="module", name="lamp")
def made_by_the_guide(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of the guide, after its commands."""
    folder = tmp_path_factory.mktemp("lamp")
    write_spec(folder)
    (commands,) = blocks("sh")
    for command in commands.splitlines():
        words = shlex.split(command.replace("~/lamp", str(folder)))
        assert main(words[words.index("sbgcgen") + 1 :]) == 0
    return folder


def compile_(folder: Path, *arguments: str, includes: list[Path]) -> None:
    """Runs the compiler in a folder, with the headers of the library."""
    command = [*shlex.split(LAUNCHER), COMPILER, "-std=c++20", *WARNINGS]
    command += [f"-I{path}" for path in (*includes, *ROOT.glob("runtime/*/include"))]
    subprocess.run([*command, *arguments], cwd=folder, check=True)


def run(source: str, folder: Path) -> str:
    """Compiles a program that includes the single header; returns what it prints."""
    (folder / "program.cpp").write_text(source, encoding="utf-8")
    compile_(folder, "program.cpp", "-o", "program", includes=[folder, ROOT / "generated/include"])
    done = subprocess.run([folder / "program"], capture_output=True, text=True, check=True)
    return done.stdout


def test_the_program_of_the_guide(lamp: Path) -> None:
    (program,) = blocks("c++")
    assert run(program, lamp) == "-30.00 deg\n"
    assert not re.search(r"\bsbgc::|namespace sbgc", (lamp / "lamp.hpp").read_text("utf-8"))


def test_frames_are_as_described_and_both_protocols_fit_into_a_program(lamp: Path) -> None:
    """The expected bytes are made by hand: start, size, id, their sum, -3000, CRC-8/DVB-S2."""
    covered = bytes.fromhex("020204" + "48f4")
    crc = 0
    for byte in covered:
        crc ^= byte
        for _ in range(8):
            crc = (crc << 1 ^ (0xD5 if crc & 0x80 else 0)) & 0xFF
    program = """#include <lamp.hpp>
#include <sbgc/message.hpp>
#include <sbgc/messages.hpp>
#include <cstdio>
template <class Result>
void print(const std::uint8_t* bytes, Result result) {
  for (std::size_t i = 0; i < result.size; ++i) std::printf("%02x", bytes[i]);
  std::printf("\\n");
}
int main() {
  std::uint8_t bytes[300];
  lamp::msg::Turn turn;
  turn.tilt = lamp::msg::Tilt(-3000);
  print(bytes, lamp::encode_frame(turn, bytes));
  print(bytes, sbgc::encode_frame(sbgc::msg::GetAnglesRequest{}, bytes));
}
"""
    assert run(program, lamp).splitlines() == [f"a5{covered.hex()}{crc:02x}", "3e49004900"]


@pytest.mark.long
def test_cpp_and_reference_codec_agree(lamp: Path) -> None:
    """All vectors, frames, and random messages in both directions."""
    trial = Trial(1, lamp, options_of(["--compiler", COMPILER, "--launcher", LAUNCHER]))
    messages, lines = trial.generate()
    assert messages == 3 and lines > 100
    trial.compile(COMPILER)
    trial.compare()


@pytest.mark.parametrize("size", [4, 6, 11])
def test_bodies_may_be_short(tmp_path: Path, size: int) -> None:
    """No frame fits into such a body; there are vectors for all else."""
    found = outputs(load_protocol(write_spec(tmp_path, size)).layout, tmp_path)
    frames = found["frames.jsonl"].decode()
    assert f"a body of {size} bytes" in frames and f"a body of {size + 1} bytes" not in frames


def test_examples_with_a_part_that_has_a_unit_compile(tmp_path: Path) -> None:
    """The examples are those that the pages of the site show."""
    fields = "[{name: HEAD, type: Head, typical: 300, summary: The head.}]"
    more = f"""
  LAMP_POSE:
    id: 9
    summary: The head.
    from_board: {{source: Section 4, fields: {fields}}}
  LAMP_SET_POSE:
    id: 10
    summary: Set the head.
    to_board: {{source: Section 4, effect: turns, answer: none, fields: {fields}}}
packed:
  Head:
    type: u16
    summary: The head.
    source: Section 4
    parts:
      - {{name: tilt, bits: 0..8, type: Tilt, summary: Its angle.}}
      - {{name: turns, bits: 9..15, summary: Number of turns.}}
"""
    layout = load_protocol(write_spec(tmp_path, more=more)).layout
    Output(tmp_path / "generated", outputs(layout, tmp_path)).write()
    includes = [tmp_path / "generated/include"]
    for message in (m for m in layout.messages if m.name in ("Pose", "SetPose")):
        code = target("cpp").examples(example_of(message, layout))[-1]
        assert "tilt" in code.text
        heads = [line for line in code.text.splitlines() if line.startswith("#include")]
        steps = [line for line in code.text.splitlines() if line not in heads]
        program = "\n".join((*heads, "int main() {", *steps, "}\n"))
        (tmp_path / "example.cpp").write_text(program, encoding="utf-8")
        compile_(tmp_path, "-Wno-unused", "-fsyntax-only", "example.cpp", includes=includes)


def test_names_are_those_of_the_protocol(lamp: Path) -> None:
    model = json.loads((lamp / "generated/lamp.json").read_text(encoding="utf-8"))
    assert [command["name"] for command in model["commands"]] == ["LAMP_STATE", "LAMP_TURN"]
    assert [m["name"] for m in model["messages"]] == ["State", "StateRequest", "Turn"]
    assert [e["name"] for e in model["effects"]] == ["reads", "dims", "turns", "unknown"]
    assert [m["effect"] and m["effect"]["does"] for m in model["messages"]] == [
        None,
        ["reads"],
        ["turns"],
    ]
    policies = (lamp / "generated/include/sbgc/responses/lights.hpp").read_text(encoding="utf-8")
    assert policies.count(".moves = true") == 1


def test_the_site_is_about_the_protocol(lamp: Path) -> None:
    pages = {p.relative_to(lamp / "site").as_posix(): p for p in (lamp / "site").rglob("*.html")}
    assert {"messages/turn.html", "messages/state.html", "framing.html"} <= set(pages)
    assert (lamp / "site/lamp.json").is_file()
    text = {name: page.read_text(encoding="utf-8") for name, page in pages.items()}
    assert "The head of the lamp can move" in text["messages/turn.html"].replace(
        "the head", "The head"
    )
    assert "CRC-8 with the polynomial 0xD5" in text["framing.html"]
    for name, page in text.items():
        assert (
            ">Lamp Link, unofficial<" in page and "SimpleBGC" not in page and "CMD_" not in page
        ), name
        for link in re.findall(r'href="([^"#:]+)', page):
            assert (pages[name].parent / link).exists(), f"{name}: {link}"
