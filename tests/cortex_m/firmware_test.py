"""The firmware of examples/cortex-m needs no library, and talks to an emulated gimbal."""

from __future__ import annotations

import os
import queue
import re
import signal
import subprocess
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import pytest
from gimbal_observer import Observer
from optical_axis import degrees_down

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples/cortex-m"

# The machine of QEMU for each processor. That of the Cortex-M0+ has a Cortex-M0, which executes the
# same instructions.
MACHINES = {"m0plus": "microbit", "m4f": "mps2-an386", "m7": "mps2-an500"}

# The timeout for the next line of output. The programs need less than two seconds, a busy machine
# more.
PATIENCE = 120

# Symbols that do not belong in a program for a microcontroller.
FORBIDDEN = {
    "heap": r"malloc|calloc|realloc|free|_sbrk|_Zn[wa]|_Zd[la]",
    "exceptions": r"__cxa_|_Unwind_|__gxx_personality|__aeabi_unwind",
    "types at run time": r"_ZT[IS]",
    "floating point in software": r"__aeabi_([df][a-z2]|u?[il]2[df])",
    "division of 64 bits": r"__aeabi_u?ldivmod",
}


def output_of(*command: str | Path) -> str:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    return done.stdout


@cache
def build(core: str, *options: str) -> Path:
    """Builds the firmware as its users do, by default one that may move; returns the program."""
    folder = Path(os.environ["SBGC_BUILD"]) / "".join([core, *options])
    toolchain = f"-DCMAKE_TOOLCHAIN_FILE={EXAMPLE}/toolchain.cmake"
    settings = [toolchain, f"-DCORTEX_M={core}", *(options or ["-DCORTEX_M_MAY_MOVE=ON"])]
    output_of("cmake", "-S", EXAMPLE, "-B", folder, "-G", "Ninja", *settings)
    output_of("cmake", "--build", folder)
    return folder / "firmware"


def symbols(program: Path) -> list[str]:
    return [line.split()[-1] for line in output_of("arm-none-eabi-nm", program).splitlines()]


@pytest.mark.parametrize("what", FORBIDDEN)
@pytest.mark.parametrize("core", MACHINES)
def test_the_program_contains_no(core: str, what: str) -> None:
    names = symbols(build(core))
    assert "main" in names and "memcpy" in names
    assert not [name for name in names if re.match(FORBIDDEN[what], name)]


@pytest.mark.parametrize("core", MACHINES)
def test_the_program_does_not_calculate_with_doubles(core: str) -> None:
    code = output_of("arm-none-eabi-objdump", "-d", build(core))
    assert "<main>:" in code
    assert not re.findall(r"\.f64\b", code)


def test_the_program_moves_nothing_unless_its_builder_agrees() -> None:
    assert b"arrived at" in build("m4f").read_bytes()
    careful = build("m4f", "-DCMAKE_BUILD_TYPE=Release").read_bytes()
    assert b"no tilt" in careful and b"arrived at" not in careful


@pytest.mark.parametrize("core", MACHINES)
def test_the_state_needs_no_flash(core: str) -> None:
    """It is in .bss, which start-up clears, not in .data, which is copied from flash."""
    _, data, bss, *_ = output_of("arm-none-eabi-size", build(core)).splitlines()[1].split()
    assert int(data) == 0 and int(bss) > 500


def test_the_patterns_of_forbidden_names_match() -> None:
    examples = {
        "heap": ["malloc", "_Znwj", "_ZdlPvj"],
        "exceptions": ["__cxa_throw", "_Unwind_Resume", "__aeabi_unwind_cpp_pr0"],
        "types at run time": ["_ZTIi", "_ZTS5Thing"],
        "floating point in software": ["__aeabi_dadd", "__aeabi_fcmplt", "__aeabi_i2d"],
        "division of 64 bits": ["__aeabi_ldivmod", "__aeabi_uldivmod"],
    }
    assert examples.keys() == FORBIDDEN.keys()
    for what, names in examples.items():
        assert all(re.match(FORBIDDEN[what], name) for name in names)


class Program:
    """A running program; its lines of output arrive in time, or the test fails."""

    def __init__(self, *command: str | Path) -> None:
        self.process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
        )
        self.seen: list[str] = []
        self.lines: queue.Queue[str] = queue.Queue()
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()

    def read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.lines.put(line.rstrip("\n"))

    def expect(self, pattern: str) -> re.Match[str]:
        """Returns the next line, which must match."""
        try:
            self.seen.append(self.lines.get(timeout=PATIENCE))
        except queue.Empty:
            raise AssertionError(f"no line '{pattern}' after {self.seen}") from None
        found = re.fullmatch(pattern, self.seen[-1])
        assert found, f"not '{pattern}': {self.seen}"
        return found


@contextmanager
def running(*command: str | Path) -> Iterator[Program]:
    program = Program(*command)
    try:
        yield program
    finally:
        program.process.kill()
        program.process.wait()
        program.reader.join()
        assert program.process.stdout is not None
        program.process.stdout.close()


@contextmanager
def emulated_gimbal() -> Iterator[tuple[Program, str]]:
    """A gimbal and its address."""
    with running(os.environ["SBGC"], "emulate", "--tcp", "0") as gimbal:
        yield gimbal, gimbal.expect(r"emulated gimbal 1: tcp:([\d.]+:\d+)")[1]


def emulated_machine(core: str, uart: str, program: Path) -> tuple[str | Path, ...]:
    """Returns the command of a machine whose UART is connected to the address `uart`."""
    host, _, port = uart.partition(":")
    return (
        *("qemu-system-arm", "-M", MACHINES[core], "-display", "none", "-monitor", "none"),
        *("-semihosting-config", "enable=on,target=native"),
        *("-chardev", f"socket,id=uart,host={host},port={port}", "-serial", "chardev:uart"),
        *("-kernel", program),
    )


@pytest.mark.parametrize("core", MACHINES)
def test_it_talks_to_a_gimbal_and_survives_a_dead_line(core: str) -> None:
    program = build(core)
    with emulated_gimbal() as (gimbal, address):
        with running(*emulated_machine(core, address, program)) as firmware:
            firmware.expect(r"board 30, firmware 2590")
            at_first = firmware.expect(r"pitch (-?\d+) millidegrees")
            assert abs(int(at_first[1])) < 2000
            firmware.expect(r"arrived at \d+ millidegrees")
            with Observer(f"tcp:{address}") as observer:
                assert degrees_down(observer.motors()) == pytest.approx(10, abs=0.6)
            firmware.expect("watching")
            gimbal.process.send_signal(signal.SIGSTOP)
            firmware.expect("the line is dead")
            gimbal.process.send_signal(signal.SIGCONT)
            turns = firmware.expect(r"the line is back, after (\d+) turns")
            assert int(turns[1]) > 10
            at_last = firmware.expect(r"pitch (\d+) millidegrees")
            assert abs(int(at_last[1]) - 10_000) < 2000
            stack = firmware.expect(r"stack (\d+) bytes")
            assert int(stack[1]) <= 1536
            assert firmware.process.wait(PATIENCE) == 0


def test_it_says_that_no_board_answers() -> None:
    """The status of the firmware is that of the emulated machine."""
    with emulated_gimbal() as (gimbal, address):
        gimbal.process.send_signal(signal.SIGSTOP)
        with running(*emulated_machine("m4f", address, build("m4f"))) as firmware:
            firmware.expect("no board answers")
            assert firmware.process.wait(PATIENCE) == 1
