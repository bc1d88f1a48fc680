"""Reads a version of the protocol: a revision with its own generator, everything else with this one.

The language of the YAML may change, so only the generator of a revision can be relied on to read its
spec. It prints its model (see dump.py), of which the classes and fields that this model has are taken.
What it did not know yet is as it is where nothing is said. Where a class or field of the model gets
another name, `RENAMED` says so; where it gets another shape, `_UPGRADES` does.
"""

from __future__ import annotations

import dataclasses
import json
import os
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

from sbgcgen import model
from sbgcgen.build import load_layout
from sbgcgen.compat.revision import Version
from sbgcgen.model import Layout

# Former names of classes, and of fields as "Class.field", with those of now.
RENAMED = {
    "AnswerCase.echoes": "correlation",
    "AnswerCase.replies": "responses",
    "Echo": "CorrelationField",
    "Reply": "Response",
    "Reply.echoes": "correlation",
}

Facts = dict[str, Any]


class UnreadableRevision(Exception):
    """The generator of a revision cannot read its own spec."""


def layout_of(version: Version) -> Layout:
    """The model of a version, without the rules of style, which older ones may not know.

    Raises SpecError or UnreadableRevision.
    """
    if version.generator is None:
        return load_layout(version.folder)
    program = Path(__file__).with_name("dump.py").read_text(encoding="utf-8")
    path = [str(version.generator), *filter(None, [os.environ.get("PYTHONPATH")])]
    done = subprocess.run(
        [sys.executable, "-", str(version.folder)],
        input=program,
        cwd=version.generator,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(path), "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode != 0:
        raise UnreadableRevision(done.stderr.strip())
    return restore(json.loads(done.stdout))


def restore(objects: list[Any]) -> Layout:
    """The model that a dump tells of."""
    made: list[Any] = []
    for name, fields in objects:
        made.append(_object(name, {key: _value(value, made) for key, value in fields.items()}))
    assert isinstance(made[-1], Layout)
    return made[-1]


def _value(value: Any, made: list[Any]) -> Any:
    if isinstance(value, list):
        return [_value(item, made) for item in value]
    if not isinstance(value, dict):
        return value
    ((kind, content),) = value.items()
    if kind == "object":
        return made[content]
    if kind == "fraction":
        return Fraction(content)
    if kind == "tuple":
        return tuple(_value(item, made) for item in content)
    return {_value(key, made): _value(item, made) for key, item in content}


def _object(name: str, facts: Facts) -> Any:
    """An object of the class of now; of one that there is no more, only that it was there."""
    class_ = getattr(model, RENAMED.get(name, name), None)
    if class_ is None:
        return None
    facts = {RENAMED.get(f"{name}.{key}", key): value for key, value in facts.items()}
    facts = _UPGRADES.get(name, lambda same: same)(facts)
    known = {}
    for field in dataclasses.fields(class_):
        if field.name in facts:
            known[field.name] = facts[field.name]
        elif _has_no_default(field):
            known[field.name] = _nothing(str(field.type))
    return class_(**known)


def _has_no_default(field: dataclasses.Field[Any]) -> bool:
    return field.default is field.default_factory is dataclasses.MISSING


def _nothing(type_: str) -> Any:
    """What a field of a type says when nothing is said."""
    if type_.endswith("| None"):
        return None
    plain = {"str": "", "int": 0, "bool": False, "Fraction": Fraction(0)}
    if type_ in plain:
        return plain[type_]
    return _object(type_, {}) if hasattr(model, type_) else ()


# Former shapes


def _answer(facts: Facts) -> Facts:
    """An answer was the same in all cases, and a name or several."""
    if "cases" in facts:
        return facts
    case = _object("AnswerCase", {"confirm": "never", "confirmations": 1, **facts})
    return {**facts, "cases": (case,)}


def _framing(facts: Facts) -> Facts:
    """The sizes of header and trailer were all that the model had of their parts."""
    if "header" in facts:
        return facts
    checksums = (
        _object("Checksum", {"name": "header_checksum", "kind": "sum8", "covers": ("id", "size")}),
        _object("Checksum", {"name": "body_checksum", "kind": "sum8", "covers": ("body",)}),
    )
    parts = {"header": ("start", "id", "size", "header_checksum"), "trailer": ("body_checksum",)}
    return {**facts, **parts, "checksums": checksums}


_UPGRADES: dict[str, Callable[[Facts], Facts]] = {"Answer": _answer, "Framing": _framing}
