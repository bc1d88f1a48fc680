"""Every shell block of README and the guides runs, or says why not: <!-- not run: REASON --> before it.

What decodes and encodes is run by test_guides.py, the tour by test_tour.py, and ./dev at night. The rest runs here, on an
emulated gimbal instead of the one that it names.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests/emulator/serving"))

# Adds what a terminal and a person would: the gimbal, the consent, the end.
WRAPPER = """\
#!/bin/bash
case "$1 $2" in
  "params set" | "params restore" | "vars set" | menu* | calibrate* | move* | speed* | motors*) more=--yes ;;
  stream*) more="--for 500ms" ;;
  doctor*) more="--for 2s" ;;
esac
words=()
while (($#)); do
  if [[ $1 == -p ]]; then shift; else words+=("$1"); fi
  shift
done
exec "$SBGC" "${words[@]}" $more -p "$ADDRESS"
"""


def blocks() -> list[tuple[str, str]]:
    """The blocks that run here, with their pages."""
    found = []
    for page in (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))):
        text = page.read_text(encoding="utf-8")
        for fence in re.finditer(r"^```(\w*)\n(.*?)^```$", text, re.DOTALL | re.MULTILINE):
            code = fence[2]
            before = text[: fence.start()].rstrip().rpartition("\n")[2]
            is_shell = fence[1] in ("sh", "bash") or (not fence[1] and "sbgc " in code)
            is_run = re.search(r"^\./dev |\bsbgc (de|en)code\b", code, re.MULTILINE)
            if is_shell and not is_run and not re.match(r"<!-- not run: \S.+ -->$", before):
                found.append((page.name, code))
    return found


@pytest.mark.skipif("SBGC" not in os.environ, reason="SBGC does not name the sbgc command")
@pytest.mark.parametrize("page,code", blocks())
def test_the_block_runs(page: str, code: str, tmp_path: Path) -> None:
    command = [os.environ["SBGC"], "emulate", "--tcp", "0", "--firmware", "2.74"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as emulator:
        assert emulator.stdout
        address = re.search(r"tcp:\S+?(?=[,\s)]|$)", emulator.stdout.readline())
        assert address
        wrapper = tmp_path / "bin/sbgc"
        wrapper.parent.mkdir()
        wrapper.write_text(WRAPPER, encoding="utf-8")
        wrapper.chmod(0o755)
        path = f"{wrapper.parent}{os.pathsep}{os.environ['PATH']}"
        try:
            done = subprocess.run(
                ["bash", "-euo", "pipefail", "-c", code],
                cwd=tmp_path,
                env={**os.environ, "PATH": path, "ADDRESS": address[0], "HOME": str(tmp_path)},
                stdin=subprocess.DEVNULL,
                capture_output=True,
                text=True,
                timeout=120,
                check=False,
            )
        finally:
            emulator.terminate()
    assert done.returncode == 0, f"{page}: {code}{done.stdout}{done.stderr}"


def test_there_are_blocks() -> None:
    assert len(blocks()) >= 5
