"""The Arduino library: its sketches compile, and run with an emulated gimbal; its metadata are valid."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest

from compilers import ARM, HERE, HOSTS, PREFIX, ROOT, WARNINGS, generate, machine, run

SKETCHES = ("Angles", "Tilt")
COMPILERS = [
    name for name in ("g++", ARM) if shutil.which(name)
]  # those of Arduino are of this kind
LEVEL = ("the camera looks 0 degrees down", "the camera looks -0 degrees down")
CORE = ["-std=gnu++20", "-fno-exceptions", "-fno-rtti", *WARNINGS]
CORE += [f"-I{HERE / 'arduino'}", "-include", "Arduino.h", "-x", "c++"]


@pytest.fixture(name="library", scope="module")
def arduino_library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return generate("arduino", tmp_path_factory.mktemp("arduino"))


def sketch(library: Path, name: str) -> Path:
    return library / "examples" / name / f"{name}.ino"


@pytest.mark.parametrize("name", SKETCHES)
@pytest.mark.parametrize("compiler", COMPILERS)
def test_sketch_compiles(compiler: str, name: str, library: Path, tmp_path: Path) -> None:
    options = [*machine(compiler), "-Os", f"-I{library / 'src'}", *CORE]
    run(compiler, *options, "-c", sketch(library, name), "-o", tmp_path / "sketch.o")


@pytest.fixture(name="programs", scope="module")
def programs_with_gimbal(library: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a program for each sketch: it runs the sketch with an emulated gimbal."""
    folder = tmp_path_factory.mktemp("sketches")
    compiler, runner = HOSTS[-1], folder / "runner.o"
    headers = [f"-I{HERE / 'arduino'}", f"-I{PREFIX / 'include'}"]
    run(compiler, "-std=c++20", *headers, "-c", HERE / "arduino/sketch_runner.cpp", "-o", runner)
    (emulator,) = PREFIX.rglob("libsbgc_emulator.a")
    for name in SKETCHES:
        code = folder / f"{name}.o"
        run(compiler, f"-I{library / 'src'}", *CORE, "-c", sketch(library, name), "-o", code)
        run(compiler, runner, code, emulator, "-o", folder / name)
    return folder


def test_angles_are_printed_and_nothing_moves(programs: Path) -> None:
    *lines, looks = run(programs / "Angles", "3", "y").splitlines()
    assert looks in LEVEL
    assert len(lines) > 20
    angles = r"roll (-?\d+\.\d\d)  pitch (-?\d+\.\d\d)  yaw (-?\d+\.\d\d)"
    assert all(re.fullmatch(angles, line) for line in lines)


@pytest.mark.parametrize("typed", ["", "n"])
def test_the_camera_tilts_for_nothing_else(typed: str, programs: Path) -> None:
    question, looks = run(programs / "Tilt", "5", typed).splitlines()
    assert question.startswith("Type y ")
    assert looks in LEVEL


def test_the_camera_tilts_down_when_asked(programs: Path) -> None:
    lines = run(programs / "Tilt", "5", "y").splitlines()
    assert lines[1:] == ["The camera tilts.", "the camera looks 10 degrees down"]


def test_a_dead_line_is_reported(programs: Path) -> None:
    lines = run(programs / "Tilt", "5", "y", "silent").splitlines()
    assert lines[1] == "The board does not answer."
    assert lines[2] in LEVEL


def test_properties_have_the_fields_of_the_specification(library: Path) -> None:
    """The fields that the Arduino library specification requires, and what it says of their values."""
    lines = (library / "library.properties").read_text(encoding="utf-8").splitlines()
    properties = dict(line.split("=", 1) for line in lines)
    assert all(
        properties[name]
        for name in (
            "name",
            "author",
            "maintainer",
            "sentence",
            "paragraph",
            "url",
            "architectures",
        )
    )
    assert re.fullmatch(r"[A-Za-z0-9][\w .-]{0,62}", properties["name"])
    header = (library / "src/sbgc/version.hpp").read_text(encoding="utf-8")
    assert properties["version"].split(".") == re.findall(r"#define SBGC_VERSION_\w+ (\d+)", header)
    assert properties["category"] == "Device Control"  # one of the specification's
    assert (library / "src" / properties["includes"]).is_file()
    assert "C++20" in properties["paragraph"]


def test_manifest_has_the_fields_of_platformio(library: Path) -> None:
    manifest = json.loads((library / "library.json").read_text(encoding="utf-8"))
    properties = (library / "library.properties").read_text(encoding="utf-8")
    assert f"\nversion={manifest['version']}\n" in properties
    assert re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", manifest["name"])
    assert 0 < len(manifest["description"]) <= 255
    assert all(re.fullmatch(r"[a-z0-9-]+", word) for word in manifest["keywords"])
    assert (library / "src" / manifest["headers"]).is_file()
    for example in manifest["examples"]:
        assert all((library / example["base"] / file).is_file() for file in example["files"])
    assert [example["name"] for example in manifest["examples"]] == list(SKETCHES)


def test_old_compilers_are_told_why(library: Path, tmp_path: Path) -> None:
    old = tmp_path / "old.cpp"
    old.write_text("#include <sbgc.h>\n", encoding="utf-8")
    with pytest.raises(AssertionError, match="sbgc needs C\\+\\+20"):
        run(HOSTS[-1], "-std=gnu++17", f"-I{library / 'src'}", "-fsyntax-only", old)
