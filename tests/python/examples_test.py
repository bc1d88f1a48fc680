"""The Python of the worked examples on the site makes their frames, and prints what the pages say."""

from __future__ import annotations

import sys
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "generator"))

from sbgcgen.build import load_protocol  # noqa: E402
from sbgcgen.model import Message  # noqa: E402
from sbgcgen.oracle.example import example_of  # noqa: E402
from sbgcgen.targets import codes_of  # noqa: E402

LAYOUT = load_protocol(ROOT / "spec").layout


def name_of(message: Message) -> str:
    return f"{message.name}-{message.direction}"


@pytest.mark.parametrize("message", LAYOUT.messages, ids=name_of)
def test_example(message: Message) -> None:
    example = example_of(message, LAYOUT)
    (code,) = [code for code in codes_of(example) if code.language == "Python"]
    names: dict[str, Any] = {}
    printed = StringIO()
    with redirect_stdout(printed):
        exec(code.text, names)  # as a reader of the page runs it
    if "encode" in names:
        assert names["frame"].hex() == example.frame.hex(), code.text
    else:
        assert names["frame"] == example.frame
        assert printed.getvalue().splitlines() == list(code.output), code.text
        assert type(names["message"]).__name__ == message.name
