"""A run with nothing to do is skipped; nothing else is."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import sbgcgen.record
from sbgcgen import build
from sbgcgen.cli import main
from support import GENERATOR, Capture, files_in, write_spec


@pytest.fixture
def root(tmp_path: Path, capsys: Capture) -> Path:
    """A project folder with the minimal spec, for which `generate` has run."""
    write_spec(tmp_path)
    assert main(["generate", "--root", str(tmp_path)]) == 0
    capsys.readouterr()
    return tmp_path


def generate(root: Path, *options: object) -> int:
    return main(["generate", "--root", str(root), *map(str, options)])


@pytest.fixture
def loads(monkeypatch: pytest.MonkeyPatch) -> list[Path]:
    """The spec folders that are loaded during the test."""
    seen: list[Path] = []
    real = build.load_protocol

    def load_protocol(spec_dir: Path) -> build.Protocol:
        seen.append(spec_dir)
        return real(spec_dir)

    monkeypatch.setattr(build, "load_protocol", load_protocol)
    return seen


def test_unchanged_run_loads_nothing_and_says_the_same(
    root: Path, loads: list[Path], capsys: Capture
) -> None:
    assert generate(root) == 0
    assert loads == []
    count = len(files_in(root / "generated"))
    assert capsys.readouterr().out == f"{count} files, 0 changed\n"


def test_unchanged_run_imports_no_slow_modules(root: Path) -> None:
    code = """if True:
        import sys
        from sbgcgen.cli import main
        assert main(sys.argv[1:]) == 0
        slow = {"jinja2", "yaml", "jsonschema", "sbgcgen.build", "sbgcgen.model"}
        sys.exit(sorted(slow & sys.modules.keys()) or 0)"""
    command = [sys.executable, "-c", code, "generate", "--root", str(root)]
    subprocess.run(command, check=True, env={**os.environ, "PYTHONPATH": str(GENERATOR)})


def edit(path: Path, same_time: bool = False) -> None:
    """Changes a character of a file, but not its size."""
    at = path.stat().st_mtime_ns
    path.write_bytes(path.read_bytes().replace(b"e", b"i", 1))
    if same_time:
        os.utime(path, ns=(at, at))


CHANGES: dict[str, tuple[Callable[[Path], object], str]] = {
    "a file is edited": (lambda out: edit(out / "simplebgc.json"), "1 changed"),
    "and has its old time": (lambda out: edit(out / "simplebgc.json", True), "1 changed"),
    "a file is deleted": (lambda out: (out / "simplebgc.json").unlink(), "1 changed"),
    "a file is renamed": (lambda out: (out / "simplebgc.json").rename(out / "f.json"), "2 changed"),
    "a file is added": (lambda out: (out / "stray.hpp").write_text(""), "1 changed"),
}


@pytest.mark.parametrize("name", CHANGES)
def test_changed_output_is_repaired(name: str, root: Path, capsys: Capture) -> None:
    output = root / "generated"
    before = files_in(output)
    change, expected = CHANGES[name]
    change(output)
    assert generate(root) == 0
    assert capsys.readouterr().out.endswith(f" files, {expected}\n")
    assert files_in(output) == before


def test_changed_spec_is_read(root: Path, loads: list[Path]) -> None:
    base = root / "spec" / "base.yaml"
    base.write_text(base.read_text().replace("How often", "How many times"))
    assert generate(root) == 0
    assert len(loads) == 1
    assert "How many times" in (root / "generated" / "simplebgc.json").read_text()


def test_unlisted_file_in_the_spec_is_found(root: Path, capsys: Capture) -> None:
    (root / "spec" / "new.yaml").write_text("family: new\nsummary: New.\n")
    assert generate(root) == 1
    assert "SBGC003" in capsys.readouterr().err


def test_changed_generator_runs_again(
    root: Path, loads: list[Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    file = root / "one.py"
    file.write_text("1")
    monkeypatch.setattr(sbgcgen.record, "inputs", lambda project: [file])
    for count in (1, 1):
        assert generate(root) == 0
        assert len(loads) == count
    file.write_text("2")
    assert generate(root) == 0
    assert len(loads) == 2


def test_another_output_folder_has_its_own_record_and_check_has_none(
    root: Path, loads: list[Path]
) -> None:
    assert generate(root, "--output", root / "other") == 0
    assert len(loads) == 1
    assert generate(root, "--output", root / "other") == 0
    assert generate(root) == 0
    assert len(loads) == 1
    assert main(["check", "--root", str(root)]) == 0
    assert len(loads) == 2


def test_unchanged_run_writes_the_same_depfile(root: Path, loads: list[Path]) -> None:
    stamp, depfile = root / "x.stamp", root / "x.d"
    (root / "generated" / "simplebgc.json").unlink()
    assert generate(root, "--stamp", stamp, "--depfile", depfile) == 0
    first = depfile.read_text()
    depfile.unlink()
    stamp.unlink()
    assert generate(root, "--stamp", stamp, "--depfile", depfile) == 0
    assert (depfile.read_text(), stamp.is_file(), len(loads)) == (first, True, 1)


@pytest.mark.parametrize("content", [b"", b"\xff\xfe", b"x\n", b"x\ny\nz\n"])
def test_damaged_record_is_ignored(content: bytes, root: Path, loads: list[Path]) -> None:
    (record,) = (root / "build" / "generator").iterdir()
    record.write_bytes(content)
    for _ in range(2):
        assert generate(root) == 0
        assert len(loads) == 1


def test_without_a_place_for_the_record(root: Path, loads: list[Path], capsys: Capture) -> None:
    """A file in the place of the folder; a read-only file system is no obstacle for root."""
    (record,) = (root / "build" / "generator").iterdir()
    record.unlink()
    record.parent.rmdir()
    record.parent.write_text("")
    for _ in range(2):
        assert generate(root) == 0
    assert len(loads) == 2
    assert capsys.readouterr().err == ""
