"""`python -m sbgc`: describes the installation, for bug reports."""

from __future__ import annotations

import importlib.util
import platform

import sbgc
from sbgc import _core


def main() -> None:
    print(f"sbgc {sbgc.__version__}")
    print(_core.ABOUT)
    print(f"Python {platform.python_version()}, {platform.platform()}")
    print(f"extension: {_core.__file__}")
    for name in ("numpy", "pandas"):
        print(f"{name}: {'found' if importlib.util.find_spec(name) else 'not found'}")


if __name__ == "__main__":
    main()
