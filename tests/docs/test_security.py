"""The limits in SECURITY.md are those of the code."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
TEXT = (ROOT / "SECURITY.md").read_text(encoding="utf-8")
ROWS = re.findall(r"^\| [^|]+ \| (\d+)( bytes| MiB|) \| `(\S+)` \| `(\S+)` \|$", TEXT, re.M)
LIMITS = TEXT.split("## Limits")[1]


def value_of(constant: str, file: str) -> int:
    """Returns the value of an integer constant, or of a member's default, as the source says it."""
    source = (ROOT / file).read_text(encoding="utf-8")
    name = constant.rpartition("::")[2]
    (expression,) = set(re.findall(rf"\b(?:size_t|int|unsigned) {name} = ([^;]+);", source))
    plain = re.sub(r"std::size_t\{(\w+)\}", r"\1", expression)
    plain = re.sub(r"(\d)U\b", r"\1", plain).replace("'", "")
    assert re.fullmatch(r"[\d <]+", plain), expression
    return int(eval(plain))  # pylint: disable=eval-used


def test_every_row_is_checked() -> None:
    assert len(ROWS) == LIMITS.count("\n| ") - 1 > 20


@pytest.mark.parametrize("figure, unit, constant, file", ROWS)
def test_the_figure_is_that_of_the_code(figure: str, unit: str, constant: str, file: str) -> None:
    factor = 2**20 if unit == " MiB" else 1
    assert value_of(constant, file) == int(figure) * factor
