"""The blocking client, with an emulated board."""

from __future__ import annotations

import gc
import inspect
import logging
import os
import signal
import subprocess
import sys
import threading
import time
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

import sbgc
from conftest import is_still
from sbgc import Board, Gimbal, GimbalDisconnected, GimbalError, GimbalTimeout, _core, msg, search


def test_a_call_returns_the_response(gimbal: Gimbal) -> None:
    angles = gimbal.call(msg.GetAnglesRequest())
    assert isinstance(angles, msg.GetAngles)
    assert gimbal.identity.firmware == "2.59"
    assert gimbal.identity.info.board_ver == 30


def test_what_people_look_for_first_has_a_name(board: Board, gimbal: Gimbal) -> None:
    gimbal.move_to(pitch=10, speed=30)
    assert gimbal.angles().pitch == pytest.approx(board.angles.pitch, abs=0.6)
    assert gimbal.firmware == "2.59" and 5 < gimbal.battery_voltage() < 60
    gimbal.motors_off()
    gimbal.motors_on()
    for wrong, right in (
        ("get_angles", "it has angles"),
        ("mov_to", "it has move_to"),
        ("beep_sound", r"there is the request call\(msg.BeepSound\(\)\)"),
    ):
        with pytest.raises(AttributeError, match=f"no attribute '{wrong}'; {right}"):
            getattr(gimbal, wrong)
    assert repr(gimbal) == "<sbgc.client.Gimbal of memory link>"
    assert repr(board) == "<sbgc.Board, emulated in real time>"


def test_connections_are_logged(board: Board, caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.INFO, "sbgc")
    with sbgc.connect(board, reconnect=True) as gimbal:
        board.unplug()
        with suppress(GimbalDisconnected):
            gimbal.call(msg.GetAnglesRequest(), timeout=1)
        gimbal.wait_until_connected(timeout=20)
        end = time.monotonic() + 20
        while caplog.text.count("INFO") < 2 and time.monotonic() < end:
            with suppress(GimbalDisconnected):  # the loss may be noticed only now
                gimbal.angles()  # what has happened meanwhile is logged with the next call
    text = caplog.text
    assert text.index("connected: memory link") < text.index("lost: ") < text.rindex("connected: ")


def test_retries_are_logged(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.INFO, "sbgc")
    with sbgc.emulator(lost=0.02, virtual_time=True) as board, sbgc.connect(board) as gimbal:
        for _ in range(50):
            with suppress(GimbalTimeout):
                gimbal.call(msg.GetAnglesRequest())
    assert "retried: a request without an answer was sent again" in caplog.text


def test_move_to_arrives_and_reports_its_progress(board: Board, gimbal: Gimbal) -> None:
    seen: list[sbgc.Move] = []
    moved = gimbal.move_to(pitch=10, speed=30, progress=seen.append)
    assert moved.is_close
    assert board.angles.pitch == pytest.approx(10, abs=0.6)
    assert seen and seen[-1].angles.pitch > seen[0].angles.pitch - 1


def test_arguments_out_of_range_are_errors_with_field_value_and_limit(gimbal: Gimbal) -> None:
    with pytest.raises(sbgc.FieldError, match="pitch: 1000.* does not fit: -720.* to 719.*deg"):
        gimbal.move_to(pitch=1000)
    with pytest.raises(sbgc.FieldError, match="speed: 0.05 deg/s is too small; the least is 0.12"):
        gimbal.move_to(pitch=20, speed=0.05)
    with pytest.raises(sbgc.FieldError, match="yaw: -0.05 deg/s is too small"):
        gimbal.turn(yaw=-0.05, seconds=1)
    with pytest.raises(TypeError, match="pitch: a number is needed, not 'up'"):
        gimbal.move_to(pitch="up")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="timeout"):
        gimbal.move_to(pitch=1, timeout=-1)
    with pytest.raises(ValueError, match="seconds: -1 is no time"):
        gimbal.turn(yaw=20, seconds=-1)
    sound = msg.BeepSound()
    sound.assign("decay_factor", "16", validates=False)
    with pytest.raises(GimbalError, match="decay_factor: 16 is above 15"):
        gimbal.call(sound)


def test_what_is_something_else_is_an_error(gimbal: Gimbal) -> None:
    wrong: Any = msg.AxisState()  # a part of a message
    with pytest.raises(GimbalError, match="no-such-port"):
        sbgc.connect(Path("/dev/no-such-port"))
    with pytest.raises(TypeError, match="places: a list of addresses or boards is needed"):
        sbgc.find("/dev/ttyUSB0")
    with pytest.raises(TypeError, match="retries: an integer is needed, not 1.5"):
        gimbal.call(msg.MotorsOn(), retries=1.5)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="dry_run: True or False is needed, not 'no'"):
        gimbal.restore("", dry_run="no")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="capture: the name of a file is needed, not 5"):
        sbgc.connect("/dev/no-such-port", capture=5)  # type: ignore[arg-type]
    for place in (None, 5, b"tcp:localhost:1"):
        with pytest.raises(TypeError, match="place: an address or an emulated board is needed"):
            sbgc.connect(place)  # type: ignore[arg-type]
    with pytest.raises(TypeError):
        _core.Link().connect(None, 1.0, None, False)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="a message is needed, not AxisState"):
        gimbal.call(wrong)
    with pytest.raises(TypeError, match="message: the class of a message is needed, not AxisState"):
        gimbal.stream(wrong, 0.1)
    with pytest.raises(TypeError, match="timeout: a number is needed, not 'soon'"):
        gimbal.stop(timeout="soon")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="values: a dict of names and numbers is needed"):
        gimbal.set_variables(["pid_gain_roll"])  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="address: a number is needed, not 'a'"):
        gimbal.read_eeprom("a", 1)  # type: ignore[arg-type]
    with gimbal.speed_control() as control:
        with pytest.raises(TypeError, match="yaw: a number is needed, not AxisState"):
            control.set(yaw=wrong)


def test_an_exception_stops_a_move(board: Board, gimbal: Gimbal) -> None:
    def fail(move: sbgc.Move) -> None:
        if abs(move.angles.pitch) > 2:
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        gimbal.move_to(pitch=80, speed=20, progress=fail)
    assert is_still(board)
    assert 1 < abs(board.angles.pitch) < 30


def test_ctrl_c_stops_a_move_within_a_second(board: Board, gimbal: Gimbal) -> None:
    def interrupt() -> None:
        while board.angles.pitch < 3:
            time.sleep(0.01)
        interrupted.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    interrupted: list[float] = []
    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        gimbal.move_to(pitch=80, speed=20)
    assert time.monotonic() - interrupted[0] < 3  # of 4 that the move takes
    assert is_still(board)
    thread.join()


def test_a_speed_is_held_and_ends_with_the_block(board: Board, gimbal: Gimbal) -> None:
    with pytest.raises(ZeroDivisionError), gimbal.speed_control() as control:
        control.set(yaw=20)
        while abs(board.speeds.yaw) < 15:
            time.sleep(0.02)
            control.refresh()
        raise ZeroDivisionError
    assert is_still(board)


def test_a_speed_ends_if_its_owner_is_silent(board: Board, gimbal: Gimbal) -> None:
    with pytest.warns(RuntimeWarning, match="was called for 200 ms"):
        with gimbal.speed_control(silence=0.2) as control:
            control.set(yaw=20)
            time.sleep(1.0)
            assert is_still(board)
            with pytest.raises(GimbalError, match="the camera has been stopped"):
                control.refresh()


def test_closing_stops_a_move_of_another_thread(board: Board, gimbal: Gimbal) -> None:
    errors: list[BaseException] = []

    def move() -> None:
        try:
            gimbal.move_to(pitch=80, speed=20)
        except GimbalError as error:
            errors.append(error)

    thread = threading.Thread(target=move)
    thread.start()
    while board.angles.pitch < 3:
        time.sleep(0.01)
    gimbal.close()
    assert is_still(board)
    thread.join()
    assert [type(error) for error in errors] == [GimbalDisconnected]
    with pytest.raises(GimbalDisconnected):
        gimbal.call(msg.GetAnglesRequest())


def test_ctrl_c_ends_the_wait_for_a_calibration_within_a_second(gimbal: Gimbal) -> None:
    begin = time.monotonic()
    threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        gimbal.calibrate(msg.CalibPoles())
    assert time.monotonic() - begin < 5  # of 10 that it takes
    assert gimbal.call(msg.GetAnglesRequest())


@pytest.mark.parametrize("motion", ["gimbal.move_to(pitch=80, speed=20)", "turn()"])
def test_the_end_of_the_interpreter_stops_the_camera(motion: str) -> None:
    script = f"""
import threading, time
import sbgc

class Telling(sbgc.Gimbal):
    def close(self):
        super().close()
        # The camera brakes; if nothing had told it to, it would turn for half a second.
        until = time.monotonic() + 0.3
        while max(map(abs, board.speeds)) >= 2 and time.monotonic() < until:
            time.sleep(0.01)
        print(max(map(abs, board.speeds)) < 2, flush=True)

def turn():
    with gimbal.speed_control() as control:
        while True:
            control.set(pitch=20)
            time.sleep(0.1)

board = sbgc.emulator(noise=0)
gimbal = sbgc.connect(board)
gimbal.__class__ = Telling
gimbal.call(sbgc.msg.MotorsOn())
threading.Thread(target=lambda: {motion}, daemon=True).start()
while board.angles.pitch < 3:
    time.sleep(0.01)
"""
    assert output_of(script) == "True\n"


def test_the_end_of_the_interpreter_while_another_thread_turns_is_no_crash() -> None:
    script = """
import threading, time
import sbgc

def turn():
    with gimbal.speed_control() as control:
        while True:
            control.set(pitch=20)
            time.sleep(0.01)

board = sbgc.emulator(noise=0)
gimbal = sbgc.connect(board)
gimbal.call(sbgc.msg.MotorsOn())
threading.Thread(target=turn, daemon=True).start()
while board.angles.pitch < 1:
    time.sleep(0.01)
"""
    for _ in range(5):
        assert output_of(script) == ""


def test_the_end_of_the_interpreter_does_not_wait_for_a_calibration() -> None:
    script = """
import threading, time
import sbgc

board = sbgc.emulator(noise=0)
gimbal = sbgc.connect(board)
threading.Thread(target=gimbal.calibrate, args=[sbgc.msg.CalibPoles()], daemon=True).start()
time.sleep(0.3)
"""
    begin = time.monotonic()
    assert output_of(script) == ""
    assert time.monotonic() - begin < 8  # of 10 that it takes


def output_of(script: str) -> str:
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, timeout=30, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_streams_are_iterators_of_samples(gimbal: Gimbal) -> None:
    with gimbal.stream(msg.RealtimeData4, 0.02) as samples:
        taken = [next(samples) for _ in range(20)]
    assert all(isinstance(sample, msg.RealtimeData4) for sample in taken)
    assert samples.missed == 0
    assert list(samples) == []
    with pytest.raises(ValueError, match="no stream of GetAngles"):
        gimbal.stream(msg.GetAngles, 0.02)


def test_a_stream_raises_when_the_line_is_lost(board: Board, gimbal: Gimbal) -> None:
    with gimbal.stream(msg.RealtimeData4, 0.02, timeout=0.5) as samples:
        next(samples)
        board.unplug()
        with pytest.raises((GimbalDisconnected, TimeoutError)):
            for _ in samples:
                pass


def test_a_lost_line_is_a_connection_error(board: Board, gimbal: Gimbal) -> None:
    board.unplug()
    with pytest.raises(ConnectionError):
        for _ in range(100):
            gimbal.call(msg.GetAnglesRequest())
            time.sleep(0.01)


def test_a_move_whose_line_is_lost_does_not_say_that_the_client_is_closed(board: Board) -> None:
    with sbgc.connect(board, reconnect=True) as gimbal:
        with pytest.raises(GimbalDisconnected, match="stopping it failed: the connection is lost"):
            gimbal.move_to(pitch=60, speed=20, progress=lambda _: board.unplug())


def test_no_board_is_an_error_in_time() -> None:
    begin = time.monotonic()
    with sbgc.emulator(lost=1.0) as silent, pytest.raises(GimbalError, match="received nothing"):
        sbgc.connect(silent, timeout=1.0)
    assert time.monotonic() - begin < 10  # of 20 that it takes by default
    with pytest.raises(GimbalError, match="no-such-port"):
        sbgc.connect("/dev/no-such-port")


def test_parameters_are_written_once_at_the_end(gimbal: Gimbal) -> None:
    with gimbal.edit_profile(2) as profile:
        before = profile["pitch.p"]
        profile["pitch.p"] = 20
        assert gimbal.read_profile(2)["pitch.p"] == before
    assert gimbal.read_profile(2)["pitch.p"] == 20
    assert gimbal.read_profile(1)["pitch.p"] == before
    read = gimbal.read_profile(2)
    assert "pitch.p" in read and "pitch.q" not in read and dict(read)["axes.pitch.p"] == 20
    assert len(list(read)) == len(set(read)) == len(read) > 100
    with gimbal.edit_profile(2) as profile:
        profile["follow_mode"] = "FOLLOW_MODE_FC"
    assert gimbal.read_profile(2)["follow_mode"] == "FOLLOW_MODE_FC"
    with pytest.raises(ZeroDivisionError), gimbal.edit_profile(2) as profile:
        profile["pitch.p"] = 21
        raise ZeroDivisionError
    assert gimbal.read_profile(2)["pitch.p"] == 20


def test_wrong_parameters_are_errors(gimbal: Gimbal) -> None:
    with gimbal.edit_profile(1) as profile:
        with pytest.raises(KeyError, match="no parameter of this board is called 'pitch.q'"):
            profile["pitch.q"] = 1
        with pytest.raises(KeyError, match="several parameters"):
            profile["p"]
        with pytest.raises(sbgc.FieldError, match="300 does not fit"):
            profile["pitch.p"] = 300
        with pytest.raises(TypeError):
            profile["pitch.p"] = [1]
    with pytest.raises(ValueError, match="profile: 1 to 5"):
        gimbal.read_profile(0)


def test_variables_have_names_and_units(gimbal: Gimbal) -> None:
    gimbal.set_variables({"LPF_FREQ_ROLL": 120, "P_PITCH": 17})
    assert gimbal.get_variables("LPF_FREQ_ROLL", "P_PITCH") == [120, 17]
    with pytest.raises(ValueError, match="SHAKE_AMP_ROLL: 3.5 is not an integer"):
        gimbal.set_variables({"SHAKE_AMP_ROLL": 3.5})
    with pytest.raises(ValueError, match="120.5 Hz is between two values, which are 1 Hz apart"):
        gimbal.set_variables({"LPF_FREQ_ROLL": 120.5})
    gimbal.save_variables()
    assert gimbal.read_profile(gimbal.active_profile())["pitch.p"] == 17
    with pytest.raises(GimbalError, match="LPF_FREQ_ROLL"):
        gimbal.get_variable("LPF_FREQ_ROL")


def test_a_backup_is_restored(gimbal: Gimbal, tmp_path: Path) -> None:
    backup = gimbal.backup()
    with gimbal.edit_profile(3) as profile:
        profile["yaw.d"] = 33
    assert "axes.yaw.d" in sbgc.diff(backup, gimbal.backup())
    gimbal.restore(backup, tmp_path / "before.json")
    assert sbgc.diff(backup, gimbal.backup()) == ""
    assert "33" in sbgc.diff(backup, (tmp_path / "before.json").read_text())


def test_integers_out_of_range_name_the_argument_and_its_limits(gimbal: Gimbal) -> None:
    with pytest.raises(ValueError, match="file: 0 to 65535 are possible, not 65536"):
        gimbal.read_file(65536)
    with pytest.raises(ValueError, match="file: 0 to 65535 are possible, not -1"):
        gimbal.delete_file(-1)
    with pytest.raises(ValueError, match="address: 0 to 4294967295 are possible, not -1"):
        gimbal.read_eeprom(-1, 1)
    with pytest.raises(ValueError, match="offset: 0 to 4294967295 are possible, not -1"):
        gimbal.write_user_data(-1, b"")


def test_parameters_are_set_only_where_they_are_written(gimbal: Gimbal) -> None:
    with gimbal.edit_profile(2) as profile:
        before = profile["pitch.p"]
    for late in (profile, gimbal.read_profile(2)):
        with pytest.raises(RuntimeError, match=r"only in a block of edit_profile\(\)"):
            late["pitch.p"] = 20
        assert late["pitch.p"] == before


def test_files_are_written_and_read(gimbal: Gimbal) -> None:
    gimbal.write_file(0x0100, b"hello" * 100)
    assert gimbal.read_file(0x0100) == b"hello" * 100
    gimbal.delete_file(0x0100)
    with pytest.raises(GimbalError):
        gimbal.read_file(0x0100)
    assert len(gimbal.read_eeprom(64, 100)) == 100


def test_the_eeprom_is_written_only_by_those_who_know_what_they_do(gimbal: Gimbal) -> None:
    whole = gimbal.read_eeprom()
    with pytest.raises(ValueError, match="5 bytes .* address 70 on.* Pass yes=True"):
        gimbal.write_eeprom(70, b"hello")
    with pytest.raises(ValueError, match="do not fit: the EEPROM has 2 from"):
        gimbal.write_eeprom(len(whole) - 2, b"hello", yes=True)
    with pytest.raises(ValueError, match="address: -1 is not in the EEPROM"):
        gimbal.read_eeprom(-1)
    assert gimbal.read_eeprom(0, len(whole)) == whole
    seen: list[object] = []
    place = len(whole) - 70
    gimbal.write_eeprom(place, b"hello", yes=True, progress=lambda *found: seen.append(found))
    assert gimbal.read_eeprom(place, 5) == b"hello" and seen


def test_user_data_and_names_of_profiles_are_written_and_read(gimbal: Gimbal) -> None:
    gimbal.write_user_data(3, b"abc")
    assert gimbal.read_user_data()[2:7] == b"\xffabc\xff"
    gimbal.rename_profile(2, "Größe")
    names = gimbal.profile_names()
    assert names[1] == "Größe"
    gimbal.rename_profiles(names[::-1])
    assert gimbal.profile_names() == names[::-1]
    with pytest.raises(ValueError, match="names: 5 are needed, not 1"):
        gimbal.rename_profiles(["one"])
    with pytest.raises(TypeError, match="names: a list of texts is needed, not 'abcde'"):
        gimbal.rename_profiles("abcde")


def test_scripts_are_started_and_stopped(gimbal: Gimbal) -> None:
    empty = gimbal.scripts.index(0) + 1
    with pytest.raises(GimbalError, match=f"there is no script in slot {empty}"):
        gimbal.run_script(empty)
    with pytest.raises(ValueError, match="slot: 1 to 255"):
        gimbal.run_script(0)
    gimbal.stop_script(empty)


def test_a_calibration_reports_its_progress_and_its_end(gimbal: Gimbal) -> None:
    seen: list[sbgc.Calibration] = []
    assert gimbal.calibrate(msg.CalibGyro(), progress=seen.append) == "finished"
    last = seen[-1]
    assert last.has_started and last.state is not None and last.elapsed > 1
    with pytest.raises(GimbalError, match="MotorsOn is no calibration"):
        gimbal.calibrate(msg.MotorsOn())
    with pytest.raises(sbgc.GimbalTimeout):
        gimbal.calibrate(msg.CalibAcc(), timeout=0.2)


def test_every_call_has_a_timeout(gimbal: Gimbal) -> None:
    for name, method in vars(Gimbal).items():
        if not name.startswith("_") and name not in ("close", "speed_control", "turn"):
            assert "timeout" in inspect.signature(method).parameters, name
    with sbgc.emulator(baud_rate=9600) as slow, sbgc.connect(slow) as other:
        with pytest.raises(TimeoutError, match="it took more than 0.1 s"):
            other.profile_names(timeout=0.1)
    with pytest.raises(ValueError, match="timeout: -1"):
        gimbal.stop(timeout=-1)


def test_a_lost_line_is_found_again_and_streams_go_on(board: Board) -> None:
    with sbgc.connect(board, reconnect=True) as gimbal:
        with gimbal.stream(msg.RealtimeData4, 0.02, timeout=10) as samples:
            next(samples)
            board.unplug()
            with pytest.raises(GimbalDisconnected, match="no connection to the board|closed"):
                while True:
                    gimbal.call(msg.GetAnglesRequest())
            assert gimbal.identity.firmware == "2.59"
            until = time.monotonic() + 10
            while time.monotonic() < until:
                gimbal.wait_until_connected(timeout=10)
                # The call may have noticed the loss first.
                with suppress(GimbalDisconnected):
                    assert gimbal.call(msg.GetAnglesRequest())
                    break
            missed = samples.missed
            for _ in range(20):
                next(samples)
            assert samples.missed == missed
        assert gimbal.read_profile(1)["pitch.p"]
    with pytest.raises(GimbalDisconnected):
        gimbal.wait_until_connected()
    with pytest.raises(GimbalError, match="no-such-port"):
        sbgc.connect("/dev/no-such-port", reconnect=True)


def test_the_search_finds_the_gimbals_that_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    assert isinstance(sbgc.ports(), list)
    with sbgc.emulator(noise=0) as board, sbgc.emulator(lost=1.0) as silent:
        (found,) = sbgc.find([silent, "/dev/no-such-port", board], timeout=0.5)
        assert found.place is board and found.identity.firmware == "2.59"
    usb = (0x0403, 0x6001, "FTDI", "", "A1")
    listed = [("/dev/ttyS0", "built in", None), ("/dev/no-such-port", "", usb)]
    monkeypatch.setattr(_core, "list_ports", lambda: listed)
    assert sbgc.ports()[1].usb == sbgc.Usb(*usb)
    assert search.searched() == ["/dev/no-such-port"]
    assert sbgc.find() == []


@pytest.mark.filterwarnings("ignore:.*was not closed:ResourceWarning")
def test_a_client_that_is_forgotten_in_a_call_neither_crashes_nor_hangs(board: Board) -> None:
    for _ in range(20):
        gimbal = sbgc.connect(board)
        gimbal._link.call(msg.GetAnglesRequest()._message, None, None, True, False)
        gimbal._link.move_to(1.0, None, None, 0.0, 1.0, 0.5, True)
        del gimbal
        gc.collect()


def test_a_forked_child_must_not_use_the_client(board: Board, gimbal: Gimbal) -> None:
    script = """
import os, signal, sys
import sbgc

board = sbgc.emulator(noise=0)
gimbal = sbgc.connect(board)
samples = gimbal.stream(sbgc.msg.RealtimeData4, 0.02)
with gimbal.speed_control() as control:
    child = os.fork()
    if child == 0:
        uses = [
            lambda: gimbal.call(sbgc.msg.GetAnglesRequest()),
            lambda: gimbal.is_connected,
            lambda: next(samples),
            lambda: control.set(yaw=5),
            control.refresh,
            control.stop,
            lambda: sbgc.connect(board),
            lambda: board.angles,
            board.unplug,
        ]
        for number, use in enumerate(uses):
            try:
                sys.exit(f"{number}: {use()}")
            except sbgc.GimbalError as error:
                assert "belongs to the process that forked" in str(error), error
        assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
        assert not signal.pthread_sigmask(signal.SIG_BLOCK, [])
        sys.exit(0)
    print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
samples.close()
gimbal.call(sbgc.msg.GetAnglesRequest())
"""
    assert output_of(script) == "0\n"


def test_threads_that_catch_errors_of_a_closed_client_do_not_deadlock(gimbal: Gimbal) -> None:
    gimbal.close()
    assert not gimbal.is_connected and "closed" in repr(gimbal)

    def ask() -> None:
        for _ in range(2000):
            with pytest.raises(GimbalDisconnected, match="the client has been closed"):
                gimbal.call(msg.GetAnglesRequest())

    threads = [threading.Thread(target=ask) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()


def test_what_is_abandoned_ends_with_a_warning(board: Board) -> None:
    gimbal = sbgc.connect(board)
    gc.collect()
    descriptors = len(os.listdir("/proc/self/fd"))
    with pytest.warns(ResourceWarning, match="Stream of RealtimeData4> was not closed") as seen:
        for _ in range(15):  # more than the board has streams
            assert next(gimbal.stream(msg.RealtimeData4, 0.01))
            gc.collect()
    assert len(seen) == 15 and len(os.listdir("/proc/self/fd")) == descriptors
    with pytest.warns(ResourceWarning, match="Gimbal of memory link> was not closed"):
        del gimbal, seen  # which has the streams
        gc.collect()


def test_calls_of_several_threads_do_not_hold_the_interpreter(gimbal: Gimbal) -> None:
    errors: list[BaseException] = []

    def ask() -> None:
        try:
            for _ in range(50):
                gimbal.call(msg.GetAnglesRequest())
        except BaseException as error:
            errors.append(error)

    threads = [threading.Thread(target=ask) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not errors
