"""The workflows of the code host are thin, have few rights, and name only existing files."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
WORKFLOWS = sorted((ROOT / ".github/workflows").glob("*.yml"))
# Setup that a container needs before the project's own commands can run.
SET_UP = (
    "apt-get update",
    "apt-get install -y --no-install-recommends ca-certificates git",
    'git config --global --add safe.directory "$GITHUB_WORKSPACE"',
)
MAY_WRITE = {"deploy": {"pages": "write", "id-token": "write"}}


def name_of(path: Path) -> str:
    """Returns the id of a workflow in pytest."""
    return path.stem


def load(path: Path) -> dict[str, Any]:
    """Loads a workflow."""
    loaded: dict[str, Any] = yaml.load(path.read_text(encoding="utf-8"), yaml.BaseLoader)
    return loaded


def steps(workflow: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Yields the steps of all jobs."""
    for job in workflow["jobs"].values():
        yield from job["steps"]


def commands(workflow: dict[str, Any]) -> Iterator[str]:
    """Yields the lines that the steps run, with each value of a job's matrix."""
    for job in workflow["jobs"].values():
        lines = [line for step in job["steps"] for line in step.get("run", "").splitlines()]
        for key, values in job.get("strategy", {}).get("matrix", {}).items():
            place = "${{ matrix.%s }}" % key
            lines = [line.replace(place, value) for line in lines for value in values]
        yield from lines


def test_there_are_workflows() -> None:
    assert [path.stem for path in WORKFLOWS] == ["ci", "docs", "nightly", "release"]


@pytest.mark.parametrize("path", WORKFLOWS, ids=name_of)
def test_it_has_the_shape_of_a_workflow(path: Path) -> None:
    workflow = load(path)
    assert set(workflow) == {"name", "on", "permissions", "concurrency", "jobs"}
    assert workflow["permissions"] == {"contents": "read"}
    for name, job in workflow["jobs"].items():
        assert job.get("permissions") == MAY_WRITE.get(name), name
        assert job["runs-on"] == "ubuntu-latest"
        assert int(job["timeout-minutes"]) <= 150
        for step in job["steps"]:
            assert ("run" in step) != ("uses" in step), step


@pytest.mark.parametrize("path", WORKFLOWS, ids=name_of)
def test_it_runs_nothing_but_the_commands_of_the_project(path: Path) -> None:
    known = subprocess.run([ROOT / "dev"], capture_output=True, text=True, check=True).stdout
    for line in commands(load(path)):
        if line in SET_UP:
            continue
        match = re.fullmatch(r"(\.ci/run)|\./dev ([a-z]+)(?: [-+a-z0-9_ ]+)?", line)
        assert match, line
        if match[1]:
            assert (ROOT / match[1]).is_file()
        else:
            assert re.search(rf"^  {match[2]}\b", known, re.MULTILINE), line


@pytest.mark.parametrize("path", WORKFLOWS, ids=name_of)
def test_it_uses_only_actions_of_the_code_host(path: Path) -> None:
    used = re.findall(r"^ +(?:- )?uses: (.+)$", path.read_text(encoding="utf-8"), re.MULTILINE)
    assert len(used) == sum("uses" in step for step in steps(load(path)))
    for action in used:  # a tag could be moved to other code
        assert re.fullmatch(r"actions/[a-z/-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+", action), action


def test_an_action_has_one_version() -> None:
    text = "".join(path.read_text(encoding="utf-8") for path in WORKFLOWS)
    found = set(re.findall(r"uses: (actions/[a-z-]+)[a-z/]*@(.+)$", text, re.MULTILINE))
    assert len(found) == len({name for name, _ in found})


def test_a_tag_makes_a_release_and_its_site() -> None:
    for name, command in (("release", "./dev release"), ("docs", "./dev docs --versions")):
        workflow = load(ROOT / f".github/workflows/{name}.yml")
        assert workflow["on"]["push"]["tags"] == ["v*"]
        assert command in commands(workflow)
        checkout = next(s for s in steps(workflow) if "checkout" in s.get("uses", ""))
        assert checkout["with"]["fetch-depth"] == "0", "without the tags, none is checked"


def test_crashes_and_corpus_are_where_the_fuzzers_leave_them() -> None:
    dev = (ROOT / "dev").read_text(encoding="utf-8")
    workflow = load(ROOT / ".github/workflows/nightly.yml")
    named = [step["with"]["path"] for step in steps(workflow) if "path" in step.get("with", {})]
    assert named
    for folder in named:
        assert folder in dev, folder


def test_every_night_all_presets_of_other_machines_and_compilers_run() -> None:
    presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))
    portable = [
        preset["name"]
        for preset in presets["configurePresets"]
        if preset.get("inherits") in ("machine", "compiler")
    ]
    lines = list(commands(load(ROOT / ".github/workflows/nightly.yml")))
    assert portable and [name for name in portable if f"./dev test {name}" not in lines] == []


def test_every_night_the_commands_of_readme_run_on_a_fresh_machine() -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    commands = re.findall(r"^(\./dev [a-z]+) +#", readme, re.MULTILINE)
    assert commands == ["./dev demo", "./dev test"]
    job = load(ROOT / ".github/workflows/nightly.yml")["jobs"]["readme"]
    assert job["container"] == "debian:12"
    assert [step["run"] for step in job["steps"] if "run" in step][1:] == commands
