"""Tests of requests with surplus: bytes after the largest form, which boards ignore."""

from __future__ import annotations

import json
from typing import Any

import pytest

from sbgc_command import MODEL, decode, frame, run

REQUESTS = [m for m in MODEL["messages"] if m["direction"] == "to_board"]
FORMS = {
    name: [m for m in REQUESTS if m["command"] == name] for name in {m["command"] for m in REQUESTS}
}


def takes_surplus(form: dict[str, Any]) -> bool:
    """A form that ends after fields of known number is followed by surplus."""
    is_grown = "sizes" in form  # later firmware has appended fields
    return not form["keeps_tail"] and not any(
        leaf["count"] is None
        or (leaf.get("may_be_missing") and not leaf.get("when") and not is_grown)
        for leaf in form["layout"]
    )


def encoded(lines: list[Any]) -> bytes:
    result = run("encode", "--no-validate", stdin="\n".join(map(json.dumps, lines)))
    assert result.status == 0, result
    return result.out


@pytest.mark.parametrize("command", sorted(FORMS))
def test_every_request_at_every_size(command: str) -> None:
    """The newest form decodes as in the model, and decoded bodies encode to the same bytes."""
    forms = FORMS[command]
    largest = max(forms, key=lambda form: form["max_size"])
    frames = [frame(largest["id"], bytes(size)) for size in range(256)]
    lines = decode(b"".join(frames), "--from", "host")
    assert len(lines) == 256
    for size, line in enumerate(lines):
        known = [f for f in forms if f["min_size"] <= size <= f["max_size"]]
        is_surplus = size > largest["max_size"] and takes_surplus(largest)
        assert ("tail" in line.get("fields", {})) == is_surplus or largest["keeps_tail"], size
        if is_surplus:
            assert line["message"] == largest["name"]
            # Flags that are 0 announce nothing, so a form with flags is its shortest then.
            assert len(line["fields"]["tail"]) // 2 in (
                size - largest["min_size"],
                size - largest["max_size"],
            )
        elif any(form["min_size"] == form["max_size"] for form in known):
            assert "error" not in line, size
        elif not known and takes_surplus(largest):
            assert line["error"]["code"] in ("unknown_form", "too_short"), size
    sizes = [size for size, line in enumerate(lines) if "error" not in line]
    good = [lines[size] for size in sizes]
    assert encoded(good) == b"".join(frames[size] for size in sizes)
