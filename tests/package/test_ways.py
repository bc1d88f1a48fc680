"""The ways of docs/11-library.md to use the library build a program: each piece of CMake, pkg-config, whose
flags are all that a compiler needs, and the single header. Every package requires `sbgc`, and `sbgc-client`
requires `sbgc-io`."""

from __future__ import annotations

import os
import shlex
import shutil
from pathlib import Path

import pytest

from compilers import BARE, HERE, HOSTS, PREFIX, ROOT, STRICT, blocks, generate, run

# The sources of the library itself. There is no generator, so the build cannot run Python.
SOURCES = ("CMakeLists.txt", "LICENSE", "runtime", "emulator", "generated/include")
HEAD = "cmake_minimum_required(VERSION 3.25)\nproject(app LANGUAGES CXX)\nadd_executable(app app.cpp)\n"
# A subproject must not bring along its tests, its tools and the generator.
TAIL = """foreach(target IN ITEMS sbgc sbgc_generate sbgc_serving)
  if(TARGET ${target})
    message(FATAL_ERROR "${target} is no part of the library")
  endif()
endforeach()
"""


@pytest.fixture(name="app")
def folder_of_an_app(tmp_path: Path) -> Path:
    shutil.copy(HERE / "consumer/main.cpp", tmp_path / "app.cpp")
    return tmp_path


def test_the_guide_has_all_ways() -> None:
    first = [block.split("(")[0] for block in blocks("cmake")]
    assert first == ["add_subdirectory", "include", "find_package"]


@pytest.mark.parametrize("text", blocks("cmake"))
def test_cmake_of_the_guide(text: str, app: Path) -> None:
    if "add_subdirectory" in text:
        for source in SOURCES:
            (app / "sbgc" / source).parent.mkdir(parents=True, exist_ok=True)
            (app / "sbgc" / source).symlink_to(ROOT / source)
    elif "FetchContent" in text:
        run("tar", "-C", ROOT, "-czf", app / "sbgc.tar.gz", "--transform=s,^,sbgc/,", *SOURCES)
    (app / "CMakeLists.txt").write_text(HEAD + text + TAIL, encoding="utf-8")
    options = [f"-DCMAKE_PREFIX_PATH={PREFIX}", f"-DCMAKE_CXX_COMPILER={HOSTS[-1]}", "-GNinja"]
    run("cmake", "-S", app, "-B", app / "build", *options)
    run("cmake", "--build", app / "build")
    assert run(app / "build/app") == "the board has answered\n"


def test_pkg_config_of_the_guide(app: Path) -> None:
    (line,) = (block for block in blocks("sh") if "pkg-config" in block)
    (folder,) = PREFIX.rglob("pkgconfig")
    run("bash", "-c", f"cd '{app}' && {line}", PKG_CONFIG_PATH=str(folder))
    assert run(app / "app") == "the board has answered\n"


@pytest.fixture(name="moved", scope="module")
def moved_prefix(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The installed files in another folder than the one for which they were installed."""
    folder = tmp_path_factory.mktemp("moved") / "a folder"
    shutil.copytree(PREFIX, folder, copy_function=os.link)
    return folder


def build(compiler: str, package: str, source: str, moved: Path, *options: str) -> Path:
    """Compiles a program with the flags that pkg-config prints."""
    (folder,) = moved.rglob("pkgconfig")
    flags = run("pkg-config", "--cflags", "--libs", package, PKG_CONFIG_PATH=str(folder))
    assert str(PREFIX) not in flags
    program = moved.parent / f"{package}-{compiler}"
    text = HERE / "consumer" / source
    run(compiler, "-std=c++20", *options, text, *shlex.split(flags), "-o", program)
    return program


@pytest.mark.parametrize(
    "component", ["json", "any", "tasks", "analysis", "doctor", "emulator", "client"]
)
def test_a_program_with_its_flags(component: str, moved: Path) -> None:
    uses = f"-DUSES_{component.upper()}"
    run(build(HOSTS[-1], f"sbgc-{component}", "component.cpp", moved, uses))


@pytest.mark.long
def test_asynchronous_functions_with_all_completion_tokens(moved: Path) -> None:
    """With g++ 12, which mishandles temporaries in co_await expressions."""
    run(build("g++", "sbgc-client", "tokens.cpp", moved, "-fsanitize=address"))


PROGRAM = [HERE / "single_header" / name for name in ("main.cpp", "ask.cpp")]


@pytest.fixture(name="header", scope="module")
def single_header(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return generate("single-header", tmp_path_factory.mktemp("single"))


@pytest.mark.parametrize("compiler", HOSTS)
def test_two_files_of_a_program(compiler: str, header: Path, tmp_path: Path) -> None:
    options = ["-std=c++20", *STRICT, f"-I{header.parent}"]
    run(compiler, *options, *PROGRAM, "-o", tmp_path / "program")
    assert run(tmp_path / "program") == "the board has answered\n"


@pytest.mark.parametrize("compiler", HOSTS)
def test_freestanding(compiler: str, header: Path, tmp_path: Path) -> None:
    options = ["-std=c++20", *BARE, *STRICT, f"-I{header.parent}"]
    run(compiler, *options, "-c", PROGRAM[1], "-o", tmp_path / "ask.o")


def test_it_is_one_header_with_license(header: Path, tmp_path: Path) -> None:
    text = header.read_text(encoding="utf-8")
    assert text.count("#pragma once") == 1
    assert "#include <sbgc/" not in text
    assert "// MIT License\n" in text.partition("#pragma once")[0]
    assert generate("single-header", tmp_path).read_text(encoding="utf-8") == text
