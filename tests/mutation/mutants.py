"""Finds the places where a source file can be broken in a small way.

Each `Mutant` replaces one expression or statement. libclang finds them, so that a `<` of a template or a
`&` of a reference is no candidate.
"""

from __future__ import annotations

import hashlib
import re
from dataclasses import dataclass
from pathlib import Path

from clang.cindex import Cursor, CursorKind, Index, TypeKind

SWAPS = {
    "<": "<=",
    "<=": "<",
    ">": ">=",
    ">=": ">",
    "==": "!=",
    "!=": "==",
    "&&": "||",
    "||": "&&",
    # Only of numbers:
    "+": "-",
    "-": "+",
    "*": "+",
    "/": "*",
    "%": "/",
    "<<": ">>",
    ">>": "<<",
    "&": "|",
    "|": "&",
    "^": "|",
    "+=": "-=",
    "-=": "+=",
    "|=": "&=",
    "&=": "|=",
    "^=": "|=",
    "<<=": ">>=",
    ">>=": "<<=",
}
FUNCTIONS = (CursorKind.FUNCTION_DECL, CursorKind.FUNCTION_TEMPLATE, CursorKind.CXX_METHOD)
COMPARISONS = frozenset(("<", "<=", ">", ">=", "==", "!=", "&&", "||"))
STATEMENTS = frozenset(
    (
        CursorKind.CALL_EXPR,
        CursorKind.BINARY_OPERATOR,
        CursorKind.COMPOUND_ASSIGNMENT_OPERATOR,
        CursorKind.UNARY_OPERATOR,
        CursorKind.UNEXPOSED_EXPR,
        CursorKind.BREAK_STMT,
        CursorKind.CONTINUE_STMT,
    )
)
# In what is evaluated by the compiler alone, a switch has no effect.
CONSTANTS = frozenset(
    (
        CursorKind.STATIC_ASSERT,
        CursorKind.ENUM_CONSTANT_DECL,
        CursorKind.TEMPLATE_NON_TYPE_PARAMETER,
        CursorKind.TYPE_ALIAS_DECL,
        CursorKind.TYPE_ALIAS_TEMPLATE_DECL,
    )
)
OPERATIONS = frozenset(
    (
        CursorKind.BINARY_OPERATOR,
        CursorKind.COMPOUND_ASSIGNMENT_OPERATOR,
        CursorKind.CALL_EXPR,
        CursorKind.UNEXPOSED_EXPR,
    )
)
CONSTANT = re.compile(
    r"\b(constexpr|consteval|constinit|static_assert|concept|requires|noexcept)\b"
)
INTEGER = re.compile(r"(0[xX][0-9a-fA-F']+|[0-9][0-9']*)([uUlLzZ]*)")


@dataclass(frozen=True)
class Mutant:
    """Replaces the bytes [start, end) of a file by `replacement`; a statement is removed instead."""

    file: str
    start: int
    end: int
    line: int
    context: str  # the text of the first line
    kind: str  # "compare", "logic", "arithmetic", "number", "negation", "statement"
    original: str
    replacement: str

    @property
    def key(self) -> str:
        """Identifies the mutant without its line, which changes with every edit above it."""
        return f"{self.file}: {self.context}: {self.change}"

    @property
    def change(self) -> str:
        """Describes the change in one line."""
        original = " ".join(self.original.split())
        if self.kind == "statement":
            return f"remove {original}"
        return f"{original} -> {' '.join(self.replacement.split())}"

    @property
    def rank(self) -> str:
        """Orders mutants at random, but always in the same way."""
        return hashlib.sha256(self.key.encode()).hexdigest()


def mutants_of(root: Path, files: list[str], flags: list[str]) -> list[Mutant]:
    """Returns the mutants of files that one translation unit can include, by file and position."""
    unit_text = "".join(f'#include "{root / file}"\n' for file in files)
    unit = Index.create().parse(
        "all.cpp", ["-xc++", "-std=c++20", *flags], unsaved_files=[("all.cpp", unit_text)]
    )
    finders = {str(root / file): _Finder(file, (root / file).read_bytes()) for file in files}
    for problem in unit.diagnostics:
        place = problem.location.file
        if problem.severity >= problem.Error and (place is None or place.name in finders):
            raise ValueError(str(problem))
    for cursor in unit.cursor.get_children():
        if cursor.location.file and (finder := finders.get(cursor.location.file.name)):
            finder.visit(cursor, None)
    mutants = []
    for finder in finders.values():
        found = {(mutant.start, mutant.end): mutant for mutant in finder.found}
        mutants += sorted(found.values(), key=lambda mutant: (mutant.start, -mutant.end))
    return mutants


class _Finder:
    def __init__(self, file: str, source: bytes) -> None:
        self.file = file
        self.source = source
        self.lines = source.decode().splitlines()
        self.found: list[Mutant] = []

    def visit(self, cursor: Cursor, parent: Cursor | None) -> None:
        if self._is_constant(cursor):
            return
        children = list(cursor.get_children())
        start = cursor.extent.start.offset
        self._operation(cursor, children)
        self._number(cursor, parent)
        self._negation(cursor, children)
        if cursor.kind == CursorKind.COMPOUND_STMT:
            for child in children:
                self._statement(child)
        if cursor.kind == CursorKind.IF_STMT and self.source.startswith(b"constexpr", start + 3):
            children = children[1:]
        for child in children:
            self.visit(child, cursor)

    def _is_constant(self, cursor: Cursor) -> bool:
        if cursor.kind in CONSTANTS:
            return True
        if cursor.kind in (*FUNCTIONS, CursorKind.VAR_DECL, CursorKind.FIELD_DECL):
            head = self._text(cursor.extent.start.offset, cursor.location.offset)
            words = CONSTANT.findall(head)
            return "consteval" in words if cursor.kind in FUNCTIONS else bool(words)
        return False

    def _operation(self, cursor: Cursor, children: list[Cursor]) -> None:
        if cursor.kind not in OPERATIONS or len(children) < 2:
            return
        left, right = children[0], children[-1]
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        if not start == left.extent.start.offset or not end == right.extent.end.offset:
            return
        between = self._text(left.extent.end.offset, right.extent.start.offset)
        operator = between.strip()
        if operator not in SWAPS:
            return
        if operator in COMPARISONS:
            kind = "logic" if operator in ("&&", "||") else "compare"
        elif all(_is_number(operand) for operand in (left, right)):
            kind = "arithmetic"
        else:
            return
        swapped = (
            self._text(start, left.extent.end.offset)
            + between.replace(operator, SWAPS[operator])
            + self._text(right.extent.start.offset, end)
        )
        self._add(cursor, kind, swapped)

    def _number(self, cursor: Cursor, parent: Cursor | None) -> None:
        if cursor.kind != CursorKind.INTEGER_LITERAL or parent is None:
            return
        if parent.kind in (
            CursorKind.DECL_REF_EXPR,
            CursorKind.MEMBER_REF_EXPR,
            CursorKind.CASE_STMT,
        ):
            return
        before = self._text(max(0, cursor.extent.start.offset - 80), cursor.extent.start.offset)
        if parent.kind.is_declaration() and before.rstrip()[-1:] not in ("=", "{", "("):
            return
        match = INTEGER.fullmatch(self._text(cursor.extent.start.offset, cursor.extent.end.offset))
        if match:
            self._add(cursor, "number", f"{match[0]} + 1")

    def _negation(self, cursor: Cursor, children: list[Cursor]) -> None:
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        # `a != b` may be one as well, as an opposite of `a == b`.
        if cursor.kind == CursorKind.UNARY_OPERATOR and re.match(r"![^=]", self._text(start, end)):
            self._add(cursor, "negation", f"static_cast<bool>({self._text(start + 1, end)})")
        elif cursor.kind == CursorKind.IF_STMT and children:
            condition = children[0]
            if condition.kind.is_expression() and condition.kind != CursorKind.UNARY_OPERATOR:
                text = self._text(condition.extent.start.offset, condition.extent.end.offset)
                head = self._text(start, condition.extent.start.offset)
                if re.fullmatch(r"if\s*\(\s*", head):
                    self._add(condition, "negation", f"!({text})")

    def _statement(self, cursor: Cursor) -> None:
        if cursor.kind not in STATEMENTS and not cursor.kind == CursorKind.RETURN_STMT:
            return
        end = cursor.extent.end.offset
        rest = self._text(end, end + 80)
        semicolon = len(rest) - len(rest.lstrip())
        if rest[semicolon : semicolon + 1] != ";":
            return
        text = self._text(cursor.extent.start.offset, end + semicolon + 1)
        if cursor.kind == CursorKind.RETURN_STMT and not re.fullmatch(r"return\s*;", text):
            return
        self._found(
            cursor.extent.start.line,
            cursor.extent.start.offset,
            end + semicolon + 1,
            "statement",
            "",
        )

    def _add(self, cursor: Cursor, kind: str, replacement: str) -> None:
        place = cursor.extent.start
        if place.file.name.endswith(self.file):
            self._found(place.line, place.offset, cursor.extent.end.offset, kind, replacement)

    def _found(self, line: int, start: int, end: int, kind: str, replacement: str) -> None:
        context = self.lines[line - 1].strip()
        original = self._text(start, end)
        self.found.append(Mutant(self.file, start, end, line, context, kind, original, replacement))

    def _text(self, start: int, end: int) -> str:
        return self.source[start:end].decode()


def _is_number(cursor: Cursor) -> bool:
    kind = cursor.type.get_canonical().kind
    return TypeKind.BOOL.value <= kind.value <= TypeKind.LONGDOUBLE.value
