"""Passwords of gimbals: where they come from, that they are sent first, and that nothing shows them."""

from __future__ import annotations

import os
import re
import signal
import socket
import subprocess
import termios
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from board_command import Terminal
from bridge import Bridge, Host
from emulated_gimbal import emulated_gimbal
from sbgc_command import Running, frame, run

PASSWORD = "sesame, öffne"
OPENING = b"\x00\x00" + bytes([len(PASSWORD.encode())]) + PASSWORD.encode()
BOARD_INFO, GET_ANGLES, CONFIRM, ERROR = 86, 73, 67, 255
QUICK = ("--timeout", "2", "--attempts", "1")


def shows_password(*texts: str | bytes) -> bool:
    """True if one of the texts has the password, or an end of it, as text or as hex."""
    for text in texts:
        data = text.encode() if isinstance(text, str) else text
        for part in (PASSWORD.encode(), PASSWORD[:6].encode()):
            if part in data or part.hex().encode() in data.lower():
                return True
    return False


def file_with(folder: Path, text: str, mode: int = 0o600, name: str = "pass word") -> str:
    file = folder / name
    file.write_text(text, encoding="utf-8")
    file.chmod(mode)
    return str(file)


@pytest.fixture
def password_file(tmp_path: Path) -> str:
    return file_with(tmp_path, PASSWORD + "\n")


@pytest.fixture
def protected(password_file: str) -> Iterator[str]:
    """The address of a gimbal that wants a password."""
    with emulated_gimbal("--password-file", password_file, "--firmware", "2.74.5") as gimbal:
        yield gimbal.address


def test_a_protected_gimbal_answers_nothing_before_its_password(protected: str) -> None:
    host = Host(protected)
    host.socket.settimeout(0.3)
    wrong = b"\x00\x00\x05wrong"
    for command, body in ((GET_ANGLES, b""), (BOARD_INFO, b""), (BOARD_INFO, wrong), (200, b"")):
        host.send(command, body)
    with pytest.raises(TimeoutError):
        host.socket.recv(1)
    host.close()

    host = Host(protected)
    assert len(host.ask(BOARD_INFO, OPENING)) == 18
    assert host.ask(GET_ANGLES)
    other = Host(protected)
    other.socket.settimeout(0.3)
    other.send(GET_ANGLES)
    with pytest.raises(TimeoutError):
        other.socket.recv(1)
    other.close()
    host.close()


def test_the_password_is_sent_before_anything_else(tmp_path: Path, protected: str) -> None:
    file, capture = str(tmp_path / "pass word"), str(tmp_path / "capture")
    gimbal = ("-p", protected, "--password-file", file)
    result = run("info", *gimbal, "-v", "--capture", capture)
    assert result.status == 0 and "2.74.5" in result.text
    assert "will hold the password: keep it private" in result.error
    assert "password  (hidden)" in result.error
    assert not shows_password(result.out, result.error)
    hidden = run("decode", "--from", "host", capture)
    assert "password  (hidden)" in hidden.text.split("CMD_")[1], "the first frame"
    assert not shows_password(hidden.out)
    assert shows_password(Path(capture).read_bytes())
    assert PASSWORD in run("decode", "--show-passwords", capture).text


@pytest.mark.parametrize(
    "arguments",
    (
        ["get_angles", "--format", "jsonl"],
        ["CMD_PASS_PROTECT_READ"],
        ["CMD_PASS_PROTECT_WRITE", "flags=SILENT", "--yes"],
    ),
    ids=lambda arguments: arguments[0],
)
def test_commands_work_with_the_password(
    arguments: list[str], protected: str, password_file: str
) -> None:
    result = run("send", "-p", protected, "--password-file", password_file, "-v", *arguments)
    assert result.status == 0, result
    assert not shows_password(result.out, result.error)


@pytest.mark.parametrize(("command", "file"), (("params", "backup.json"), ("eeprom", "image")))
def test_backups_do_not_hold_it(
    command: str, file: str, tmp_path: Path, protected: str, password_file: str
) -> None:
    action = {"params": ["backup"], "eeprom": ["read"]}[command]
    target = tmp_path / file
    gimbal = ("-p", protected, "--password-file", password_file)
    result = run(command, *action, str(target), *gimbal, "-v")
    assert result.status == 0, result
    assert not shows_password(target.read_bytes(), result.out, result.error)


def test_without_it_or_with_another_one_there_is_no_gimbal(tmp_path: Path, protected: str) -> None:
    none = run("info", "-p", protected, *QUICK)
    assert none.status == 1 and "no board found" in none.error
    other = file_with(tmp_path, "other words", name="other")
    wrong = run("info", "-p", protected, "--password-file", other, *QUICK, "-v")
    assert wrong.status == 1
    assert "a port that wants another password does not answer" in wrong.error
    assert "other words" not in wrong.error


@pytest.mark.parametrize("mode", (0o640, 0o604, 0o620, 0o602, 0o610, 0o666))
def test_a_file_that_others_can_access_is_refused(mode: int, tmp_path: Path) -> None:
    file = file_with(tmp_path, PASSWORD, mode, name="it's mine")
    result = run("info", "-p", "tcp:127.0.0.1:1", "--password-file", file)
    assert result.status == 1 and not shows_password(result.error)
    command = re.search(r"run: (chmod 600 .*)", result.error)
    assert command, result
    subprocess.run(command[1], shell=True, check=True)
    assert Path(file).stat().st_mode & 0o777 == 0o600
    assert "others" not in run("info", "-p", "tcp:127.0.0.1:1", "--password-file", file).error


@pytest.mark.parametrize(
    "content", ("", "\n", "x" * 33, "two\nlines", "tab\there", "x" * 5000), ids=range(6)
)
def test_what_cannot_be_a_password(content: str, tmp_path: Path) -> None:
    file = file_with(tmp_path, content)
    result = run("info", "-p", "tcp:127.0.0.1:1", "--password-file", file)
    assert result.status == 1
    assert "a password is one line of 1 to 32 bytes" in result.error
    assert not content.strip() or content.strip() not in result.error


def test_files_that_are_none(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe", 0o600)
    for name, problem in (
        ("pipe", "not a regular file"),
        ("missing", "cannot read"),
        ("", "not a"),
    ):
        result = run("info", "-p", "tcp:127.0.0.1:1", "--password-file", str(tmp_path / name))
        assert result.status == 1 and problem in result.error


def test_the_configuration_names_the_file(
    tmp_path: Path, protected: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "configuration"
    folder.mkdir()
    file_with(folder, PASSWORD, name="front")
    config = folder / "config.toml"
    config.write_text(f'[gimbal.front]\nport = "{protected}"\npassword-file = "front"\n', "utf-8")
    monkeypatch.setenv("SBGC_CONFIG", str(config))
    assert run("info", "-g", "front").status == 0
    (folder / "front").chmod(0o644)
    refused = run("info", "-g", "front")
    assert refused.status == 1 and "chmod 600" in refused.error


def test_it_is_asked_for_without_an_echo(protected: str) -> None:
    terminal = Terminal("info", "-p", protected, "--password-file", "-")
    terminal.await_text(b"Password of " + protected.encode() + b": ")
    arguments, environment = (
        Path(f"/proc/{terminal.process}/{file}").read_bytes() for file in ("cmdline", "environ")
    )
    terminal.press(PASSWORD.encode() + b"\n")
    assert terminal.status() == 0
    assert b"2.74.5" in terminal.shown
    assert not shows_password(terminal.shown, arguments, environment)


@pytest.mark.parametrize("number", (signal.SIGINT, signal.SIGTERM))
def test_a_signal_at_the_question_leaves_a_terminal_with_echo(number: int) -> None:
    terminal = Terminal("info", "-p", "tcp:127.0.0.1:1", "--password-file", "-")
    terminal.await_text(b"Password of ")
    os.kill(terminal.process, number)
    assert terminal.status() in (130, -number)
    assert termios.tcgetattr(terminal.screen)[3] & termios.ECHO


# Sending


def test_a_new_password_is_not_on_the_command_line(
    tmp_path: Path, protected: str, password_file: str
) -> None:
    gimbal = ("-p", protected, "--password-file", password_file)
    refused = run("send", *gimbal, "CMD_PASS_PROTECT_WRITE", f"new_password={PASSWORD}", "--yes")
    assert refused.status == 2 and "new_password=@FILE" in refused.error
    assert not shows_password(refused.error)
    new = file_with(tmp_path, PASSWORD[::-1], name="new")
    tried = run("send", "CMD_PASS_PROTECT_WRITE", f"new_password=@{new}", "--dry-run")
    assert tried.status == 0 and tried.text.startswith("(hidden)\n")
    assert PASSWORD[::-1] not in tried.text
    for options in (["--format", "jsonl", "--dry-run"], ["--yes", "-v"]):
        sent = run("send", *gimbal, "CMD_PASS_PROTECT_WRITE", f"new_password=@{new}", *options)
        assert sent.status == 0 and "(hidden)" in sent.text + sent.error
        assert PASSWORD[::-1] not in sent.text + sent.error
        assert PASSWORD[::-1].encode().hex() not in sent.text + sent.error
    assert run("info", *gimbal, *QUICK).status == 1, "the former one no longer opens it"
    assert run("info", "-p", protected, "--password-file", new).status == 0


def test_bytes_with_a_password_are_refused() -> None:
    for number, body in ((86, OPENING), (137, bytes(8) + OPENING[2:])):
        result = run("send", "--id", str(number), "--body", body.hex(), "--dry-run")
        assert result.status == 2 and "--body holds a password" in result.error
        assert not shows_password(result.out, result.error)
    assert run("send", "--id", "86", "--body", "0000", "--dry-run").status == 0


def test_the_transparent_proxy_wants_a_word_more() -> None:
    with emulated_gimbal("--firmware", "2.74.5") as gimbal:
        to = ("send", "-p", gimbal.address, "--yes")
        for request in (["CMD_SET_TRANSP_PROXY", "port2=2"], ["--id", "143", "--body", "0002"]):
            refused = run(*to, *request)
            assert refused.status == 2 and "--no-way-back" in refused.error
        assert run(*to, "CMD_SET_TRANSP_PROXY", "port2=2", "--no-way-back").status == 0
    described = run("describe", "CMD_UDRV_DEVICE_SCAN")
    assert "It writes the memory of the board" in " ".join(described.text.split())


# The bridge


def test_a_bridge_takes_no_password_unless_it_is_allowed(
    protected: str, password_file: str
) -> None:
    gimbal = ("-p", protected, "--password-file", password_file)
    refused = run("bridge", *gimbal, "--tcp", "0", "--for", "5s")
    assert refused.status == 2 and "--allow-passwords agrees to that" in refused.error
    bridge = Bridge("--allow-passwords", *gimbal, "--tcp", "0")
    host = Host(bridge.address)
    assert host.ask(GET_ANGLES), "the port is open for all"
    host.close()
    bridge.stop()


def test_a_host_of_a_bridge_sends_no_password_unless_it_is_allowed(tmp_path: Path) -> None:
    capture = tmp_path / "capture"
    with emulated_gimbal("--firmware", "2.74.5") as gimbal:
        bridge = Bridge(gimbal.address, "--tcp", "0", "-v", "--capture", str(capture))
        host = Host(bridge.address)
        host.send(BOARD_INFO, OPENING)
        command, body = host.receive()
        assert (command, body[:2]) == (ERROR, bytes([BOARD_INFO, 8]))
        assert len(host.ask(BOARD_INFO, b"\x00\x00")) == 18
        lines = bridge.wait_for("--allow-passwords lets it pass")
        host.close()
        bridge.stop()
        assert not shows_password("".join(lines), capture.read_bytes())

        bridge = Bridge(gimbal.address, "--tcp", "0", "--allow-passwords", "-v")
        host = Host(bridge.address)
        assert len(host.ask(BOARD_INFO, OPENING)) == 18
        host.close()
        bridge.process.send_signal(signal.SIGINT)
        _, errors = bridge.process.communicate(timeout=20)
        assert "(hidden)" in errors and not shows_password(errors)


# Again


def test_it_is_sent_again_with_each_connection(tmp_path: Path) -> None:
    """A gimbal whose line ends after some time wants it again."""
    password = file_with(tmp_path, PASSWORD)
    server = socket.create_server(("127.0.0.1", 0))
    first: list[bytes] = []
    answer = frame(BOARD_INFO, bytes.fromhex("198709000200010000000000000000000000"))

    def serve() -> None:
        while len(first) < 2:
            line, _ = server.accept()
            data = line.recv(4096)
            first.append(data)
            line.sendall(answer)
            end = time.monotonic() + 0.5
            line.settimeout(0.05)
            while time.monotonic() < end:
                try:
                    line.recv(4096)
                    line.sendall(answer)
                except TimeoutError:
                    pass
            line.close()

    thread = threading.Thread(target=serve)
    thread.start()
    address = "tcp:127.0.0.1:%d" % server.getsockname()[1]
    options = ("-p", address, "--password-file", password)
    record = Running("record", *options, str(tmp_path / "capture"))
    thread.join(30)
    record.send_signal(signal.SIGINT)
    out, errors = record.communicate(timeout=20)
    assert first == [frame(BOARD_INFO, OPENING)] * 2
    assert "will hold the password: keep it private" in errors
    assert not shows_password(out, errors)
