"""The generator's output for a spec in memory, computed on demand."""

from __future__ import annotations

import re
from functools import cached_property
from pathlib import Path
from typing import Any, Optional

from sbgcgen import build
from sbgcgen.model.export import export
from sbgcgen.model import Layout, Position
from sbgcgen.spec.diagnostics import Diagnostics, SpecError
from sbgcgen.spec.lint.effects import lint_effects
from sbgcgen.spec.lint.usage import lint_unused
from sbgcgen.spec.load import Spec
from sbgcgen.spec.resolve.protocol import resolve
from sbgcgen.spec.syntax import check_syntax
from sbgcgen.targets import target

_COMMENT = re.compile(rb"//[^\n]*|/\*.*?\*/", re.S)


class _FirstFinding(Diagnostics):
    """Ends the work at the first finding: one is enough to refuse a spec."""

    def add(self, position: Position, code: str, message: str, hint: str = "") -> None:
        super().add(position, code, message, hint)
        self.raise_if_any()


class Made:
    """The output for a spec; each part is computed on first access."""

    def __init__(self, spec: Spec, project: Path) -> None:
        families = {name: spec.families[name] for name in spec.main["families"]}
        self.spec = Spec(spec.main, families, spec.errata, spec.files)
        self.project = project
        self.found = _FirstFinding()
        self.layout: Optional[Layout] = None
        self._rendered: dict[str, dict[str, bytes]] = {}

    @cached_property
    def model(self) -> Any:
        """The exported model, or None if the spec is invalid."""
        try:
            check_syntax(self.spec, self.found)
            self.layout = resolve(self.spec, self.found)
        except SpecError:
            return None
        return export(self.layout)

    @cached_property
    def is_refused(self) -> bool:
        """True if lint has findings."""
        if self.model is None or self.layout is None:
            return True
        try:
            build.check(self.spec, self.layout, self.found)
            lint_unused(self.spec, self.found)
            lint_effects(self.layout, self.found)
        except SpecError:
            return True
        return False

    @cached_property
    def code(self) -> dict[str, bytes]:
        """The C++ without its comments."""
        return {path: _COMMENT.sub(b"", text) for path, text in self.files("cpp").items()}

    @cached_property
    def vectors(self) -> dict[str, bytes]:
        return self.files("vectors")

    def is_documented_like(self, other: Made) -> bool:
        """True if the C++ with its comments and the site are the same."""
        return all(self.files(name) == other.files(name) for name in ("cpp", "site"))

    def files(self, name: str) -> dict[str, bytes]:
        """The output of a target."""
        assert self.layout is not None
        if name not in self._rendered:
            self._rendered[name] = dict(target(name).files(self.layout, self.project))
        return self._rendered[name]
