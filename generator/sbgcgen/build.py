"""Builds a checked Layout from spec files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from sbgcgen.model import Layout
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.lint.bodies import lint_bodies
from sbgcgen.spec.lint.effects import lint_effects
from sbgcgen.spec.lint.main import lint_main
from sbgcgen.spec.lint.protocol import lint
from sbgcgen.spec.lint.slips import lint_slips, lint_spelling
from sbgcgen.spec.lint.usage import lint_names, lint_unused
from sbgcgen.spec.load import Spec, load
from sbgcgen.spec.recovery import recover_shape, recover_syntax
from sbgcgen.spec.resolve.protocol import resolve
from sbgcgen.spec.schema import check_shape
from sbgcgen.spec.syntax import check_syntax
from sbgcgen.targets import targets


@dataclass(frozen=True)
class Protocol:
    """A spec without findings, and its resolved Layout."""

    spec: Spec
    layout: Layout


def load_protocol(spec_dir: Path, allow_slips: bool = False) -> Protocol:
    """Load, check and resolve a spec folder; `allow_slips` also accepts unlikely values.

    Raises SpecError with every finding. Unused entries are reported only if there is no other
    finding, because another mistake may be the reason that an entry is unused.
    """
    found = Diagnostics()
    spec = load(spec_dir, found)
    check_shape(spec, found)
    if not found.found:
        check_syntax(spec, found)
    if found.found:
        _report_hidden_mistakes(spec, found)
        found.raise_if_any()
    layout = _checked(spec, found)
    found.raise_if_any()
    lint_unused(spec, found)
    lint_effects(layout, found)
    if not allow_slips:
        lint_slips(layout, found)
    found.raise_if_any()
    return Protocol(spec, layout)


def _checked(spec: Spec, found: Diagnostics) -> Layout:
    layout = resolve(spec, found)
    check(spec, layout, found)
    return layout


def check(spec: Spec, layout: Layout, found: Diagnostics) -> None:
    """Apply the rules for a resolved spec; findings go into `found`."""
    lint(spec, layout, found)
    lint_bodies(layout, found)
    lint_names(spec, found)
    lint_spelling(spec, found)
    lint_main(spec, found)
    for target in targets():
        target.lint(spec, layout, found)


def _report_hidden_mistakes(spec: Spec, found: Diagnostics) -> None:
    """Report mistakes that others have hidden so far, so that one run reports both on a line."""
    if found.any_of(("SBGC001",)):
        return  # a file or value could not be read
    recovery = recover_shape(spec, found)
    if recovery is None:
        return
    after_recovery = Diagnostics()
    check_syntax(recovery.spec, after_recovery)
    recovery.report(after_recovery, found)
    if after_recovery.found and not recover_syntax(recovery, after_recovery):
        return
    after_recovery = Diagnostics()
    _checked(recovery.spec, after_recovery)
    recovery.report(after_recovery, found)


def load_layout(spec_dir: Path) -> Layout:
    """Load and resolve a spec folder without applying lint rules, which older specs may violate.

    Raises SpecError if the spec cannot be resolved.
    """
    found = Diagnostics()
    spec = load(spec_dir, found)
    check_shape(spec, found)
    found.raise_if_any()
    check_syntax(spec, found)
    found.raise_if_any()
    layout = resolve(spec, found)
    found.raise_if_any()
    return layout
