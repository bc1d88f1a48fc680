"""`pip install .` in a fresh virtual environment, without a network."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = """
import sbgc
from sbgc import msg
assert "{folder}" in sbgc.__file__, sbgc.__file__
with sbgc.emulator() as board, sbgc.connect(board) as gimbal:
    assert isinstance(gimbal.call(msg.GetAnglesRequest()), msg.GetAngles)
"""


def run(*command: object) -> None:
    words = [str(word) for word in command]
    done = subprocess.run(words, capture_output=True, text=True, cwd=ROOT, check=False)
    assert done.returncode == 0, f"{words}: {done.stdout[-3000:]}{done.stderr[-3000:]}"


def without_network(*command: object) -> None:
    run("unshare", "--map-root-user", "--net", *command)


def test_the_package_installs_and_runs_without_a_network(tmp_path: Path) -> None:
    folder = tmp_path / "fresh"
    run(sys.executable, "-m", "venv", folder)
    python = folder / "bin" / "python3"
    without_network(python, "-m", "pip", "install", "--no-cache-dir", ".")
    run(python, "-W", "error", "-c", PROGRAM.format(folder=folder))
    (library,) = folder.rglob("_core*.so")
    assert library.stat().st_size < 4_000_000
    without_network(python, "-m", "pip", "install", "--no-cache-dir", "-e", ".")
    run(python, "-W", "error", "-c", PROGRAM.format(folder=ROOT / "build" / "wheel"))


def test_the_archive_of_the_sources_installs_beside_the_packages_of_debian(tmp_path: Path) -> None:
    folder = tmp_path / "beside"
    run(sys.executable, "-m", "venv", "--system-site-packages", folder)
    python = folder / "bin" / "python3"
    build = "import sys, build_backend; build_backend.build_sdist(sys.argv[1])"
    run("env", "PYTHONPATH=python", sys.executable, "-Bc", build, tmp_path)
    (archive,) = tmp_path.glob("sbgc-*.tar.gz")
    without_network(python, "-m", "pip", "install", "--no-cache-dir", archive)
    run(python, "-W", "error", "-c", f"import numpy\n{PROGRAM.format(folder=folder)}")


def test_messages_and_bytes_need_no_client(tmp_path: Path) -> None:
    without = [f"-DSBGC_{part}=OFF" for part in ("BUILD_IO", "BUILD_TESTS", "BUILD_EXAMPLES")]
    options = [
        *without,
        "-DSBGC_BUILD_TOOLS=OFF",
        "-DSBGC_BUILD_PYTHON=ON",
        "-DSBGC_REGENERATE=OFF",
    ]
    run("cmake", "-S", ".", "-B", tmp_path, "-G", "Ninja", "-DCMAKE_UNITY_BUILD=ON", *options)
    run("cmake", "--build", tmp_path, "--target", "sbgc_python")
    python = ("env", f"PYTHONPATH={tmp_path}/python", "/usr/bin/python3")
    says = "import sbgc; assert not hasattr(sbgc, 'connect')"
    run(*python, "-W", "error", "-c", says)
    run(
        *python,
        "-m",
        "pytest",
        "-q",
        "-p",
        "no:cacheprovider",
        "--noconftest",
        "tests/python/vectors_test.py",
    )


@pytest.fixture(autouse=True)
def _has_unshare() -> None:
    assert shutil.which("unshare"), "apt-get install util-linux"
