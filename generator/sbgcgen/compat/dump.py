"""Prints the model of a spec folder as JSON. Runs with the generator of any revision.

It therefore imports only `load_layout` of `sbgcgen.build` (or `load_protocol` of the first
revisions), and only assumes a model of dataclasses. Shared objects are printed once. reading.py is
the inverse.
"""

from __future__ import annotations

import dataclasses
import json
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any


def load(spec_dir: Path) -> Any:
    """The Layout of a spec folder."""
    from sbgcgen import build

    if hasattr(build, "load_layout"):
        return build.load_layout(spec_dir)
    return build.load_protocol(spec_dir).layout


def dump(layout: Any) -> list[Any]:
    """The objects of a model with their classes and fields, each after those that it refers to by its index.

    The last one is the Layout.
    """
    objects: list[Any] = []
    numbers: dict[int, int] = {}

    def plain(value: Any) -> Any:
        if value is None or isinstance(value, (bool, int, float, str)):
            return value
        if isinstance(value, Fraction):
            return {"fraction": str(value)}
        if isinstance(value, dict):
            return {"map": [[plain(k), plain(v)] for k, v in value.items()]}
        if isinstance(value, tuple):
            return {"tuple": [plain(item) for item in value]}
        if isinstance(value, list):
            return [plain(item) for item in value]
        assert dataclasses.is_dataclass(value), f"no plain data: {value!r}"
        if id(value) not in numbers:
            fields = {f.name: plain(getattr(value, f.name)) for f in dataclasses.fields(value)}
            numbers[id(value)] = len(objects)
            objects.append([type(value).__name__, fields])
        return {"object": numbers[id(value)]}

    plain(layout)
    return objects


def main() -> None:
    """Print the model of the folder in the arguments, or an error to stderr."""
    try:
        made = dump(load(Path(sys.argv[1])))
    except Exception as error:  # exception types differ between revisions
        sys.exit(f"{type(error).__name__}: {error}")
    json.dump(made, sys.stdout)


if __name__ == "__main__":
    main()
