"""The picture of the monitor shows what the program shows today."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

PICTURES = Path(__file__).resolve().parents[2] / "docs/pictures"
sys.path.append(str(PICTURES))

import monitor  # noqa: E402

# To draw it again: docs/pictures/monitor.py build/release/tools/sbgc docs/pictures/monitor.svg
PICTURE = PICTURES / "monitor.svg"


def labels(svg: str) -> set[tuple[str, str, str]]:
    """The words that do not depend on what the gimbal does, with their places."""
    texts = ElementTree.fromstring(svg).iter("{http://www.w3.org/2000/svg}text")
    found = {(text.get("x", ""), text.get("y", ""), text.text or "") for text in texts}
    return {label for label in found if label[2].replace(":", "").isalpha() and len(label[2]) > 2}


@pytest.mark.skipif("SBGC" not in os.environ, reason="SBGC does not name the sbgc command")
def test_the_picture_shows_what_the_monitor_shows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(monitor, "FRAMES", 1)
    monkeypatch.setattr(monitor, "BEFORE", 0)
    (screen,) = monitor.screens(os.environ["SBGC"], tmp_path / "tmux")
    shown = labels(monitor.picture([monitor.words(screen)]))
    assert {"roll", "pitch", "yaw", "battery"} <= {text for _, _, text in shown}
    assert shown == labels(PICTURE.read_text(encoding="utf-8"))


def test_a_row_that_changes_is_drawn_for_each_time() -> None:
    frames = [monitor.words([f"\x1b[1myaw\x1b[0m {angle}"]) for angle in (1, 2, 2)]
    groups = ElementTree.fromstring(monitor.picture(frames)).iter("{http://www.w3.org/2000/svg}g")
    found = {group.get("class"): "".join(group.itertext()) for group in groups}
    assert found == {"f0-3": "yaw", "f0-1": "1", "f1-3": "2"}
