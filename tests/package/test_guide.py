"""What docs/11-library.md says about using the library: each piece of CMake and the line with pkg-config are
taken from there, and build a program."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from compilers import HERE, HOSTS, PREFIX, ROOT, blocks, run

# What the library itself consists of. There is no generator, so the build cannot run Python.
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
