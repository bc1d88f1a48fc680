"""sbgc emulate: where hosts connect, how it ends, what it keeps, what it refuses."""

from __future__ import annotations

import fcntl
import os
import pty
import random
import shutil
import signal
import socket
import subprocess
import termios
import time
from pathlib import Path

import pytest

from emulator import PATIENCE, Connection, Emulator, Terminal, terminal_of
from sbgc_command import PROGRAM, ROOT, frame, run

BOARD_INFO = 86
BOARD_INFO_3 = 20
READ_EXTERNAL_DATA = 42
WRITE_EXTERNAL_DATA = 41
CONFIRM = 67
DATA_STREAM_INTERVAL = 85
REALTIME_DATA_4 = 25


def stream(milliseconds: int) -> bytes:
    return bytes([REALTIME_DATA_4]) + milliseconds.to_bytes(2, "little") + bytes(18)


def refused(*arguments: str) -> str:
    """What it says when it can not begin."""
    result = run("emulate", *arguments)
    assert result.status == 1, result
    return result.error


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_pseudo_terminal_is_the_default(number: int) -> None:
    with Emulator() as emulator:
        (place,) = emulator.places
        assert place.startswith("/dev/pts/")
        terminal = Terminal(place)
        assert len(terminal.ask(BOARD_INFO)) == 18
        terminal.close()
        # Programs come and go.
        terminal = Terminal(place)
        assert len(terminal.ask(BOARD_INFO)) == 18
        assert emulator.end(number) == 0
        assert emulator.error == ""
        terminal.close()


def test_link(tmp_path: Path) -> None:
    link = tmp_path / "gimbal"
    with Emulator("--link", str(link)) as emulator:
        assert emulator.places[0].endswith(f"(also {link})")
        assert Path(os.readlink(link)) == terminal_of(emulator.places[0])
        terminal = Terminal(str(link))
        assert terminal.ask(BOARD_INFO)
        terminal.close()
    assert list(tmp_path.iterdir()) == []


def test_a_link_that_was_left_behind_is_replaced(tmp_path: Path) -> None:
    link = tmp_path / "gimbal"
    link.symlink_to("/dev/pts/999999")
    with Emulator("--link", str(link)) as emulator:
        assert Path(os.readlink(link)) == terminal_of(emulator.places[0])
    assert list(tmp_path.iterdir()) == []


def test_nothing_else_is_replaced_by_a_link(tmp_path: Path) -> None:
    taken = tmp_path / "gimbal"
    taken.write_text("mine")
    assert str(taken) in refused("--link", str(taken))
    assert taken.read_text() == "mine"

    elsewhere = tmp_path / "elsewhere"
    elsewhere.symlink_to(taken)
    assert str(taken) in refused("--link", str(elsewhere))
    assert Path(os.readlink(elsewhere)) == taken

    folder = tmp_path / "folder"
    folder.mkdir()
    refused("--link", str(folder))
    refused("--link", str(tmp_path / "missing" / "gimbal"))

    used = tmp_path / "used"
    with Emulator("--link", str(used)) as emulator:
        assert "in use" in refused("--link", str(used))
        assert Path(os.readlink(used)) == terminal_of(emulator.places[0])
        # Somebody else's link by now.
        used.unlink()
        used.symlink_to(taken)
    assert Path(os.readlink(used)) == taken


def test_tcp_has_several_hosts() -> None:
    with Emulator("--tcp", "0") as emulator:
        (place,) = emulator.places
        assert place.startswith("tcp:127.0.0.1:")
        hosts = [Connection(place) for _ in range(8)]
        for host in hosts:
            host.send(BOARD_INFO)
        for host in hosts:
            assert len(host.body(BOARD_INFO)) == 18
        # Streams belong to who asked for them.
        hosts[0].send(DATA_STREAM_INTERVAL, stream(20))
        hosts[0].body(REALTIME_DATA_4)
        hosts[1].heard = b""
        assert not hosts[1].receive(0.2)
        # There is no ninth, until one of them leaves.
        ninth = Connection(place)
        ninth.socket.settimeout(PATIENCE)
        assert ninth.socket.recv(1) == b""
        ninth.close()
        hosts[3].close()
        end = time.monotonic() + PATIENCE
        while True:
            another = Connection(place)
            another.send(BOARD_INFO)
            if another.receive(PATIENCE):
                break
            another.close()  # the port is kept for a moment
            assert time.monotonic() < end
            time.sleep(0.05)
        another.close()
        for host in hosts[:3] + hosts[4:]:
            host.close()
        emulator.end()
        assert "refused: all ports" in emulator.error


def test_tcp_hosts_that_vanish_are_noticed() -> None:
    with Emulator("--tcp", "0") as emulator:
        host = Connection(emulator.places[0])
        assert host.ask(BOARD_INFO)
        port = f":{int(emulator.places[0].rpartition(':')[2]):04X}"
        timers = []
        for line in Path("/proc/net/tcp").read_text(encoding="utf-8").splitlines()[1:]:
            _, here, _, state, _, timer, *_ = line.split()
            if here.endswith(port) and state == "01":
                timers.append(timer.split(":"))
        ((kind, ticks),) = timers
        assert kind == "02"  # it is asked for a sign of life
        assert int(ticks, 16) <= 10 * 100
        host.close()


def test_tcp_has_one_host_after_the_other() -> None:
    with Emulator("--tcp", "0") as emulator:
        for _ in range(40):
            host = Connection(emulator.places[0])
            assert host.ask(BOARD_INFO)
            host.close()
        emulator.end()
        assert emulator.error == ""


def test_tcp_host_that_sends_its_end_with_its_requests() -> None:
    with Emulator("--tcp", "0", "--baud", "9600") as emulator:
        host = Connection(emulator.places[0])
        for _ in range(20):
            host.send(BOARD_INFO_3)
        host.socket.shutdown(socket.SHUT_WR)
        while host.receive(PATIENCE):
            pass
        assert len(host.heard) == 20 * 74
        host.close()


def test_udp_has_several_hosts() -> None:
    with Emulator("--udp", "0") as emulator:
        (place,) = emulator.places
        assert place.startswith("udp:127.0.0.1:")
        hosts = [Connection(place), Connection(place)]
        for host in hosts:
            assert len(host.ask(BOARD_INFO)) == 18
        hosts[0].send(DATA_STREAM_INTERVAL, stream(20))
        hosts[0].body(REALTIME_DATA_4)
        hosts[1].heard = b""
        assert not hosts[1].receive(0.2)
        for host in hosts:
            host.close()


def test_udp_tells_once_of_a_host_that_is_refused() -> None:
    with Emulator("--udp", "0") as emulator:
        hosts = [Connection(emulator.places[0]) for _ in range(9)]
        for host in hosts[:8]:
            assert len(host.ask(BOARD_INFO)) == 18
        for _ in range(100):
            hosts[8].send(BOARD_INFO)
        assert hosts[0].ask(BOARD_INFO)  # behind all of them
        assert not hosts[8].receive(0)
        assert emulator.end() == 0
        assert emulator.error.count("refused") == 1
        for host in hosts:
            host.close()


def test_udp_carries_whole_answers_and_no_more_than_fits() -> None:
    with Emulator("--udp", "0") as emulator:
        host = Connection(emulator.places[0])
        host.send(BOARD_INFO_3)
        assert len(host.socket.recv(65536)) == 74
        for _ in range(10):  # there is not room for all
            host.socket.send(frame(BOARD_INFO) * 800)
        end = time.monotonic() + PATIENCE
        while bytes([0x3E, BOARD_INFO_3, 69]) not in host.heard and time.monotonic() < end:
            host.send(BOARD_INFO_3)  # its answer comes behind them
            host.receive(1)
        answers, rest = divmod(host.heard.count(bytes([0x3E, BOARD_INFO, 18])), 800)
        assert 1 <= answers < 10 and rest == 0
        host.close()


def test_udp_takes_a_large_datagram_when_nothing_waits() -> None:
    with Emulator("--udp", "0", "--baud", "57600", "--verbose") as emulator:
        host = Connection(emulator.places[0])
        host.socket.send(frame(BOARD_INFO) * 900)
        host.socket.send(frame(BOARD_INFO_3) * 900)  # there is no room while the first one waits
        while len(host.heard) < 900 * 23:
            assert host.receive(PATIENCE)
        assert not host.receive(0.2)
        host.close()
        emulator.end()
        assert emulator.rest.count("is lost") == 1


def test_standard_input_and_output(tmp_path: Path) -> None:
    done = subprocess.run(
        [PROGRAM, "emulate", "--stdio", "--verbose"],
        input=frame(BOARD_INFO) + frame(BOARD_INFO_3),
        capture_output=True,
        timeout=PATIENCE,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout[:2] == bytes([0x3E, BOARD_INFO])
    assert bytes([0x3E, BOARD_INFO_3, 69]) in done.stdout
    assert b"emulated gimbal 1: standard input and output" in done.stderr
    assert b"CMD_BOARD_INFO" in done.stderr

    # Regular files are as good.
    (tmp_path / "in").write_bytes(frame(BOARD_INFO))
    with open(tmp_path / "in", "rb") as source, open(tmp_path / "out", "wb") as sink:
        done = subprocess.run(
            [PROGRAM, "emulate", "--stdio"],
            stdin=source,
            stdout=sink,
            stderr=subprocess.PIPE,
            timeout=PATIENCE,
            check=False,
        )
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out").read_bytes()[:2] == bytes([0x3E, BOARD_INFO])


def test_standard_input_that_ends_before_the_answers() -> None:
    for line, number in ((["--baud", "9600"], 20), ([], 2000)):
        done = subprocess.run(
            [PROGRAM, "emulate", "--stdio", *line],
            input=frame(BOARD_INFO_3) * number,
            capture_output=True,
            timeout=PATIENCE,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        assert len(done.stdout) == 74 * number


@pytest.mark.parametrize("line", [["--baud", "9600"], ["--text", "0.001"], []])
def test_standard_input_that_asks_for_streams(line: list[str]) -> None:
    begin = time.monotonic()
    done = subprocess.run(
        [PROGRAM, "emulate", "--stdio", *line],
        input=frame(DATA_STREAM_INTERVAL, stream(1)) + frame(BOARD_INFO) * 20,
        capture_output=True,
        timeout=PATIENCE,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.count(bytes([0x3E, CONFIRM])) == 1
    assert done.stdout.count(bytes([0x3E, BOARD_INFO, 18])) == 20
    assert time.monotonic() - begin < PATIENCE / 2


def test_answers_that_nobody_takes() -> None:
    reader, out = os.pipe()
    fcntl.fcntl(reader, fcntl.F_SETPIPE_SZ, 4096)
    done = subprocess.run(
        [PROGRAM, "emulate", "--stdio"],
        input=frame(BOARD_INFO_3) * 1000,
        stdout=out,
        stderr=subprocess.PIPE,
        timeout=PATIENCE,
        check=False,
    )
    assert done.returncode == 1
    assert b"standard input and output: " in done.stderr
    os.close(reader)
    os.close(out)


def test_a_request_behind_what_only_looked_like_the_beginning_of_one() -> None:
    begun = b">" + bytes([BOARD_INFO, 200, (BOARD_INFO + 200) % 256])
    done = subprocess.run(
        [PROGRAM, "emulate", "--stdio"],
        input=begun + frame(BOARD_INFO),
        capture_output=True,
        timeout=PATIENCE,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout[:2] == bytes([0x3E, BOARD_INFO])


@pytest.mark.parametrize("closed", ["<&-", ">&-"])
def test_standard_files_that_are_closed(closed: str) -> None:
    done = subprocess.run(
        ["sh", "-c", f'exec "$0" emulate --stdio {closed}', PROGRAM],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        timeout=PATIENCE,
        check=False,
    )
    assert done.returncode == 1
    assert b"standard" in done.stderr


def test_nohup_is_respected() -> None:
    command = ["nohup", PROGRAM, "emulate", "--stdio"]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdin and process.stdout and process.stderr
        while b"emulated gimbal" not in process.stderr.readline():
            assert process.poll() is None
        process.send_signal(signal.SIGHUP)
        process.stdin.write(frame(BOARD_INFO))
        process.stdin.close()
        assert len(process.stdout.read()) == 23
        assert process.wait(PATIENCE) == 0


def test_many_boards(tmp_path: Path) -> None:
    link = tmp_path / "gimbal"
    arguments = ["--count", "3", "--tcp", "0", "--link", str(link), "--state", str(tmp_path / "s")]
    with Emulator(*arguments, boards=3, places=2) as emulator:
        names = sorted(path.name for path in tmp_path.iterdir() if path.suffix != ".sbgc-lock")
        assert names == ["gimbal-1", "gimbal-2", "gimbal-3", "s-1", "s-2", "s-3"]
        told = set()
        for place in emulator.places[1::2]:
            host = Connection(place)
            told.add(host.ask(BOARD_INFO_3)[:21])
            host.close()
        assert len(told) == 3
        for number, place in enumerate(emulator.places[::2]):
            assert Path(os.readlink(f"{link}-{number + 1}")) == terminal_of(place)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["s-1", "s-2", "s-3"]


def two_free_ports() -> int:
    """The first one. Below those that the system gives to other tests."""
    while True:
        port = random.randrange(10000, 30000)
        try:
            with socket.socket() as first, socket.socket() as second:
                first.bind(("127.0.0.1", port))
                second.bind(("127.0.0.1", port + 1))
                return port
        except OSError:
            pass


def test_ports_in_a_row() -> None:
    port = two_free_ports()
    with Emulator("--tcp", str(port), "--count", "2", boards=2) as emulator:
        assert emulator.places == [f"tcp:127.0.0.1:{port}", f"tcp:127.0.0.1:{port + 1}"]
        assert "can not listen" in refused("--tcp", str(port))


def test_state_survives(tmp_path: Path) -> None:
    state = tmp_path / "state"
    data = bytes(range(128))
    with Emulator("--tcp", "0", "--state", str(state)) as emulator:
        host = Connection(emulator.places[0])
        serial = host.ask(BOARD_INFO_3)[:21]
        # It is saved by itself, each time, so that even a killed one has it.
        for new in (data[1:] + data[:1], data):
            before = state.stat().st_mtime_ns
            host.send(WRITE_EXTERNAL_DATA, new)
            host.body(CONFIRM)
            end = time.monotonic() + PATIENCE
            while state.stat().st_mtime_ns == before and time.monotonic() < end:
                time.sleep(0.05)
        emulator.process.kill()
        emulator.wait()
        host.close()
    with Emulator("--tcp", "0", "--state", str(state)) as emulator:
        host = Connection(emulator.places[0])
        assert host.ask(READ_EXTERNAL_DATA) == data
        assert host.ask(BOARD_INFO_3)[:21] == serial
        # And what changes in the last moment.
        host.send(WRITE_EXTERNAL_DATA, data[::-1])
        host.body(CONFIRM)
        assert emulator.end() == 0
        host.close()
    with Emulator("--tcp", "0", "--state", str(state)) as emulator:
        host = Connection(emulator.places[0])
        assert host.ask(READ_EXTERNAL_DATA) == data[::-1]
        host.close()
    assert list(tmp_path.iterdir()) == [state]
    assert "firmware 2.59, not of" in refused("--state", str(state), "--firmware", "2.43b9")


def test_a_state_is_of_one_emulator_at_a_time(tmp_path: Path) -> None:
    state = tmp_path / "state"
    link = tmp_path / "link"
    link.symlink_to("state")
    with Emulator("--tcp", "0", "--state", str(link)):
        assert link.is_symlink() and state.is_file()
        for name in (state, link):
            assert f"{name} is the state of an emulator that runs" in refused("--state", str(name))
    with Emulator("--tcp", "0", "--state", str(state)):
        pass
    assert sorted(tmp_path.iterdir()) == [link, state]


def test_a_file_that_has_the_name_of_the_lock_is_left_alone(tmp_path: Path) -> None:
    state = tmp_path / "state"
    lock = tmp_path / "state.sbgc-lock"
    lock.write_text("mine")
    assert f"{lock} is somebody's file" in refused("--state", str(state))
    assert lock.read_text() == "mine"
    lock.unlink()
    lock.symlink_to("elsewhere")
    assert str(lock) in refused("--state", str(state))
    assert list(tmp_path.iterdir()) == [lock]
    lock.unlink()
    lock.touch()  # left behind by an emulator that was killed
    with Emulator("--tcp", "0", "--state", str(state)):
        lock.unlink()
        lock.write_text("mine")  # by now
    assert lock.read_text() == "mine"


def test_a_state_keeps_its_mode(tmp_path: Path) -> None:
    state = tmp_path / "state"
    for mode in (0o644, 0o600, 0o660):
        with Emulator("--tcp", "0", "--state", str(state)):
            state.chmod(mode)
        with Emulator("--tcp", "0", "--state", str(state)):  # which is written at once
            pass
        assert state.stat().st_mode & 0o7777 == mode


def test_a_state_that_can_not_be_used(tmp_path: Path) -> None:
    damaged = tmp_path / "damaged"
    damaged.write_text("{}")
    assert str(damaged) in refused("--state", str(damaged))
    assert damaged.read_text() == "{}"
    refused("--state", str(tmp_path))
    refused("--state", str(tmp_path / "missing" / "state"))


def test_a_state_that_can_not_be_saved_any_more(tmp_path: Path) -> None:
    folder = tmp_path / "folder"
    folder.mkdir()
    with Emulator("--tcp", "0", "--state", str(folder / "state")) as emulator:
        folder.rename(tmp_path / "elsewhere")
        host = Connection(emulator.places[0])
        host.send(WRITE_EXTERNAL_DATA, bytes(range(128)))
        host.body(CONFIRM)
        assert emulator.process.stderr is not None
        assert b"cannot write" in emulator.process.stderr.readline()
        assert host.ask(BOARD_INFO)
        host.close()
        assert emulator.end() == 1
        assert emulator.error.count("cannot write") == 1  # it is tried again at the end
        assert "not everything could be saved" in emulator.error


def test_board_and_firmware(tmp_path: Path) -> None:
    state = ["--state", str(tmp_path / "state")]
    # The state knows which board it is of.
    for model in (["--firmware", "2.43b9", "--board", "3.1"], []):
        with Emulator("--tcp", "0", *state, *model) as emulator:
            host = Connection(emulator.places[0])
            info = host.ask(BOARD_INFO)
            assert info[0] == 31
            assert int.from_bytes(info[1:3], "little") == 2439
            host.close()
    # What is given must be right, and nothing else.
    for model in (["--firmware", "2.43b9"], ["--board", "3.1"]):
        with Emulator("--tcp", "0", *state, *model):
            pass
    for model in (
        ["--firmware", "2.59"],
        ["--board", "3.0"],
        ["--firmware", "2.59", "--board", "3.1"],
    ):
        assert "firmware 2.43b9, not of" in refused(*state, *model)


def test_wrong_baud_rate_is_garbage() -> None:
    with Emulator("--baud", "115200") as emulator:
        terminal = Terminal(emulator.places[0], termios.B57600)
        for _ in range(3):
            terminal.send(BOARD_INFO)
            time.sleep(0.1)
        terminal.receive(0.2)
        assert bytes([0x3E, BOARD_INFO, 18]) not in terminal.heard
        terminal.set_rate(termios.B115200)
        assert len(terminal.ask(BOARD_INFO)) == 18
        terminal.close()


def test_baud_rate_takes_its_time() -> None:
    with Emulator("--tcp", "0", "--baud", "9600") as emulator:
        host = Connection(emulator.places[0])
        begin = time.monotonic()
        for _ in range(10):
            host.ask(BOARD_INFO_3)
        # 5 bytes there, 74 back.
        assert time.monotonic() - begin > 10 * 79 / 960 * 0.95
        host.close()


def test_faults() -> None:
    for fault in (["--lose", "100%"], ["--silence", "0:1000"]):
        with Emulator("--tcp", "0", *fault) as emulator:
            host = Connection(emulator.places[0])
            host.send(BOARD_INFO)
            assert not host.receive(0.3)
            host.close()
    with Emulator("--tcp", "0", "--text", "0.05", "--silence", "0:0.2") as emulator:
        host = Connection(emulator.places[0])
        end = time.monotonic() + PATIENCE
        while b"\r\n" not in host.heard and time.monotonic() < end:
            host.receive(1)
        assert b"\r\n" in host.heard
        host.close()


def test_a_reset_at_a_given_time() -> None:
    with Emulator("--tcp", "0", "--reset-at", "2", "--verbose") as emulator:
        host = Connection(emulator.places[0])
        host.send(DATA_STREAM_INTERVAL, stream(20))
        host.body(REALTIME_DATA_4)
        # Streams end with a reset.
        end = time.monotonic() + PATIENCE
        while host.receive(0.4):
            assert time.monotonic() < end
        host.close()


def test_a_host_that_does_not_read() -> None:
    with Emulator("--tcp", "0") as emulator:
        host = Connection(emulator.places[0])
        host.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        for _ in range(20):
            host.send(DATA_STREAM_INTERVAL, stream(1))
        other = Connection(emulator.places[0])
        for _ in range(10):
            assert other.ask(BOARD_INFO)
            time.sleep(0.05)
        other.close()
        host.close()


def test_every_frame_as_a_line() -> None:
    with Emulator("--tcp", "0", "--verbose") as emulator:
        host = Connection(emulator.places[0])
        host.ask(BOARD_INFO)
        host.send(200)
        host.ask(BOARD_INFO)
        host.close()
        emulator.end()
        request = emulator.rest.index("> CMD_BOARD_INFO (86), 0 bytes  carried out")
        assert request < emulator.rest.index("< CMD_BOARD_INFO (86), 18 bytes")
        assert "> unknown command (200), 0 bytes  unknown here" in emulator.rest
        assert "is host 0" in emulator.rest


def test_ends_by_itself() -> None:
    begin = time.monotonic()
    with Emulator("--seconds", "0.3") as emulator:
        assert emulator.wait() == 0
    assert time.monotonic() - begin >= 0.3


def test_other_machines_only_when_told() -> None:
    with Emulator("--tcp", "0.0.0.0:0") as emulator:
        emulator.end()
        assert "other machines" in emulator.error
    with Emulator("--tcp", "localhost:0") as emulator:
        emulator.end()
        assert emulator.error == ""


def test_a_reader_of_its_output_that_goes_away(tmp_path: Path) -> None:
    link = tmp_path / "gimbal"
    with Emulator("--link", str(link), "--verbose") as emulator:
        assert emulator.process.stdout is not None
        emulator.process.stdout.close()
        emulator.process.stdout = None
        terminal = Terminal(str(link))
        for _ in range(5):
            assert terminal.ask(BOARD_INFO)
        terminal.close()
        emulator.process.send_signal(signal.SIGTERM)
        assert emulator.process.wait(PATIENCE) == 0
        assert emulator.process.stderr is not None
        emulator.process.stderr.close()
    assert not link.is_symlink()


def ask_often(host: Connection, times: int) -> None:
    """More frames than a reader's pipe or terminal holds as lines, all of them answered."""
    host.heard = b""
    os.write(host.fd, frame(BOARD_INFO) * times)
    while len(host.heard) < 23 * times:
        assert host.receive(PATIENCE)


@pytest.mark.parametrize("kind", ["pipe", "terminal"])
def test_a_reader_of_its_output_that_stalls(kind: str) -> None:
    reader, out = os.pipe() if kind == "pipe" else pty.openpty()
    process = subprocess.Popen(
        [PROGRAM, "emulate", "--tcp", "0", "--verbose"], stdout=out, stderr=subprocess.PIPE
    )
    try:
        place = os.read(reader, 4096).decode().strip().partition(": ")[2]
        host = Connection(place)
        ask_often(host, 1000)
        ask_often(host, 1000)
        # What could not be told is told of when there is room again.
        lines = os.read(reader, 65536)
        end = time.monotonic() + PATIENCE
        while b"lines were left out" not in lines:
            assert time.monotonic() < end
            host.ask(BOARD_INFO)
            lines += os.read(reader, 65536)
        for line in lines.splitlines()[:-1]:
            assert b" CMD_BOARD_INFO (86), " in line or b"left out" in line or b"is host" in line
        # And nobody has to read for it to end.
        ask_often(host, 1000)
        process.terminate()
        assert process.wait(PATIENCE) == 0
        assert process.stderr is not None and process.stderr.read() == b""
        host.close()
    finally:
        process.kill()
        process.communicate()
        os.close(reader)
        os.close(out)


def test_a_reader_of_its_warnings_that_stalls() -> None:
    with Emulator("--tcp", "0") as emulator:
        assert emulator.process.stderr is not None
        fcntl.fcntl(emulator.process.stderr, fcntl.F_SETPIPE_SZ, 4096)
        hosts = [Connection(emulator.places[0]) for _ in range(8)]
        for host in hosts:
            assert host.ask(BOARD_INFO)
        for _ in range(100):
            refusal = Connection(emulator.places[0])
            refusal.socket.settimeout(PATIENCE)
            assert refusal.socket.recv(1) == b""
            refusal.close()
        assert hosts[0].ask(BOARD_INFO)
        emulator.process.terminate()
        assert emulator.process.wait(PATIENCE) == 0
        for host in hosts:
            host.close()


def test_warnings_that_can_not_be_written() -> None:
    with open("/dev/full", "w", encoding="utf-8") as full:
        process = subprocess.Popen(
            [PROGRAM, "emulate", "--tcp", "0"], stdout=subprocess.PIPE, stderr=full
        )
    assert process.stdout is not None
    place = process.stdout.readline().decode().strip().partition(": ")[2]
    hosts = [Connection(place) for _ in range(9)]
    for host in hosts[:8]:
        assert host.ask(BOARD_INFO)
    assert hosts[8].socket.recv(1) == b""  # refused, which is worth a warning
    assert hosts[0].ask(BOARD_INFO)
    for host in hosts:
        host.close()
    process.terminate()
    assert process.wait(PATIENCE) == 0
    process.stdout.close()


def test_a_host_that_floods() -> None:
    with Emulator("--tcp", "0") as emulator:
        host = Connection(emulator.places[0])
        host.socket.settimeout(0.5)
        requests = frame(BOARD_INFO) * 10000
        with pytest.raises(TimeoutError):  # it is held up
            for _ in range(1000):
                host.socket.sendall(requests)
        other = Connection(emulator.places[0])
        assert other.ask(BOARD_INFO)
        status = Path(f"/proc/{emulator.process.pid}/status").read_text(encoding="utf-8")
        (size,) = (int(line.split()[1]) for line in status.splitlines() if line.startswith("VmRSS"))
        assert size < 500_000  # KiB; sanitizers need some
        other.close()
        host.close()


@pytest.mark.parametrize(
    "arguments",
    [
        ["place"],
        ["--tcp"],
        ["--tcp", "65536"],
        ["--tcp", ":5000"],
        ["--tcp", "gimbal.example:5000"],
        ["--udp", "x"],
        ["--tcp", "65535", "--count", "2"],
        ["--count", "0"],
        ["--count", "-1"],
        ["--stdio", "--count", "2"],
        ["--firmware", "2.5"],
        ["--board", "three"],
        ["--baud", "0"],
        ["--baud", "fast"],
        ["--parity", "odd"],
        ["--lose", "1.5"],
        ["--bit-errors", "101%"],
        ["--delay", "0.1:x"],
        ["--text", "-1"],
        ["--text", "0"],
        ["--text", "0.0009"],
        ["--silence", "5"],
        ["--reset-at", "soon"],
        ["--input-buffer", "-1"],
        ["--seed", "-1"],
        ["--seconds", "nan"],
        ["--motion", "jump"],
        ["--link", ""],
        ["--state", ""],
    ],
)
def test_wrong_usage(arguments: list[str]) -> None:
    result = run("emulate", *arguments)
    assert result.status == 2, result
    assert result.out == b""


def test_motion_files(tmp_path: Path) -> None:
    motion = tmp_path / "motion.csv"
    motion.write_text("time,roll,pitch,yaw\n0,0,0,0\n1,10,0,0\n2,0,zero,0\n")
    result = run("emulate", "--motion", str(motion))
    assert result.status == 2
    assert f"{motion}:4: 'zero' is not a number" in result.error
    motion.write_text("0,0,0,0\n1,10,0,0\n2,0,0,0\n")
    with Emulator("--motion", str(motion)):
        pass


def test_help() -> None:
    result = run("emulate", "--help")
    assert result.status == 0
    for option in ("--pty", "--tcp", "--udp", "--stdio", "--state", "--silence", "Examples"):
        assert option in result.text


def test_one_demo_at_a_time(tmp_path: Path) -> None:
    shutil.copy(ROOT / "dev", tmp_path)
    (tmp_path / "build").mkdir()
    with open(tmp_path / "build" / "demo.lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        done = subprocess.run(
            [tmp_path / "dev", "demo"], capture_output=True, timeout=PATIENCE, check=False
        )
    assert done.returncode == 1
    assert b"another one is running" in done.stderr


def test_the_tour(tmp_path: Path) -> None:
    """What ./dev demo does."""
    tour = os.environ.get("SBGC_TOUR")
    if not tour:
        pytest.skip("examples are not built")
    with Emulator("--baud", "57600", "--motion", "handheld", "--text", "1") as emulator:
        done = subprocess.run(
            [tour, emulator.places[0], str(tmp_path / "capture"), str(tmp_path / "backup")],
            capture_output=True,
            timeout=60,
            check=False,
        )
    assert done.returncode == 0, done.stderr
    assert b"57600" in done.stdout
    assert b"pitch is -30" in done.stdout or b"pitch is -29" in done.stdout
