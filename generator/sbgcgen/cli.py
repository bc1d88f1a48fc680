"""The generator's command line."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sbgcgen.record import Record, inputs

if TYPE_CHECKING:
    from sbgcgen.build import Protocol
    from sbgcgen.targets import Target

# Modules are imported when a command needs them: a run of `generate` with nothing to do needs none,
# and most commands do not need all.

_ROOT = Path(__file__).resolve().parents[2]


def _parser(apart: Sequence[Target]) -> argparse.ArgumentParser:
    """The parser of all commands, including those of the targets `apart`."""
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
        *((target.command, target.help) for target in apart),
        ("lint", "check spec/ only"),
        (
            "compat",
            "list the changes since another version of the spec; exit status 1 for breaks, or, since "
            "the last release, if the version is too low for them",
        ),
        ("record", "record the model as that of the release of this version"),
    ):
        sub = commands.add_parser(name, help=text, description=text)
        sub.add_argument("--root", type=Path, default=_ROOT, help="project folder")
        sub.add_argument("--spec", type=Path, help="spec folder, if not <root>/spec")
        if name == "compat":
            sub.add_argument(
                "old",
                metavar="OLD",
                nargs="?",
                help="spec folder, or git revision; default: the last release",
            )
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
        for target in (target for target in apart if target.command == name):
            text = f"output {'file' if target.file else 'folder'}, if not <root>/{_place(target)}"
            sub.add_argument("--output", type=Path, help=text)
    return parser


def _apart() -> list[Target]:
    """Targets that are not part of generated/; each has its own command."""
    from sbgcgen.targets import targets

    return [target for target in targets() if not target.committed]


def _place(target: Target) -> str:
    """The default output path of a target that is not part of generated/."""
    return f"build/{target.file or target.command}"


def _write_depfile(depfile: Path, stamp: Path, read: list[Path]) -> None:
    names = " \\\n  ".join(_escape(path) for path in sorted(read))
    depfile.parent.mkdir(parents=True, exist_ok=True)
    depfile.write_text(f"{_escape(stamp)}: \\\n  {names}\n", encoding="utf-8")


def _escape(path: Path) -> str:
    return re.sub(r"([ #\\])", r"\\\1", str(path)).replace("$", "$$")


def main(arguments: list[str] | None = None) -> int:
    """Run one command; returns 0, or 1 for findings. Usage errors exit with status 2."""
    arguments = sys.argv[1:] if arguments is None else arguments
    parser = _parser(() if arguments[:1] == ["generate"] else _apart())
    options = parser.parse_args(arguments)
    if getattr(options, "depfile", None) and not options.stamp:
        parser.error("--depfile needs --stamp")
    root: Path = options.root.resolve()
    spec_dir: Path = (options.spec or root / "spec").resolve()
    if options.command == "compat" and options.old is not None:
        from sbgcgen.compat import report

        return report.run(options.old, options.new, root, spec_dir)
    if options.command == "generate":
        return _generate(options, root, spec_dir)
    protocol = _load(spec_dir)
    if protocol is None:
        return 1
    layout = protocol.layout
    if options.command == "lint":
        print(f"{len(layout.commands)} commands, {len(layout.messages)} messages: no errors")
        return 0
    if options.command == "check":
        return _check(protocol, root)
    if options.command in ("compat", "record"):
        from sbgcgen.compat import release

        act = release.check if options.command == "compat" else release.record
        return act(layout, root, spec_dir)
    return _render_apart(options, protocol, root)


def _load(spec_dir: Path) -> Protocol | None:
    """The spec; None if it has errors, which are printed."""
    from sbgcgen.build import load_protocol
    from sbgcgen.spec.diagnostics import SpecError

    try:
        return load_protocol(spec_dir)
    except SpecError as error:
        print(error, file=sys.stderr)
        count = len(error.diagnostics)
        print(f"{count} error{'s' if count != 1 else ''} in {spec_dir.name}/", file=sys.stderr)
        return None


def _generate(options: argparse.Namespace, root: Path, spec_dir: Path) -> int:
    folder: Path = (options.output or root / "generated").resolve()
    record = Record(root, spec_dir, folder)
    unchanged = record.unchanged()
    try:
        if unchanged:
            count, spec_files = unchanged
            changed = 0
        else:
            from sbgcgen.output import Output
            from sbgcgen.targets import outputs

            protocol = _load(spec_dir)
            if protocol is None:
                return 1
            output = Output(folder, outputs(protocol.layout, root))
            changed = output.write()
            count, spec_files = len(output.files), protocol.spec.files
            record.write(output.files, spec_files)
        if options.depfile:
            _write_depfile(options.depfile, options.stamp, spec_files + inputs(root))
        if options.stamp:
            options.stamp.parent.mkdir(parents=True, exist_ok=True)
            options.stamp.touch()
    except OSError as error:
        return _cannot_write(error)
    print(f"{count} files, {changed} changed")
    return 0


def _check(protocol: Protocol, root: Path) -> int:
    from sbgcgen.output import Output
    from sbgcgen.targets import outputs

    drift = Output((root / "generated").resolve(), outputs(protocol.layout, root)).drift()
    for line in drift:
        print(line, file=sys.stderr)
    if drift:
        print("generated/ has drifted: run './dev generate'", file=sys.stderr)
    return 1 if drift else 0


def _render_apart(options: argparse.Namespace, protocol: Protocol, root: Path) -> int:
    from sbgcgen.output import Output

    target = next(target for target in _apart() if target.command == options.command)
    place: Path = (options.output or root / _place(target)).resolve()
    files = dict(target.files(protocol.layout, root))
    try:
        if target.file:
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(files[target.file])
            return 0
        output = Output(place, files, target.mark)
        changed = output.write()
    except OSError as error:
        return _cannot_write(error)
    print(f"{len(output.files)} files, {changed} changed")
    return 0


def _cannot_write(error: OSError) -> int:
    print(f"cannot write {error.filename}: {error.strerror}", file=sys.stderr)
    return 1
