"""Converts the documentation of a library's names to HTML."""

from __future__ import annotations

import re
from collections.abc import Iterator

from markupsafe import Markup, escape

from sbgcgen.targets import Documented, Reference


class Documentation:
    """The texts of a reference, in which other names become links."""

    def __init__(self, reference: Reference) -> None:
        self.first = reference.parts[0].name
        self.anchors = {anchor for anchor, _ in anchors_of(reference)}

    def anchor(self, module: Documented, name: str) -> str:
        return anchor_of(self.first, module, name)

    def html(self, text: str, near: str) -> Markup:
        """The paragraphs and code of a text about `near`."""
        return Markup("\n").join(
            Markup('<pre tabindex="0"><code>{}</code></pre>').format(
                re.sub(r"^    ", "", part, flags=re.MULTILINE)
            )
            if part.startswith("    ")
            else Markup("<p>{}</p>").format(self._prose(part, near))
            for part in _paragraphs(text)
        )

    def _prose(self, text: str, near: str) -> Markup:
        """Turns names in backticks, names with brackets, and files of guides into links."""
        result = Markup()
        names = r"(`[^`]+`|\b[A-Za-z_][\w.]*\(\)|docs/[\w-]+\.md)"
        for part in re.split(names, " ".join(text.split())):
            if guide := re.fullmatch(r"docs/(?:\d+-)?(.+)\.md", part):
                link = Markup('<a href="../guides/{}.html">{}</a>')
                result += link.format(guide[1], guide[1].replace("-", " "))
                continue
            if not re.fullmatch(r"`.*`|.*\w\(\)", part):
                result += escape(part)
                continue
            said = part.strip("`")
            target = self._target(said.removesuffix("()"), near)
            code = Markup("<code>{}</code>").format(said)
            result += Markup('<a href="#{}">{}</a>').format(target, code) if target else code
        return result

    def _target(self, name: str, near: str) -> str:
        """The anchor of a name in the text about another one; "" if there is none."""
        own = near.rpartition(".")[0]
        for owner in (near, own, own.rpartition(".")[0], ""):
            for known in (name, name.removeprefix(f"{self.first}.")):
                anchor = f"{owner}.{known}" if owner else known
                if anchor in self.anchors and anchor != near:
                    return anchor
        return ""


def anchors_of(reference: Reference) -> Iterator[tuple[str, Documented]]:
    """All names of a reference with their anchors."""
    first = reference.parts[0].name
    for module in reference.parts:
        yield module.name, module
        for thing in module.members:
            for item in (thing, *thing.members):
                yield anchor_of(first, module, item.name), item


def anchor_of(first: str, module: Documented, name: str) -> str:
    """A name as users of the package write it: Gimbal.stop, aio.Gimbal.stop."""
    inner = module.name.removeprefix(first).lstrip(".")
    return f"{inner}.{name}" if inner else name


def _paragraphs(text: str) -> list[str]:
    """The parts of a text between empty lines; adjacent code parts are joined."""
    found: list[str] = []
    for part in re.split(r"\n\s*\n", text.strip("\n")):
        if found and part.startswith("    ") and found[-1].startswith("    "):
            found[-1] += f"\n\n{part}"
        elif part.strip():
            found.append(part)
    return found
