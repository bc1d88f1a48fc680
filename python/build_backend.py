"""Builds the package with CMake (PEP 517), without other Python packages.

It needs the libraries of `./dev build`, and pybind11: see `python` in ./dev. A Python that is newer than
Debian's needs a newer pybind11, which pip provides. The same commit makes the same wheel if
SOURCE_DATE_EPOCH is set.
"""

from __future__ import annotations

import base64
import gzip
import hashlib
import importlib
import importlib.util
import io
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import time
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Optional

if sys.version_info < (3, 9):
    raise SystemExit(f"sbgc: Python 3.9 or newer is needed, this is {sys.version.split()[0]}")

ROOT = Path(__file__).resolve().parents[1]
# Shared by every Python: only the extension differs. Another processor has its own folder: Python
# compiles extensions for the processor that these variables name.
PROCESSOR = os.environ.get("_PYTHON_HOST_PLATFORM", "")
BUILD = ROOT / "build" / f"wheel{'-' if PROCESSOR else ''}{PROCESSOR}"
EXTENSION = f"_core{sysconfig.get_config_var('EXT_SUFFIX')}"
# The sources of the package.
SOURCES = [
    *("CMakeLists.txt", "LICENSE", "README.md", "pyproject.toml", "runtime", "emulator"),
    *("generated/include", "generated/python", "python"),
]

Settings = Optional[Mapping[str, Any]]


# The Debian packages, and a program or header of each.
PROGRAMS = {"cmake": "cmake", "ninja-build": "ninja", "g++": "c++"}
HEADERS = {"pybind11-dev": "pybind11/pybind11.h"}
HAS_CLIENT = sys.platform == "linux"
if HAS_CLIENT:
    HEADERS |= {
        "libasio-dev": "asio.hpp",
        "libserialport-dev": "libserialport.h",
        "libfmt-dev": "fmt/format.h",
        "libkissfft-dev": "kissfft/kiss_fft.h",
        "nlohmann-json3-dev": "nlohmann/json.hpp",
    }


# Modules that read TOML; the first is part of Python since 3.11.
TOML = ["tomllib", "tomli", "pip._vendor.tomli"]


def _has_module(name: str) -> bool:
    try:
        return importlib.util.find_spec(name) is not None
    except ModuleNotFoundError:  # of a parent
        return False


def get_requires_for_build_wheel(config_settings: Settings = None) -> list[str]:
    """Return the packages that this Python needs for building: none with those of Debian."""
    needed = [] if any(map(_has_module, TOML)) else ["tomli"]
    has_debians = sys.version_info < (3, 12) and HAS_CLIENT
    return needed + ([] if has_debians else ["pybind11 >= 2.13.6"])


def _project() -> dict[str, Any]:
    toml = importlib.import_module(next(filter(_has_module, TOML)))
    table: dict[str, Any] = toml.loads((ROOT / "pyproject.toml").read_text())["project"]
    return table


def missing_packages() -> list[str]:
    """Return the Debian packages that building needs and this system lacks."""
    missing = [package for package, name in PROGRAMS.items() if shutil.which(name) is None]
    if "g++" not in missing:
        missing += [package for package, header in HEADERS.items() if not _has(header)]
    if _has_module("pybind11") and "pybind11-dev" in missing:
        missing.remove("pybind11-dev")
    if not Path(sysconfig.get_paths()["include"], "Python.h").exists():
        missing.append("python3-dev")
    return missing


def _has(header: str) -> bool:
    command = ["c++", "-x", "c++", "-E", "-o", os.devnull, "-"]
    test = f'#if !__has_include("{header}")\n#error\n#endif\n'
    done = subprocess.run(command, input=test, text=True, capture_output=True, check=False)
    return done.returncode == 0


def _version() -> str:
    header = (ROOT / "runtime/core/include/sbgc/version.hpp").read_text()
    return ".".join(re.findall(r"^#define SBGC_VERSION_[A-Z]+ (\d+)$", header, re.MULTILINE))


def _name() -> str:
    return f"{_project()['name']}-{_version()}"


def _metadata() -> str:
    project = _project()
    lines = [
        ("Metadata-Version", "2.1"),
        ("Name", project["name"]),
        ("Version", _version()),
        ("Summary", project["description"]),
        ("License", project["license"]["text"]),
        ("Keywords", ",".join(project["keywords"])),
        *(("Classifier", classifier) for classifier in project["classifiers"]),
        ("Requires-Python", project["requires-python"]),
        ("Description-Content-Type", "text/markdown"),
    ]
    for extra, packages in project["optional-dependencies"].items():
        lines.append(("Provides-Extra", extra))
        lines += [("Requires-Dist", f'{package}; extra == "{extra}"') for package in packages]
    head = "".join(f"{key}: {value}\n" for key, value in lines)
    return f"{head}\n{(ROOT / project['readme']).read_text(encoding='utf-8')}"


def _tag() -> str:
    version = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    return f"{version}-{version}-{platform}"


def _compile() -> Path:
    """Return the folder of the built package."""
    if missing := missing_packages():
        raise SystemExit(f"sbgc: building needs packages: apt-get install {' '.join(missing)}")
    options = {
        "CMAKE_BUILD_TYPE": "MinSizeRel",
        # g++ needs less memory if it collects its garbage early.
        "CMAKE_CXX_FLAGS": "-ffunction-sections -fdata-sections --param=ggc-min-expand=60"
        f" -ffile-prefix-map={ROOT}=.",
        "CMAKE_INTERPROCEDURAL_OPTIMIZATION": "ON",
        "CMAKE_UNITY_BUILD": "ON",
        "CMAKE_UNITY_BUILD_BATCH_SIZE": "48",
        "Python_EXECUTABLE": sys.executable,
        "SBGC_BUILD_IO": "ON" if HAS_CLIENT else "OFF",
        "SBGC_BUILD_PYTHON": "ON",
        "SBGC_BUILD_TOOLS": "OFF",
        "SBGC_BUILD_TESTS": "OFF",
        "SBGC_BUILD_EXAMPLES": "OFF",
        "SBGC_REGENERATE": "OFF",
    }
    if _has_module("pybind11"):
        options["pybind11_DIR"] = importlib.import_module("pybind11").get_cmake_dir()
    said = [f"-D{name}={value}" for name, value in options.items()]
    cache = BUILD / "CMakeCache.txt"
    if cache.exists() and f"CMAKE_HOME_DIRECTORY:INTERNAL={ROOT}\n" not in cache.read_text():
        shutil.rmtree(BUILD)  # the checkout has been moved
    # Forget what CMake has found for another Python.
    forget = ["-U", "*Python_*", "-U", "PYTHON_*", "-U", "pybind11_*"]
    subprocess.run(["cmake", "-S", ROOT, "-B", BUILD, "-G", "Ninja", *forget, *said], check=True)
    # More compilers than processors would cost memory and processor time.
    environment = {
        "CMAKE_BUILD_PARALLEL_LEVEL": str(os.cpu_count() or 1),
        **os.environ,
        "NINJA_STATUS": "sbgc: [%f of %t, %es] ",
    }
    build = ["cmake", "--build", str(BUILD), "--target", "sbgc_python"]
    subprocess.run(build, check=True, env=environment)
    return BUILD / "python" / "sbgc"


def _package() -> list[Path]:
    """Return the files of the package; only the extension is specific to this Python."""
    return [path for path in _files(_compile()) if path.name == EXTENSION or path.suffix != ".so"]


def _time() -> float:
    return float(os.environ.get("SOURCE_DATE_EPOCH", time.time()))


def _information() -> dict[str, bytes]:
    """Return the files that describe the package, by name."""
    wheel = f"Wheel-Version: 1.0\nGenerator: sbgc\nRoot-Is-Purelib: false\nTag: {_tag()}\n"
    license = (ROOT / "LICENSE").read_bytes()
    scripts = "".join(f"{name} = {place}\n" for name, place in _project()["scripts"].items())
    return {
        "METADATA": _metadata().encode(),
        "LICENSE": license,
        "WHEEL": wheel.encode(),
        "entry_points.txt": f"[console_scripts]\n{scripts}".encode(),
    }


def prepare_metadata_for_build_wheel(
    metadata_directory: str, config_settings: Settings = None
) -> str:
    """Write the files that describe the package into a folder, and return its name."""
    folder = Path(metadata_directory) / f"{_name()}.dist-info"
    folder.mkdir(parents=True, exist_ok=True)
    for name, data in _information().items():
        (folder / name).write_bytes(data)
    return folder.name


def build_wheel(
    wheel_directory: str, config_settings: Settings = None, metadata_directory: Optional[str] = None
) -> str:
    """Write the wheel, and return the name of its file."""
    files = {str(p.relative_to(BUILD / "python")): p.read_bytes() for p in _package()}
    return _write_wheel(wheel_directory, files)


def build_editable(
    wheel_directory: str, config_settings: Settings = None, metadata_directory: Optional[str] = None
) -> str:
    """Write a wheel that refers to the sources; a changed extension or new files need a new wheel."""
    folder = BUILD / "editable" / (sys.implementation.cache_tag or "python")
    shutil.rmtree(folder, ignore_errors=True)
    for built in _package():
        name = built.relative_to(BUILD / "python")
        sources = [ROOT / "python" / name, ROOT / "generated" / "python" / name, built]
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).symlink_to(next(path for path in sources if path.exists()))
    return _write_wheel(wheel_directory, {"sbgc.pth": f"{folder}\n".encode()})


def _write_wheel(wheel_directory: str, files: dict[str, bytes]) -> str:
    info = f"{_name()}.dist-info"
    files.update({f"{info}/{name}": data for name, data in _information().items()})
    record = "".join(f"{name},{_hash(data)},{len(data)}\n" for name, data in sorted(files.items()))
    files[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()
    name = f"{_name()}-{_tag()}.whl"
    with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as archive:
        for path_in, data in sorted(files.items()):
            at = time.gmtime(_time())
            date = (at.tm_year, at.tm_mon, at.tm_mday, at.tm_hour, at.tm_min, at.tm_sec)
            entry = zipfile.ZipInfo(path_in, date)
            entry.external_attr = (0o755 if path_in.endswith(".so") else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
    return name


def _hash(data: bytes) -> str:
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=")
    return f"sha256={digest.decode()}"


def build_sdist(sdist_directory: str, config_settings: Settings = None) -> str:
    """Write an archive of the sources that the package needs, and return the name of its file."""
    name = f"{_name()}.tar.gz"
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as archive:
        paths = [path for source in SOURCES for path in _files(ROOT / source)]
        for path in sorted(paths):
            _add(archive, f"{_name()}/{path.relative_to(ROOT)}", path.read_bytes())
        _add(archive, f"{_name()}/PKG-INFO", _metadata().encode())
    with gzip.GzipFile(Path(sdist_directory) / name, "wb", mtime=_time()) as file:
        file.write(packed.getvalue())
    return name


def _files(path: Path) -> list[Path]:
    if path.is_file():
        return [path]
    return [p for p in path.rglob("*") if p.is_file() and "__pycache__" not in p.parts]


def _add(archive: tarfile.TarFile, name: str, data: bytes) -> None:
    entry = tarfile.TarInfo(name)
    entry.size, entry.mtime = len(data), int(_time())
    archive.addfile(entry, io.BytesIO(data))


get_requires_for_build_editable = get_requires_for_build_wheel
get_requires_for_build_sdist = get_requires_for_build_wheel
prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel

__all__ = [
    "build_editable",
    "build_sdist",
    "build_wheel",
    "get_requires_for_build_editable",
    "get_requires_for_build_sdist",
    "get_requires_for_build_wheel",
    "prepare_metadata_for_build_editable",
    "prepare_metadata_for_build_wheel",
]
