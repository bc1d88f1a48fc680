"""Tests of ./dev release and of the versions of the site with a part of the project, in which nothing is compiled."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
from io import BytesIO
from pathlib import Path
from zipfile import ZipFile

import pytest

ROOT = Path(__file__).resolve().parents[2]
HEADER = Path("runtime/core/include/sbgc/version.hpp")
# The parts of a release, except those that DEV stands for.
PARTS = (
    *(
        ".ci/release",
        ".ci/sbom.py",
        ".ci/versions",
        "LICENSE",
        "README.md",
        "pyproject.toml",
        "spec",
        "generator",
        "generated/include",
    ),
    *("python/build_backend.py", "runtime", "web/package.json"),
)
CATEGORIES = {"Added", "Changed", "Deprecated", "Removed", "Fixed", "Security"}
# Instead of ./dev, which compiles for minutes.
DEV = """\
#!/bin/sh
set -eu
case $1 in
  package) echo package >"$2/sbgc_1_amd64.deb" ;;
  wheel) echo wheel >"$2/sbgc-1.whl" ;;
  npm) mkdir -p "$2" && echo npm >"$2/sbgc-1.tgz" ;;
  docs)
    cd "$(dirname "$0")" # of the worktree of a tag
    mkdir -p build/site/assets build/site/inner
    printf '<body data-root="">\n<p>%s</p>\n<footer>\n</footer>\n' "$(cat NEWS 2>/dev/null)" >build/site/index.html
    printf '<body data-root="../">\n<footer>\n</footer>\n' >build/site/inner/page.html
    echo page >build/site/assets/x
    ;;
esac
"""


def git(project: Path, *arguments: str) -> None:
    user = ["-c", "user.name=Test", "-c", "user.email=test@example.org"]
    fixed = {"GIT_CONFIG_GLOBAL": os.devnull, "GIT_COMMITTER_DATE": "2026-01-02T03:04:05Z"}
    environment = {**os.environ, **fixed, "GIT_AUTHOR_DATE": "2026-01-02T03:04:05Z"}
    command = ["git", *user, "-C", str(project), *arguments]
    subprocess.run(command, check=True, capture_output=True, env=environment)


@pytest.fixture(name="release", scope="module")
def committed_release(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A commit of the project that is ready: it has the model and a description of its version."""
    project = tmp_path_factory.mktemp("release") / "project"
    for name in PARTS:
        (project / name).parent.mkdir(parents=True, exist_ok=True)
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, project / name)
        else:
            shutil.copy(ROOT / name, project / name)
    dev = project / "dev"
    dev.write_text(DEV, encoding="utf-8")
    dev.chmod(0o755)
    (project / ".gitignore").write_text("/build/\n__pycache__/\n", encoding="utf-8")
    (project / "spec/released.json.xz").unlink()
    generator = ["generator/python", "-m", "sbgcgen", "record", "--root", "."]
    subprocess.run(generator, cwd=project, check=True, capture_output=True)
    changes = f"# Changes\n\n## [{version()}] - 2026-01-02\n"
    (project / "CHANGELOG.md").write_text(changes, encoding="utf-8")
    git(project, "init", "--quiet")
    git(project, "add", ".")
    git(project, "commit", "--quiet", "--message", "All")
    return project


@pytest.fixture(name="project")
def clone_of_the_release(release: Path, tmp_path: Path) -> Path:
    return clone(release, tmp_path / "project")


def clone(release: Path, folder: Path) -> Path:
    folder.parent.mkdir(parents=True, exist_ok=True)
    git(release, "clone", "--quiet", "--shared", ".", str(folder))
    return folder


def version() -> str:
    text = (ROOT / HEADER).read_text(encoding="utf-8")
    return ".".join(re.findall(r"^#define SBGC_VERSION_[A-Z]+ (\d+)$", text, re.MULTILINE))


def make(project: Path, *options: str, **settings: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [project / ".ci/release", *options],
        env={**os.environ, **settings},
        capture_output=True,
        text=True,
        check=False,
    )


def released(project: Path, zone: str) -> Path:
    """Makes the release; returns the folder with its files."""
    done = make(project, TZ=zone)
    assert done.returncode == 0, done.stderr
    return project / "build" / f"release-{version()}"


@pytest.fixture(name="made", scope="module")
def release_of_the_tag(release: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    project = clone(release, tmp_path_factory.mktemp("made") / "project")
    git(project, "tag", f"v{version()}")
    return released(project, "UTC")


def test_the_files_of_a_commit_are_the_same_everywhere(
    release: Path, made: Path, tmp_path: Path
) -> None:
    found = []
    for folder in (made, released(clone(release, tmp_path / "an/other"), "Asia/Tokyo")):
        subprocess.run(["sha256sum", "--check", "--quiet", "SHA256SUMS"], cwd=folder, check=True)
        found.append({path.name: path.read_bytes() for path in folder.iterdir()})
    archives = {
        f"sbgc-arduino-{version()}": "library.properties",
        f"sbgc-fuzz-seeds-{version()}": "sbgc.dict",
        f"sbgc-site-{version()}": "index.html",
    }
    others = [
        f"sbgc-{version()}.tar.gz",
        f"sbgc-{version()}.spdx.json",
        "sbgc.hpp",
        f"sbgc-npm-{version()}.tgz",
    ]
    files = {*(f"{name}.zip" for name in archives), *others}
    assert found[0].keys() == files | {"sbgc-1.whl", "sbgc_1_amd64.deb", "SHA256SUMS"}
    assert found[0] == found[1]
    listed = [line.split()[1] for line in found[0]["SHA256SUMS"].decode().splitlines()]
    assert listed == sorted(found[0].keys() - {"SHA256SUMS"})
    with tarfile.open(fileobj=BytesIO(found[0][f"sbgc-{version()}.tar.gz"])) as sources:
        told = sources.extractfile(f"sbgc-{version()}/PKG-INFO")
        assert told and f"Name: sbgc\nVersion: {version()}\n" in told.read().decode()
        assert {entry.mtime for entry in sources} == {1767323045}
    for name, file in archives.items():
        names = ZipFile(BytesIO(found[0][f"{name}.zip"])).namelist()
        assert {entry.partition("/")[0] for entry in names} == {name}
        assert f"{name}/{file}" in names


# The keys that the schema of SPDX 2.3 requires.
REQUIRED = {
    "": {"SPDXID", "spdxVersion", "creationInfo", "dataLicense", "name", "documentNamespace"},
    "creationInfo": {"created", "creators"},
    "packages": {"SPDXID", "name", "downloadLocation"},
    "files": {"SPDXID", "fileName", "checksums"},
    "relationships": {"spdxElementId", "relationshipType", "relatedSpdxElement"},
}


def test_what_the_files_consist_of(made: Path) -> None:
    told = json.loads((made / f"sbgc-{version()}.spdx.json").read_text(encoding="utf-8"))
    for key, names in REQUIRED.items():
        things = told[key] if key else told
        for thing in things if isinstance(things, list) else [things]:
            assert names <= thing.keys(), thing
    assert told["spdxVersion"] == "SPDX-2.3" and told["dataLicense"] == "CC0-1.0"
    ids = [told["SPDXID"], *(thing["SPDXID"] for thing in [*told["packages"], *told["files"]])]
    assert len(set(ids)) == len(ids)
    assert all(re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", name) for name in ids)
    for relation in told["relationships"]:
        assert {relation["spdxElementId"], relation["relatedSpdxElement"]} <= set(ids)
    sums = {
        name: value
        for value, name in map(str.split, (made / "SHA256SUMS").read_text().splitlines())
    }
    del sums[f"sbgc-{version()}.spdx.json"]
    shown = {
        entry["fileName"].removeprefix("./"): next(
            sum_["checksumValue"] for sum_ in entry["checksums"] if sum_["algorithm"] == "SHA256"
        )
        for entry in told["files"]
    }
    assert shown == sums


def test_a_file_of_unknown_parts_is_refused(tmp_path: Path) -> None:
    (tmp_path / "other.bin").write_text("x")
    command = [sys.executable, str(ROOT / ".ci/sbom.py"), "1.0.0", "abc", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 1 and "unknown what other.bin consists of" in done.stderr


def test_the_tag_is_that_of_the_version(project: Path) -> None:
    git(project, "tag", "v9.9.9")
    done = make(project)
    assert done.returncode == 1
    assert f"has the tag v9.9.9, not v{version()}" in done.stderr


def test_the_site_has_those_of_the_releases(project: Path) -> None:
    for name in ("v0.9.0", "v0.10.0"):
        (project / "NEWS").write_text(name)
        git(project, "add", "NEWS")
        git(project, "commit", "--quiet", "--message", name)
        git(project, "tag", name)
    (project / "NEWS").write_text("soon")
    subprocess.run([project / "dev", "docs"], check=True)
    subprocess.run([project / ".ci/versions"], check=True)
    site = project / "build/site"
    links = ' <a href="{0}v0.10.0/index.html">0.10.0</a> <a href="{0}v0.9.0/index.html">0.9.0</a>'
    for page, root in (("index.html", ""), ("inner/page.html", "../")):
        assert f"<p>Releases:{links.format(root)}</p>\n</footer>" in (site / page).read_text()
    for name in ("v0.9.0", "v0.10.0"):
        text = (site / name / "index.html").read_text()
        assert f"<p>{name}</p>" in text and "Releases" not in text


def test_a_commit_that_is_not_ready(project: Path) -> None:
    def refusal() -> str:
        done = make(project)
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
    spec.write_text(text.replace("\n    id: 89\n", "\n    id: 178\n"), encoding="utf-8")
    error = refusal()
    assert "Set it to " in error and error.endswith("release: the model cannot be recorded\n")
    assert make(project, "--try").returncode == 0


def test_wrong_usage(project: Path) -> None:
    done = make(project, "--now")
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
