"""The way from spec files to a checked Layout."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from sbgcgen.diagnostics import Diagnostics
from sbgcgen.lint import lint
from sbgcgen.lint_bodies import lint_bodies
from sbgcgen.lint_effects import lint_effects
from sbgcgen.lint_usage import lint_usage
from sbgcgen.load import Spec, load
from sbgcgen.model import Layout
from sbgcgen.resolve import resolve
from sbgcgen.schema import check_shape
from sbgcgen.syntax import check_syntax


@dataclass(frozen=True)
class Protocol:
    """A spec without findings, and what it means."""

    spec: Spec
    layout: Layout


def load_protocol(spec_dir: Path) -> Protocol:
    """Load, check and resolve a spec folder.

    Raises SpecError with every finding. Shape errors hide what builds on the shape, so they are
    reported first; everything else comes in one go. What is unused is reported when all else is
    right: a mistake elsewhere may be the reason.
    """
    found = Diagnostics()
    spec, layout = _resolve(spec_dir, found)
    lint(spec, layout, found)
    lint_bodies(layout, found)
    found.raise_if_any()
    lint_usage(spec, found)
    lint_effects(layout, found)
    found.raise_if_any()
    return Protocol(spec, layout)


def load_layout(spec_dir: Path) -> Layout:
    """Load and resolve a spec folder without the rules of style, which older ones may not know.

    Raises SpecError if it can not be understood.
    """
    found = Diagnostics()
    _, layout = _resolve(spec_dir, found)
    found.raise_if_any()
    return layout


def _resolve(spec_dir: Path, found: Diagnostics) -> tuple[Spec, Layout]:
    spec = load(spec_dir, found)
    check_shape(spec, found)
    found.raise_if_any()
    check_syntax(spec, found)
    found.raise_if_any()
    return spec, resolve(spec, found)
