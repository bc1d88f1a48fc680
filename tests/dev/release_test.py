"""Tests of ./dev release with a copy of the project, in which nothing is compiled."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path
from zipfile import ZipFile

import pytest

ROOT = Path(__file__).resolve().parents[2]
HEADER = Path("runtime/core/include/sbgc/version.hpp")
CATEGORIES = {"Added", "Changed", "Deprecated", "Removed", "Fixed", "Security"}
# Instead of ./dev, which compiles for minutes.
DEV = """\
#!/bin/sh
set -eu
case $1 in
  package) echo package >"$2/sbgc_1_amd64.deb" ;;
  docs) mkdir -p build/site/assets && echo page | tee build/site/index.html >build/site/assets/x ;;
esac
"""


def git(project: Path, *arguments: str) -> None:
    user = ["-c", "user.name=Test", "-c", "user.email=test@example.org"]
    fixed = {"GIT_CONFIG_GLOBAL": os.devnull, "GIT_COMMITTER_DATE": "2026-01-02T03:04:05Z"}
    environment = {**os.environ, **fixed, "GIT_AUTHOR_DATE": "2026-01-02T03:04:05Z"}
    command = ["git", *user, "-C", str(project), *arguments]
    subprocess.run(command, check=True, capture_output=True, env=environment)


@pytest.fixture(name="project")
def copy_of_the_project(tmp_path: Path) -> Path:
    return copy(tmp_path / "project")


def copy(project: Path) -> Path:
    """Copies the project, with the model and a description of its version, and commits it."""
    ignored = shutil.ignore_patterns("build", ".git", "node_modules", "__pycache__", ".*_cache")
    shutil.copytree(ROOT, project, ignore=ignored, symlinks=True)
    (project / "dev").write_text(DEV, encoding="utf-8")
    (project / "spec/released.json.xz").unlink()
    generator = ["generator/python", "-m", "sbgcgen", "record", "--root", "."]
    subprocess.run(generator, cwd=project, check=True, capture_output=True)
    changes = project / "CHANGELOG.md"
    text = changes.read_text(encoding="utf-8")
    changes.write_text(f"{text}\n## [{version()}] - 2026-01-02\n", encoding="utf-8")
    git(project, "init", "--quiet")
    git(project, "add", ".")
    git(project, "commit", "--quiet", "--message", "All")
    return project


def version() -> str:
    text = (ROOT / HEADER).read_text(encoding="utf-8")
    return ".".join(re.findall(r"^#define SBGC_VERSION_[A-Z]+ (\d+)$", text, re.MULTILINE))


def release(project: Path, *options: str, **settings: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [project / ".ci/release", *options],
        env={**os.environ, **settings},
        capture_output=True,
        text=True,
        check=False,
    )


def test_the_files_of_a_commit_are_the_same_everywhere(tmp_path: Path) -> None:
    found = []
    for place, settings in (("one", {"TZ": "UTC"}), ("an/other", {"TZ": "Asia/Tokyo"})):
        project = copy(tmp_path / place)
        done = release(project, **settings)
        assert done.returncode == 0, done.stderr
        folder = project / "build" / f"release-{version()}"
        subprocess.run(["sha256sum", "--check", "--quiet", "SHA256SUMS"], cwd=folder, check=True)
        found.append({path.name: path.read_bytes() for path in folder.iterdir()})
    assert sorted(found[0]) == [
        "SHA256SUMS",
        f"sbgc-{version()}.tar.gz",
        f"sbgc-arduino-{version()}.zip",
        f"sbgc-site-{version()}.zip",
        "sbgc.hpp",
        "sbgc_1_amd64.deb",
    ]
    assert found[0] == found[1]
    sums = found[0]["SHA256SUMS"].decode().splitlines()
    assert [line.split()[1] for line in sums] == sorted(found[0].keys() - {"SHA256SUMS"})


def test_archives_contain_one_folder(project: Path) -> None:
    assert release(project).returncode == 0
    folder = project / "build" / f"release-{version()}"
    for kind, file in (("arduino", "library.properties"), ("site", "index.html")):
        name = f"sbgc-{kind}-{version()}"
        names = ZipFile(folder / f"{name}.zip").namelist()
        assert {entry.partition("/")[0] for entry in names} == {name}
        assert f"{name}/{file}" in names


def test_a_commit_that_is_not_ready(project: Path) -> None:
    def refusal() -> str:
        done = release(project)
        assert done.returncode == 1 and done.stdout.count("\n") <= 3
        return done.stderr

    (project / "NEWS").write_text("soon")
    assert "commit these changes first:\n?? NEWS" in refusal()
    (project / "NEWS").unlink()

    header = (project / HEADER).read_text(encoding="utf-8")
    (project / HEADER).write_text(re.sub(r"(_PATCH) \d+", r"\1 99", header), encoding="utf-8")
    next_version = re.sub(r"\d+$", "99", version())
    assert f"CHANGELOG.md has no section '## [{next_version}] - DATE'" in refusal()
    with (project / "CHANGELOG.md").open("a", encoding="utf-8") as changes:
        changes.write(f"\n## [{next_version}] - 2026-01-03\n")
    assert "M spec/released.json.xz" in refusal(), "the model of the version has been recorded"

    git(project, "checkout", "--quiet", ".")
    spec = project / "spec/peripherals.yaml"
    text = spec.read_text(encoding="utf-8")
    assert text.count("\n    id: 89\n") == 1
    spec.write_text(text.replace("\n    id: 89\n", "\n    id: 253\n"), encoding="utf-8")
    assert "the version is too low" in refusal()
    assert release(project, "--try").returncode == 0


def test_wrong_usage(project: Path) -> None:
    done = release(project, "--now")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "dev: release: invalid arguments: '--now'\n"


def test_the_changes_of_the_version_are_described() -> None:
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    sections = re.findall(r"^## (.+)$", text, re.MULTILINE)
    if sections[0] == "Unreleased":
        del sections[0]
    dated = [re.fullmatch(r"\[(\d+)\.(\d+)\.(\d+)\] - \d{4}-\d\d-\d\d", name) for name in sections]
    assert dated and all(dated)
    released = [tuple(map(int, match.groups())) for match in dated if match]
    assert released == sorted(set(released), reverse=True)
    assert set(re.findall(r"^### (.+)$", text, re.MULTILINE)) <= CATEGORIES
    assert released[0] == tuple(map(int, version().split("."))) or "## Unreleased" in text
