"""Output is reproducible byte by byte, written only if it changes, and cleaned up."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest

from sbgcgen import blocking
from sbgcgen.record import inputs
from sbgcgen.output import Output
from sbgcgen.targets import outputs, targets
from support import BASE, GENERATOR, PROJECT, files_in, layout_of, project_layout, run_generator


def output(folder: Path, text: str = BASE) -> Output:
    return Output(folder / "out", outputs(layout_of(folder, text), folder))


def generate(root: Path, folder: Path, seed: str, zone: str) -> dict[str, bytes]:
    """Runs the generator as a separate program in another environment."""
    folder.mkdir(parents=True)
    at = ["--root", root, "--output", folder / "out"]
    done = run_generator("generate", *at, folder=folder, PYTHONHASHSEED=seed, TZ=zone, LC_ALL="C")
    done.check_returncode()
    return files_in(folder / "out")


def test_same_bytes_whatever_run_folder_hash_seed_zone_and_locale(tmp_path: Path) -> None:
    """Another run wrote generated/, and the next test makes it in this process, both where the project is."""
    moved = tmp_path / "a place with blanks"
    (moved / "spec").mkdir(parents=True)
    for path in (PROJECT / "spec").glob("*.yaml"):
        (moved / "spec" / path.name).write_bytes(path.read_bytes())
    (moved / blocking.SOURCE).parent.mkdir(parents=True)
    (moved / blocking.SOURCE).write_bytes((PROJECT / blocking.SOURCE).read_bytes())
    made = generate(moved, tmp_path / "out", "4711", "Pacific/Auckland")
    # Pins the meaning of all that the spec uses of its language.
    now = files_in(PROJECT / "generated")
    changed = [name for name in made.keys() | now.keys() if made.get(name) != now.get(name)]
    assert changed == [], "run ./dev generate, and look at the difference"


def test_output_holds_no_dates_no_paths_and_unix_lines(tmp_path: Path) -> None:
    year = re.compile(rb"20[2-9][0-9]-[0-9]{2}")
    outputs(layout_of(tmp_path, BASE), PROJECT)  # which leaves nothing behind for the next one
    for name, content in outputs(project_layout(), PROJECT).items():
        if name.startswith("fuzz/"):
            continue  # bytes, not text
        assert content == (PROJECT / "generated" / name).read_bytes(), name
        assert str(PROJECT).encode() not in content, name
        assert b"/usr/" not in content and b"/home/" not in content, name
        assert b"\r" not in content, name
        assert content.endswith(b"\n"), name
        assert not re.search(rb"[ \t]\n", content), f"{name} has blanks at the end of a line"
        assert not year.search(content), f"{name} has a date"
        content.decode("utf-8")


def test_only_what_changes_is_written(tmp_path: Path) -> None:
    output(tmp_path / "a").write()
    folder = tmp_path / "a" / "out"
    for name in files_in(folder):
        os.utime(folder / name, ns=(10**18, 10**18))
    changed = Output(folder, output(tmp_path / "b", BASE.replace("A number", "Its age")).files)
    written = changed.write()
    young = [name for name in changed.files if (folder / name).stat().st_mtime_ns != 10**18]
    assert 0 < len(young) == written < len(changed.files)
    assert files_in(folder) == changed.files


def test_stale_files_and_their_empty_folders_go(tmp_path: Path) -> None:
    made = output(tmp_path)
    made.write()
    stale = made.folder / "old" / "family" / "gone.hpp"
    stale.parent.mkdir(parents=True)
    stale.write_text("// from an earlier spec\n")
    assert made.write() == 1
    assert not (made.folder / "old").exists()
    assert set(files_in(made.folder)) == set(made.files)


def test_a_folder_with_other_files_is_not_cleaned(tmp_path: Path) -> None:
    """`--output .` in the wrong place must not delete other files."""
    precious = tmp_path / "out" / "thesis.txt"
    precious.parent.mkdir()
    precious.write_text("years of work")
    with pytest.raises(FileExistsError):
        output(tmp_path).write()
    assert files_in(tmp_path / "out").keys() == {"thesis.txt"}


def test_drift_names_what_differs_is_missing_or_stale(tmp_path: Path) -> None:
    made = output(tmp_path)
    assert made.drift() == [f"{name}: missing" for name in sorted(made.files)]
    made.write()
    assert made.drift() == []
    first, second = sorted(made.files)[:2]
    (made.folder / first).write_bytes(made.files[first] + b"\n")
    (made.folder / second).unlink()
    (made.folder / "stray.hpp").write_text("")
    assert made.drift() == [
        "stray.hpp: not generated from the spec",
        f"{first}: differs",
        f"{second}: missing",
    ]


def test_inputs_are_all_files_that_decide(tmp_path: Path) -> None:
    names = set(inputs(PROJECT))
    assert set((GENERATOR / "sbgcgen").rglob("*.py")) <= names
    templates = {path for target in targets() for path in target.templates.rglob("*")}
    assert {path for path in templates if path.is_file()} <= names
    assert set((GENERATOR / "schema").glob("*.json")) <= names
    assert PROJECT / blocking.SOURCE in names
    assert all(path.is_absolute() and path.is_file() for path in names)


def test_family_without_messages_gets_no_header(tmp_path: Path) -> None:
    files = output(tmp_path, "family: probe\nsummary: Only words.\n").files
    assert not any("probe" in name for name in files)


def test_a_text_with_marks_of_cpp_and_templates_is_only_text(tmp_path: Path) -> None:
    text = BASE.replace("A number.", "'A */ ?? /* {{ x }} {% y %} \\ \"quoted\" ° end\\'")
    files = output(tmp_path, text).files
    header = next(c.decode() for name, c in files.items() if name.endswith("messages/probe.hpp"))
    comments = [line for line in header.splitlines() if "{{ x }}" in line]
    assert comments and all(line.lstrip().startswith("//") for line in comments)
    assert not any(line.endswith("\\") for line in header.splitlines()), "it would join two lines"
