"""Every text that sbgc reads may come from an editor of Windows; what is no text is refused."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from emulated_gimbal import emulated_gimbal
from sbgc_command import Result, run

FLEET = '[fleet]\nname = "studio"\n[metrics]\n[gimbal.front]\nport = "tcp:127.0.0.1:1"\n'
MOTION = "time,roll,pitch,yaw\n0,0,0,0\n1,10,0,0\n"
READERS: dict[str, tuple[str, Callable[[str], Result]]] = {
    "configuration": ("[gimbal.a]\nport = 'capture:/none'\n", lambda _: run("info", "-g", "a")),
    "fleet": (FLEET, lambda file: run("gateway", "--config", file, "--check")),
    "motion": (MOTION, lambda file: run("emulate", "--stdio", "--for", "10ms", "--motion", file)),
    "table": ("t,a\n0,0\n1,1\n", lambda file: run("plot", file)),
    "json": ('{"message":"GetAnglesRequest","fields":{}}\n', lambda file: run("encode", file)),
}


@pytest.mark.parametrize("kind", READERS)
def test_ends_of_lines_and_byte_order_marks(
    kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text, read = READERS[kind]
    file = tmp_path / "file"
    monkeypatch.setenv("SBGC_CONFIG", str(file))
    content = text.encode()
    file.write_bytes(content)
    plain = read(str(file))
    assert "file:" not in plain.error, "the text itself is right"
    for other in (b"\xef\xbb\xbf" + content, content.replace(b"\n", b"\r\n")):
        file.write_bytes(other)
        assert read(str(file)) == plain
    for damaged in (content[:-3] + b"\0" + content[-3:], text.encode("utf-16")):
        file.write_bytes(damaged)
        refused = read(str(file))
        assert refused.status in (1, 2) and refused.error and not refused.out


def test_lines_of_the_shell() -> None:
    script = b"describe MODE_ANGLE\ndescribe pid\n"
    with emulated_gimbal() as gimbal:
        plain = run("shell", "-p", gimbal.address, stdin=script)
        assert plain.status == 0
        other = b"\xef\xbb\xbf" + script.replace(b"\n", b"\r\n")
        assert run("shell", "-p", gimbal.address, stdin=other).out == plain.out
        refused = run("shell", "-p", gimbal.address, stdin=b"describe pid\ndescribe\0 pid\n")
    assert refused.status == 1 and "line 2 has a NUL byte" in refused.error
