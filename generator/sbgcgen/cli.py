"""The generator's command line."""

from __future__ import annotations

import argparse
import re
import sys
from pathlib import Path

from sbgcgen.build import load_protocol
from sbgcgen.spec.diagnostics import SpecError
from sbgcgen.compat import report
from sbgcgen.model import Layout
from sbgcgen.output import Output
from sbgcgen.targets import Target, outputs, targets

_ROOT = Path(__file__).resolve().parents[2]


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="sbgcgen", description="Generates generated/ from the protocol in spec/."
    )
    commands = parser.add_subparsers(dest="command", required=True)
    for name, text in (
        ("generate", "write generated/; unchanged files are left alone"),
        (
            "check",
            "check that generated/ is up to date with spec/ and generator/; exit status 1 if not",
        ),
        *((target.name, target.help) for target in _apart()),
        ("lint", "check spec/ only"),
        ("compat", "list the changes since another version of the spec; exit status 1 for breaks"),
    ):
        sub = commands.add_parser(name, help=text, description=text)
        sub.add_argument("--root", type=Path, default=_ROOT, help="project folder")
        sub.add_argument("--spec", type=Path, help="spec folder, if not <root>/spec")
        if name == "compat":
            sub.add_argument("old", metavar="OLD", help="spec folder, or git revision")
            sub.add_argument(
                "new",
                metavar="NEW",
                nargs="?",
                help="spec folder, or git revision; default: spec/ as it is now",
            )
        if name == "generate":
            sub.add_argument("--output", type=Path, help="output folder, if not <root>/generated")
            sub.add_argument("--depfile", type=Path, help="write what was read, as a Make rule")
            sub.add_argument("--stamp", type=Path, help="touch this file when done")
        elif name in (target.name for target in _apart()):
            text = f"output folder, if not <root>/build/{name}"
            sub.add_argument("--output", type=Path, help=text)
    return parser


def _apart() -> list[Target]:
    """Targets that are not part of generated/; each has its own command."""
    return [target for target in targets() if not target.committed]


def inputs() -> list[Path]:
    """Files of the generator that its output depends on."""
    here = Path(__file__).resolve().parent
    files = [*here.rglob("*"), *(here.parent / "schema").glob("*.json")]
    return [path for path in files if path.is_file() and "__pycache__" not in path.parts]


def _write_depfile(depfile: Path, stamp: Path, read: list[Path]) -> None:
    names = " \\\n  ".join(_escape(path) for path in sorted(read))
    depfile.parent.mkdir(parents=True, exist_ok=True)
    depfile.write_text(f"{_escape(stamp)}: \\\n  {names}\n", encoding="utf-8")


def _escape(path: Path) -> str:
    return re.sub(r"([ #\\])", r"\\\1", str(path)).replace("$", "$$")


def _output(options: argparse.Namespace, root: Path, layout: Layout) -> Output:
    chosen: Path | None = getattr(options, "output", None)
    for target in _apart():
        if target.name == options.command:
            folder = (chosen or root / "build" / target.name).resolve()
            return Output(folder, dict(target.files(layout, root)), target.mark)
    return Output((chosen or root / "generated").resolve(), outputs(layout, root))


def main(arguments: list[str] | None = None) -> int:
    """Run one command; returns 0, or 1 for findings. Wrong usage exits with status 2."""
    parser = _parser()
    options = parser.parse_args(arguments)
    if getattr(options, "depfile", None) and not options.stamp:
        parser.error("--depfile needs --stamp")
    root: Path = options.root.resolve()
    spec_dir: Path = (options.spec or root / "spec").resolve()
    if options.command == "compat":
        return report.run(options.old, options.new, root, spec_dir)
    try:
        protocol = load_protocol(spec_dir)
    except SpecError as error:
        print(error, file=sys.stderr)
        count = len(error.diagnostics)
        print(f"{count} error{'s' if count != 1 else ''} in {spec_dir.name}/", file=sys.stderr)
        return 1
    layout = protocol.layout
    if options.command == "lint":
        print(f"{len(layout.commands)} commands, {len(layout.messages)} messages: no errors")
        return 0
    output = _output(options, root, layout)
    if options.command == "check":
        drift = output.drift()
        for line in drift:
            print(line, file=sys.stderr)
        if drift:
            print("generated/ has drifted: run './dev generate'", file=sys.stderr)
        return 1 if drift else 0
    try:
        changed = output.write()
        if getattr(options, "depfile", None):
            _write_depfile(options.depfile, options.stamp, protocol.spec.files + inputs())
        if getattr(options, "stamp", None):
            options.stamp.parent.mkdir(parents=True, exist_ok=True)
            options.stamp.touch()
    except OSError as error:
        print(f"cannot write {error.filename}: {error.strerror}", file=sys.stderr)
        return 1
    print(f"{len(output.files)} files, {changed} changed")
    return 0
