"""Reads a version of the protocol: a revision with its own generator, a folder with this one.

The language of the YAML may change, so a revision's spec is read by the generator of that revision,
which prints its model (see dump.py). Classes and fields that this model lacks are dropped; fields
that the old model lacks get default values. `RENAMED` maps former names of classes and fields, and
`_UPGRADES` converts former structures.
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

# Current names by former names, of classes and of fields as "Class.field".
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
    """The model of a version, read without lint rules, which older specs may violate.

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
    """The model from a dump."""
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
    """An object of the current class; None if the class no longer exists."""
    class_ = getattr(model, RENAMED.get(name, name), None)
    if class_ is None:
        return None
    facts = {RENAMED.get(f"{name}.{key}", key): value for key, value in facts.items()}
    facts = _UPGRADES.get(name, lambda same: same)(facts)
    known = {}
    for field in dataclasses.fields(class_):
        if field.name in facts:
            known[field.name] = facts[field.name]
        elif field.default is field.default_factory is dataclasses.MISSING:
            known[field.name] = _nothing(str(field.type))
    return class_(**known)


def _nothing(type_: str) -> Any:
    """The default value of a field by its type."""
    if type_.endswith("| None"):
        return None
    plain = {"str": "", "int": 0, "bool": False, "Fraction": Fraction(0)}
    if type_ in plain:
        return plain[type_]
    return _object(type_, {}) if hasattr(model, type_) else ()


# Former shapes


def _answer(facts: Facts) -> Facts:
    """Formerly, an answer had no cases."""
    if "cases" in facts:
        return facts
    case = _object("AnswerCase", {"confirm": "never", "confirmations": 1, **facts})
    return {**facts, "cases": (case,)}


def _framing(facts: Facts) -> Facts:
    """Formerly, there was one framing, and the model only had the sizes of its parts."""
    facts = {"name": "v1", **facts}
    if "header" in facts:
        return facts
    checksums = (
        _object("Checksum", {"name": "header_checksum", "kind": "sum8", "covers": ("id", "size")}),
        _object("Checksum", {"name": "body_checksum", "kind": "sum8", "covers": ("body",)}),
    )
    parts = {"header": ("start", "id", "size", "header_checksum"), "trailer": ("body_checksum",)}
    return {**facts, **parts, "checksums": checksums}


def _condition(facts: Facts) -> Facts:
    """Formerly, a condition had the accepted values, but not their numbers."""
    if "numbers" in facts:
        return facts
    return {**facts, "numbers": tuple(value.value for value in facts.get("values", ()))}


def _layout(facts: Facts) -> Facts:
    """Formerly, there was one framing."""
    return {**facts, "framings": (facts["framing"],)} if "framing" in facts else facts


_UPGRADES: dict[str, Callable[[Facts], Facts]] = {
    "Answer": _answer,
    "Condition": _condition,
    "Framing": _framing,
    "Layout": _layout,
}
