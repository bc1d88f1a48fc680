"""A revision is read by its own generator, even if the spec language or model has changed since."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from edits import OLD
from sbgcgen.build import load_layout
from sbgcgen.cli import main
from sbgcgen.compat import reading
from sbgcgen.compat.severities import compare
from sbgcgen.compat.dump import dump
from sbgcgen.compat.reading import restore
from sbgcgen.model import AnswerCase
from support import GENERATOR, HERE, PROJECT, Capture, commit, git, start_repository, write_spec

EARLIER = HERE / "compat" / "earlier_model.json"


def test_a_model_comes_back_as_it_was() -> None:
    layout = load_layout(PROJECT / "spec")
    again = restore(json.loads(json.dumps(dump(layout))))
    assert again == layout
    assert compare(again, layout) == compare(layout, again) == []
    assert [m.at for m in again.messages] == [m.at for m in layout.messages]
    bodies = [[m.body for m in side.messages] for side in (layout, again)]
    shared = [len({id(body) for body in side}) for side in bodies]
    assert shared[0] == shared[1] < len(bodies[0]), "two messages may have one body"


def test_the_model_of_an_earlier_generator_is_understood(tmp_path: Path) -> None:
    """If this fails, a part of the model has got another name or shape: describe it in reading.py.

    The file is the output of dump.py for probe.yaml with the generator of an earlier revision; if
    probe.yaml changes, it has to be written again.
    """
    earlier = restore(json.loads(EARLIER.read_text(encoding="utf-8")))
    found = compare(earlier, load_layout(write_spec(tmp_path, OLD)))
    # At that time the spec specified neither the format of versions nor the main part of a packed
    # value, nor directions.
    assert {c.what for c in found} == {
        "packed FirmwareVersion",
        "packed BoardVersion",
        "packed Setup: main part",
        "direction of PITCH",
        "direction of YAW",
    }


# Another model


def objects_of(folder: Path) -> list[Any]:
    found: list[Any] = json.loads(json.dumps(dump(load_layout(write_spec(folder, OLD)))))
    return found


def test_former_names_are_known(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reading, "RENAMED", {"Telegram": "Message", "Telegram.gist": "summary"})
    objects = objects_of(tmp_path)
    for entry in objects:
        if entry[0] == "Message":
            entry[0] = "Telegram"
            entry[1]["gist"] = entry[1].pop("summary")
    assert compare(restore(objects), load_layout(tmp_path / "spec")) == []


def test_what_was_not_known_yet_is_as_if_nothing_were_said(tmp_path: Path) -> None:
    objects = objects_of(tmp_path)
    for name, facts in objects:
        if name == "Layout":
            del facts["line"], facts["revisions"]
        if name == "Message":
            del facts["effect"], facts["until"], facts["tail_capacity"]
    layout = restore(objects)
    assert layout.line.baud_rates == () and layout.revisions == ()
    assert all(m.effect is None and m.until is None for m in layout.messages)


def test_what_there_is_no_more_is_passed_over(tmp_path: Path) -> None:
    objects = objects_of(tmp_path)
    for entry in objects:
        if entry[0] == "Message":
            entry[1]["colour"] = "green"
        elif entry[0] == "Deprecation":
            entry[0] = "Obituary"
    assert compare(restore(objects), load_layout(tmp_path / "spec")) == []


def test_an_answer_that_was_the_same_in_all_cases() -> None:
    facts: dict[str, Any] = {"confirm": "never", "timeout_ms": 500, "retry_safe": True}
    facts["messages"] = {"tuple": ["State"]}
    families = {"families": {"tuple": [{"object": 0}]}}
    answer: Any = restore([["Answer", facts], ["Layout", families]]).families[0]
    assert answer.messages == ("State",) and answer.timeout_ms == 500 and answer.retry_safe
    assert isinstance(answer.cases[0], AnswerCase) and answer.cases[0].when is None


# Another language


@pytest.fixture(name="project")
def of_another_language(tmp_path: Path) -> Path:
    """A repository whose revision v1 uses the key `gist` for the present `summary`."""
    root = start_repository(tmp_path / "project")
    spec = write_spec(root, OLD)
    for path in spec.glob("*.yaml"):
        text = path.read_text(encoding="utf-8")
        path.write_text(text.replace("summary:", "gist:"), encoding="utf-8")
    ignored = shutil.ignore_patterns("__pycache__")
    shutil.copytree(GENERATOR, root / "generator", ignore=ignored)
    reader = root / "generator" / "sbgcgen" / "spec" / "load.py"
    text = reader.read_text(encoding="utf-8")
    key = "key = str(key_node.value)"
    assert key in text
    reader.write_text(text.replace(key, f'{key}.replace("gist", "summary")'), encoding="utf-8")
    commit(root, "v1")
    write_spec(root, OLD)
    shutil.rmtree(root / "generator")
    return root


def test_a_revision_in_another_language(project: Path, capsys: Capture) -> None:
    assert main(["compat", "--root", str(project), "v1"]) == 0
    write_spec(project, OLD.replace("id: 11", "id: 21"))
    assert main(["compat", "--root", str(project), "v1"]) == 1
    assert "wire-breaking: command CMD_MOVE: id: 11 → 21" in capsys.readouterr().out


def test_a_revision_that_its_own_generator_refuses(project: Path, capsys: Capture) -> None:
    git(project, "checkout", "--quiet", "v1", "--", "generator")
    spec = project / "spec" / "probe.yaml"
    spec.write_text(OLD.replace("type: AxisState", "type: AxisStat"), encoding="utf-8")
    commit(project, "v2")
    write_spec(project, OLD)
    assert main(["compat", "--root", str(project), "v2"]) == 1
    error = capsys.readouterr().err
    assert error.startswith("v2:spec/: its own generator cannot read it: SpecError: ")
    assert "SBGC010 unknown type 'AxisStat'" in error and "Traceback" not in error
