"""Bytes as people post them, for sbgc decode: each notation means the same bytes as hex text."""

from __future__ import annotations

import os
import random
import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from sbgc_command import ON_WINDOWS, PROGRAM, decode, frame, run

FRAME = frame(67, bytes([1, *range(14)]))
ANSWER = bytes.fromhex("3e5612681f8709000200010000000000000000000000b2")


def lines_of(data: bytes, size: int) -> list[bytes]:
    return [data[at : at + size] for at in range(0, len(data), size)]


def characters(data: bytes) -> str:
    return "".join(chr(byte) if 32 <= byte < 127 else "." for byte in data)


def xxd(data: bytes) -> str:
    rows = enumerate(lines_of(data, 16))
    return "".join(f"{16 * i:08x}: {row.hex(' ', -2):<39}  {characters(row)}\n" for i, row in rows)


def hexdump(data: bytes) -> str:
    rows = enumerate(lines_of(data, 16))
    text = "".join(
        f"{16 * i:08x}  {row[:8].hex(' '):<23}  {row[8:].hex(' '):<23}  |{characters(row)}|\n"
        for i, row in rows
    )
    return text + f"{len(data):08x}\n"


def od(data: bytes) -> str:
    rows = enumerate(lines_of(data, 16))
    return "".join(f"{16 * i:07o} {row.hex(' ')}\n" for i, row in rows) + f"{len(data):07o}\n"


def wireshark(data: bytes) -> str:
    rows = enumerate(lines_of(data, 16))
    return "".join(
        f"{16 * i:04x}   {row[:8].hex(' '):<23}  {row[8:].hex(' '):<23}   {characters(row)}\n"
        for i, row in rows
    )


def braced(data: bytes) -> str:
    def shown(byte: int) -> bool:
        return 32 <= byte < 127 and chr(byte) not in "{}"

    return "".join(chr(byte) if shown(byte) else f"{{{byte:02X}}}" for byte in data)


def c_lines(data: bytes) -> str:
    lines = [f"  {row.hex(' ')},  // bytes /* of */ 16" for row in lines_of(data, 16)]
    return "const uint8_t b[] = {  /* a frame */\n" + "\n".join(lines) + "\n};\n"


def c_string(data: bytes) -> str:
    return '"' + "".join(f"\\x{byte:02x}" for byte in data) + '";'


def socat(data: bytes, has_characters: bool = False) -> str:
    text = ""
    for i, part in enumerate(lines_of(data, 21)):
        arrow = "<>"[i % 2]
        text += (
            f"{arrow} 2026/11/26 12:34:56.{i:09d}  length={len(part)} from=0 to={len(part) - 1}\n"
        )
        for row in lines_of(part, 16):
            shown = f"   {characters(row)}" if has_characters else ""
            text += f" {row.hex(' '):<47}{shown}\n"
        text += "--\n"
    return text


def candump(data: bytes) -> str:
    return "".join(
        f" (1795694400.{i:06d})  can0  12{i % 2 + 3}   [{len(row)}]  {row.hex(' ').upper()}   '{characters(row)}'\n"
        for i, row in enumerate(lines_of(data, 8))
    )


def candump_log(data: bytes) -> str:
    rows = enumerate(lines_of(data, 8))
    return "".join(f"(1795694400.{i:06d}) can0 123#{row.hex().upper()}\n" for i, row in rows)


def logic2(data: bytes, quote: str = "", value: str = "0x{:02X}", tab: str = ",") -> str:
    """Saleae Logic 2: with other analyzers in the same table, and with errors."""
    titles = ["name", "type", "start_time", "duration", "data", "error"]
    lines = [[f"{quote}{title}{quote}" for title in titles]]
    for i, byte in enumerate(data):
        shown = f"{quote}{value.format(byte)}{quote}"
        lines.append(['"Async Serial"', '"data"', f"{i / 1000}", "8.68e-05", shown, ""])
        lines.append(['"I2C"', '"start"', f"{i / 1000}", "1e-06", "", ""])
    return "".join(tab.join(line) + "\r\n" for line in lines)


NOTATIONS: dict[str, Callable[[bytes], str]] = {
    "hex": bytes.hex,
    "words": lambda data: data.hex(" "),
    "dots": lambda data: data.hex("."),
    "dashes": lambda data: data.hex("-").upper(),
    "single digits": lambda data: " ".join(f"{byte:x}" for byte in data),
    "C array": lambda data: "uint8_t b[] = {" + ", ".join(f"0x{b:02x}" for b in data) + "};",
    "C lines": c_lines,
    "C string": c_string,
    "Python": repr,
    "Python hex": lambda data: str([hex(byte) for byte in data]),
    "Python fromhex": lambda data: f"bytes.fromhex('{data.hex()}')",
    "JavaScript": lambda data: f"Uint8Array({len(data)}) {list(data)}",
    "Node.js": lambda data: f"<Buffer {data.hex(' ')}>",
    "with h": lambda data: data.hex(" ").upper().replace(" ", "h ") + "h",
    "with $": lambda data: "$" + data.hex(" ").replace(" ", " $"),
    "in angles": lambda data: "".join(f"<{byte:02X}>" for byte in data),
    "columns": lambda data: data.hex("|"),
    "no-break spaces": lambda data: data.hex(" ").replace(" ", "\u00a0"),
    "marked as UTF-8": lambda data: "\ufeff" + data.hex(" ") + "\r\n",
    "a line per byte": lambda data: "".join(f"uart-1: {byte:02X}\n" for byte in data),
    "logic analyser": lambda data: "Time [s],Value,Parity Error,Framing Error\r\n"
    + "".join(f"{i / 1000:.15f},0x{byte:02X},,\r\n" for i, byte in enumerate(data)),
    "in a forum": lambda data: f"I got this\n```\n{data.hex(' ')}\n```\nWhat does it mean?\n",
    "quoted": lambda data: "".join(f"> {row.hex(' ')}\n" for row in lines_of(data, 16)),
    "Python bytearray": lambda data: repr(bytearray(data)),
    "decimal": lambda data: str(list(data)),
    "signed": lambda data: " ".join(str(b - 256 if b > 127 else b) for b in data),
    "xxd": xxd,
    "hexdump": hexdump,
    "od": od,
    "Wireshark": wireshark,
    "braces": braced,
    "socat": socat,
    "socat with characters": lambda data: socat(data, True),
    "candump": candump,
    "candump log": candump_log,
    "Logic 2": logic2,
    "Logic 2, quoted": lambda data: logic2(data, quote='"'),
    "Logic 2, decimal": lambda data: logic2(data, value="{}", tab=";"),
}


@pytest.mark.parametrize("notation", NOTATIONS)
def test_each_notation_means_the_same_bytes(notation: str) -> None:
    write = NOTATIONS[notation]
    chosen = random.Random(1)
    for data in (FRAME, ANSWER, FRAME + ANSWER, ANSWER * 5, bytes(2) + FRAME):
        assert decode(write(data)) == decode(data), write(data)
    for size in (3, 17, 200):
        noise = FRAME + bytes(chosen.choices(range(256), k=size)) + ANSWER
        assert decode(write(noise)) == decode(noise), write(noise)


@pytest.mark.parametrize("notation", ["words", "Python", "decimal", "xxd", "braces"])
def test_a_damaged_frame_is_explained_as_in_raw_bytes(notation: str) -> None:
    damaged = FRAME[:-1] + b"\x02"
    assert run("decode", stdin=NOTATIONS[notation](damaged)).out == run("decode", stdin=damaged).out


@pytest.mark.parametrize(
    "front",
    [
        "12:34:56 {}",
        "12:34:56.789 {}: ",
        "[2026-11-26 12:34:56.789] {} ",
        "2026-11-26T12:34:56 {}> ",
        "(1.250) {} ",
        "0.001234 s {} | ",
        "1795694400.125 [{}] ",
        "12:34:56 PM {} ",
        "2026-11-26T12:34:56.789Z {}: ",
        "26.11.2026 12:34:56.789 [{}] - ",
        "{}: ",
        "{}\n",
    ],
)
@pytest.mark.parametrize(
    "names", [("TX", "RX"), ("sent", "received"), ("->", "<-"), ("Request", "Response")]
)
def test_times_and_senders_in_a_log(front: str, names: tuple[str, str]) -> None:
    host, board = (front.format(name) for name in names)
    request = bytes.fromhex("3e56005600")
    log = f"{host} {request.hex(' ')}\n{board} {ANSWER.hex(' ')}\n"
    lines = decode(log)
    assert [line["direction"] for line in lines] == ["to_board", "from_board"]
    assert [line["offset"] for line in lines] == [0, len(request)]
    # A request with a body that an answer could have too.
    request = bytes.fromhex("3e5601570000")
    assert decode(f"{host} {request.hex()}\n")[0]["direction"] == "to_board"
    assert decode(f"{board} {request.hex()}\n")[0]["direction"] == "from_board"


@pytest.mark.parametrize(
    "front, direction",
    [
        ("Data: ", None),
        ("PC -> gimbal: ", None),
        ("Command received: ", None),
        ("Bytes sent: ", "to_board"),
        ("Answer of the board: ", "from_board"),
        ("TX [5 bytes]: ", "to_board"),
        ("RX (5): ", "from_board"),
        ("reply= ", "from_board"),
        ("2026-11-26 12:34:56,789 - DEBUG - TX: ", "to_board"),
        ("[INFO] [1612345678.123] RX: ", "from_board"),
    ],
)
def test_labels(front: str, direction: str | None) -> None:
    # It could be of both.
    both = bytes.fromhex("3e5601570000")
    (line,) = decode(front + both.hex(" "))
    assert line["direction"] == (direction or decode(both)[0]["direction"])
    assert line["offset"] == 0


def octal(data: bytes) -> str:
    """Formats bytes as strace does: with the shortest octal escapes."""
    text = re.sub(
        r"[\x00-\x1f\x7f-\xff\"\\]", lambda c: f"\\{ord(c[0]):o}\0", data.decode("latin-1")
    )
    return re.sub(r"\\(\d+)\0(\d?)", lambda m: f"\\{m[1]:0>{3 if m[2] else 1}}{m[2]}", text)


@pytest.mark.parametrize(
    "write", [octal, lambda data: "".join(f"\\x{byte:02x}" for byte in data)], ids=["octal", "-xx"]
)
def test_strace(write: Callable[[bytes], str]) -> None:
    request = bytes.fromhex("3e56015701" + "01")
    log = f"""openat(AT_FDCWD, "/dev/ttyUSB0", O_RDWR) = 3
12:34:56.789 write(3, "{write(request[:4])}", 4) = 4
[pid 12] write(3</dev/ttyUSB0>, "{write(request[4:] + FRAME)}", 22) = 2
write(3, "{write(FRAME)}", 19) = -1 EAGAIN (Resource temporarily unavailable)
select(4, [3], NULL, NULL, NULL) = 1 (in [3])
read(3, "{write(ANSWER[:9])}", 64) = 9
read(3,  <unfinished ...>
<... read resumed>"{write(ANSWER[9:])}", 64) = {len(ANSWER) - 9}
+++ exited with 0 +++
"""
    lines = decode(log)
    assert [(line["id"], line["direction"]) for line in lines] == [
        (86, "to_board"),
        (86, "from_board"),
    ]
    assert [line["offset"] for line in lines] == [0, len(request)]


def debug_tab(data: bytes) -> str:
    body = "".join(f"{byte:x} " for byte in data[4:-1])
    return f"{chr(data[1])} [{data[1]},{data[2]}] [{body}] {data[-1]:x}\n"


def test_the_debug_tab_of_the_vendors_program() -> None:
    line = "V [86,18] [1f 46 a 0 1b 0 0 0 0 0 0 0 0 0 0 0 0 0 ] 8a\n"
    (info,) = decode(line)
    assert (info["message"], info["fields"]["firmware_ver"]) == ("BoardInfo", 0x0A46)
    empty = frame(73)
    for front in ("", "12:34:56.789 "):
        text = "".join(front + debug_tab(one) for one in (ANSWER, empty, FRAME))
        assert decode(text) == decode(ANSWER + empty + FRAME)
    wrong = run("decode", stdin=line.replace("8a", "8b"))
    assert wrong.status == 1 and "checksum of its body is 0x8b, not 0x8a" in wrong.text
    short = run("decode", stdin=line + line.replace("[86,18]", "[86,17]"))
    assert short.status == 1 and "the body has 18 bytes, not 17" in short.error
    assert "BoardInfo" in short.text


BARE = "58 08 60 c1 0e fd ff 0c 00 49 00"


@pytest.mark.parametrize("checksum", [b"", b"\x1e"], ids=["without", "with"])
def test_frames_without_their_start_bytes(checksum: bytes) -> None:
    """They are shown, but they are no frames: JSON lines hold none."""
    data = bytes.fromhex(BARE) + bytes([sum(bytes.fromhex(BARE)[3:]) % 256] if checksum else [])
    for text in (data, data.hex(" "), f"RX: {data.hex()}\n", str(list(data)), data * 2):
        result = run("decode", stdin=text)
        assert result.status == 1 and "without start bytes" in result.error
        shown = result.text.splitlines()
        assert re.fullmatch(r"@0  no frame: \d+ bytes", shown[0])
        missing = "its start byte" + ("" if checksum else " and the checksum behind its body")
        assert shown[1].startswith(f"@0, without {missing}:  CMD_REALTIME_DATA_CUSTOM (88)")
        assert sum("timestamp_ms" in line for line in shown) == (2 if text == data * 2 else 1)
        lines = run("decode", "--format", "jsonl", stdin=text)
        assert lines.status == 1 and lines.out == b"" and "--format text" in lines.error
    noise = run("decode", stdin=data + b"\x01\x02")
    assert noise.status == 1 and "without" not in noise.text


def test_bytes_as_arguments(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for arguments in (["3e49004900"], "3e 49 00 49 00".split(), ["TX: 3e 49 00 49 00"]):
        result = run("decode", *arguments)
        assert result.status == 0 and "GetAnglesRequest" in result.text
    assert "CMD_REALTIME_DATA_CUSTOM" in run("decode", BARE).text
    missing = run("decode", "flight.sbgc")
    assert missing.status == 1 and "cannot open 'flight.sbgc'" in missing.error
    assert run("decode", "some", "files").status == 2
    Path("3e49004900").write_bytes(ANSWER)
    assert "BoardInfo" in run("decode", "3e49004900").text, "a file comes first"


@pytest.mark.skipif(ON_WINDOWS, reason="pty")
@pytest.mark.parametrize(
    "command, awaited", [("decode", "bytes, such as"), ("encode", "JSON lines")]
)
def test_a_terminal_is_told_what_is_awaited(command: str, awaited: str) -> None:
    import pty  # pylint: disable=import-outside-toplevel

    ours, theirs = pty.openpty()
    options = [command] + (["--hex"] if command == "encode" else [])
    with subprocess.Popen([PROGRAM, *options], stdin=theirs, stderr=subprocess.PIPE) as process:
        assert process.stderr
        line = process.stderr.readline().decode()
        assert f"waits for {awaited}" in line and "Ctrl+D" in line
        os.write(ours, b"\x04")
        assert process.wait(30) == 0
    os.close(ours)
    os.close(theirs)


def test_the_baud_rate_is_not_blamed_for_text() -> None:
    for text in ("12 34 56 78 9a", "[12, 34, 56, 78, 200]", "3e 95 84 7d 46 21 1b 00 00"):
        result = run("decode", stdin=text)
        assert result.status == 1 and "baud" not in result.error, result.error


def test_a_star_repeats_a_line_of_a_dump() -> None:
    text = "00000000  " + "00 " * 16 + " |................|\n*\n"
    text += "00000030  3e 56 00 56 00                                    |>V.V.|\n00000035\n"
    (line,) = decode(text)
    assert line["offset"] == 0x30
    octal = "0000000 " + "00 " * 16 + "\n*\n0000060 3e 56 00 56 00\n0000065\n"
    assert decode(octal) == [line]


def test_hex_can_be_demanded() -> None:
    frames = "12 24 3E 56 00 56 00"
    assert decode(frames, "--hex") == decode(frames)
    result = run("decode", "--hex", stdin="10 20 30")
    assert result.status == 1 and "found no frame in 3 bytes" in result.error
