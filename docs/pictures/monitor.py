#!/usr/bin/env python3
"""Draws monitor.svg: what `sbgc monitor` shows while a camera moves.

    docs/pictures/monitor.py SBGC OUTPUT

The program SBGC watches an emulated gimbal in a terminal (tmux), whose contents become the frames of
the picture.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from html import escape
from pathlib import Path

COLUMNS, ROWS = 80, 24
# Seconds until the charts have a beginning, and from a frame to the next.
FRAMES, BEFORE, INTERVAL = 24, 4.0, 0.5
CELL_WIDTH, CELL_HEIGHT, MARGIN = 8, 17, 14
GROUND, TEXT, DIM = "#0d1117", "#e6edf3", "#8b949e"
COLORS = (GROUND, "#ff7b72", "#7ee787", "#e3b341", "#79c0ff", "#d2a8ff", "#56d4dd", TEXT)


@dataclass(frozen=True)
class Style:
    color: str = TEXT
    ground: str = ""
    is_bold: bool = False
    is_dim: bool = False

    def after(self, code: int) -> Style:
        """The style after a code of the escape sequence `ESC [ CODES m`."""
        if 30 <= code <= 37:
            return replace(self, color=COLORS[code - 30])
        if 40 <= code <= 47:
            return replace(self, ground=COLORS[code - 40])
        return {
            0: Style(),
            1: replace(self, is_bold=True),
            2: replace(self, is_dim=True),
            39: replace(self, color=TEXT),
            49: replace(self, ground=""),
        }[code]


@dataclass(frozen=True)
class Word:
    """Text in one style, without the spaces around it unless it has a background."""

    row: int
    column: int
    text: str
    style: Style

    def svg(self) -> str:
        x, width = MARGIN + self.column * CELL_WIDTH, len(self.text) * CELL_WIDTH
        top = MARGIN + self.row * CELL_HEIGHT
        ground = (
            f'<rect x="{x}" y="{top}" width="{width}" height="{CELL_HEIGHT}"'
            f' fill="{self.style.ground}"/>'
            if self.style.ground
            else ""
        )
        color = DIM if self.style.is_dim else self.style.color
        bold = ' font-weight="bold"' if self.style.is_bold else ""
        # Fonts differ in the width of Braille patterns.
        return (
            f'{ground}<text x="{x}" y="{top + 13}" textLength="{width}" fill="{color}"{bold}>'
            f"{escape(self.text)}</text>"
        )


def words(screen: list[str]) -> set[Word]:
    style, found = Style(), set()
    for row, line in enumerate(screen):
        column = 0
        for codes, text in re.findall(r"\x1b\[([\d;]*)m|([^\x1b]+)", line):
            if not text:
                for code in codes.split(";"):
                    style = style.after(int(code or 0))
                continue
            for word in re.finditer(r".+" if style.ground else r"\S+", text):
                found.add(Word(row, column + word.start(), word[0], style))
            column += len(text)
    return found


def spans(word: Word, frames: list[set[Word]]) -> Iterator[tuple[int, int]]:
    """Yields from which frame on, and until before which, the word is there."""
    begin = None
    for number, frame in enumerate([*frames, set[Word]()]):
        if word in frame and begin is None:
            begin = number
        elif word not in frame and begin is not None:
            yield begin, number
            begin = None


def picture(frames: list[set[Word]]) -> str:
    groups: dict[tuple[int, int], list[Word]] = {}
    for word in set().union(*frames):
        for span in spans(word, frames):
            groups.setdefault(span, []).append(word)
    styles, body = [], []
    for (begin, end), found in sorted(groups.items()):
        name = f"f{begin}-{end}"
        # Without animation, the last frame is visible.
        hidden = "" if end == len(frames) else ' visibility="hidden"'
        content = "".join(word.svg() for word in sorted(found, key=lambda w: (w.row, w.column)))
        body.append(f'<g class="{name}"{hidden}>{content}</g>\n')
        if (begin, end) == (0, len(frames)):
            continue
        states = {0: "visible" if begin == 0 else "hidden", begin: "visible"}
        states[end] = "hidden" if end < len(frames) else "visible"
        steps = (
            f"{100 * frame / len(frames):.4g}%{{visibility:{state}}}"
            for frame, state in states.items()
        )
        styles.append(f".{name}{{animation-name:{name}}}@keyframes {name}{{{''.join(steps)}}}\n")
    size = [COLUMNS * CELL_WIDTH + 2 * MARGIN, ROWS * CELL_HEIGHT + 2 * MARGIN]
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size[0]} {size[1]}" role="img">\n'
        "<title>sbgc monitor: angles, motor power and charts while the camera moves</title>\n"
        "<style>\ntext{font-family:ui-monospace,Menlo,Consolas,'DejaVu Sans Mono',monospace;"
        "font-size:13px;white-space:pre}\n"
        f"g{{animation:{len(frames) * INTERVAL:g}s step-end infinite}}\n{''.join(styles)}"
        "@media (prefers-reduced-motion:reduce){g{animation:none}}\n</style>\n"
        f'<rect width="100%" height="100%" rx="8" fill="{GROUND}"/>\n{"".join(body)}</svg>\n'
    )


def screens(sbgc: str, socket: Path) -> Iterator[list[str]]:
    """Yields what the monitor shows, while another program moves the camera there and back."""

    def tmux(*command: str) -> str:
        program = ["tmux", "-u", "-f", "/dev/null", "-S", str(socket)]
        return subprocess.run(
            [*program, *command], capture_output=True, text=True, check=True
        ).stdout

    board = subprocess.Popen(
        [sbgc, "emulate", "--tcp", "0", "--motion", "handheld", "--firmware", "2.74"],
        stdout=subprocess.PIPE,
        text=True,
    )
    try:
        assert board.stdout is not None
        place = board.stdout.readline().split()[3]
        size = ["-x", str(COLUMNS), "-y", str(ROWS)]
        tmux("new-session", "-d", *size, f"exec {sbgc} monitor -p {place}")
        tmux("set", "-g", "status", "off")
        while "battery" not in tmux("capture-pane", "-p"):
            time.sleep(0.1)
        time.sleep(BEFORE)
        moves = {FRAMES // 8: ("25", "-40"), FRAMES * 5 // 8: ("0", "0")}
        for frame in range(FRAMES):
            if frame in moves:
                pitch, yaw = moves[frame]
                target = ["--pitch", pitch, "--yaw", yaw, "--speed", "30"]
                subprocess.run(
                    [sbgc, "move", *target, "--yes", "-p", place], capture_output=True, check=True
                )
            yield tmux("capture-pane", "-p", "-e").split("\n")[:ROWS]
            time.sleep(INTERVAL)
        tmux("kill-server")
    finally:
        board.kill()
        board.wait()


def main() -> None:
    sbgc, output = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        frames = [words(screen) for screen in screens(sbgc, Path(folder) / "tmux")]
    Path(output).write_text(picture(frames), encoding="utf-8")


if __name__ == "__main__":
    main()
