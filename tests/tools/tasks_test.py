"""The tasks of the guide send the messages that it lists beside them."""

from __future__ import annotations

import re
from pathlib import Path

from emulated_gimbal import emulated_gimbal
from sbgc_command import run

GUIDE = Path(__file__).resolve().parents[2] / "docs/26-how-do-i.md"
TASKS = re.findall(
    r"^\| `sbgc ([^`]+ [^`]+|\w+)` \| (`\w+`(?:, `\w+`)*) \|$", GUIDE.read_text(), re.M
)


def sent(capture: Path) -> set[str]:
    """Returns the names of the messages to the board in a capture."""
    decoded = run("decode", str(capture), "--from", "host", "--format", "jsonl")
    return {line["message"] for line in decoded.objects}


def test_tasks_send_what_the_guide_says(tmp_path: Path) -> None:
    assert len(TASKS) > 15
    with emulated_gimbal() as gimbal:
        for number, (task, cell) in enumerate(TASKS):
            capture = tmp_path / f"{number}.sbgc"
            words = [str(tmp_path / w) if w.endswith(".bin") else w for w in task.split()]
            common = ["-p", gimbal.address, *words, "--capture", str(capture)]
            done = run(*common, "--yes")
            if done.status == 2:  # it asks nothing
                done = run(*common)
            assert done.status == 0, f"{task}: {done.error}"
            assert set(re.findall(r"\w+", cell)) <= sent(capture), task
