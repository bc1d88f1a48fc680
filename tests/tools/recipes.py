"""Runs the recipes of the guide: `./dev test tools --long`, because the programs are large."""

from __future__ import annotations

import subprocess
from pathlib import Path

from guide_test import fixture_folder as fixture_folder
from guide_test import recipe


def run(folder: Path, *command: str) -> str:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0 and not done.stderr, done.stderr
    return done.stdout


def test_pandas(folder: Path) -> None:
    lines = run(folder, "/usr/bin/python3", "-c", recipe("python")).splitlines()
    assert lines[0].split() == ["angle.pitch[deg]", "bat_level[V]"]
    (count,) = [line.split()[1:] for line in lines if line.startswith("count")]
    assert float(count[0]) == float(count[1]) > 20


def test_gnuplot(folder: Path) -> None:
    (folder / "plot").write_text(recipe("gnuplot"))
    drawn = run(folder, "gnuplot", "plot")
    assert drawn.count("*") > 20 and "+----" in drawn
