"""Worked examples of specs unlike that of the project."""

from __future__ import annotations

from pathlib import Path

from sbgcgen.build import load_layout
from sbgcgen.targets import target
from support import write_spec


def test_site_of_a_protocol_without_requests_that_have_a_body(tmp_path: Path) -> None:
    spec = write_spec(tmp_path)
    base = spec / "base.yaml"
    text, _, rest = base.read_text("utf-8").partition("\n  CMD_USE:")
    assert rest
    base.write_text(text + "\n")
    files = dict(target("site").files(load_layout(spec), tmp_path))
    assert b"3E" in files["framing.html"]
