"""Writes a WebAssembly module as a script: embed.py MODULE.wasm OUTPUT.js VARIABLE"""

from __future__ import annotations

import base64
import sys
from pathlib import Path


def main(module: str, output: str, variable: str) -> None:
    text = base64.b64encode(Path(module).read_bytes()).decode("ascii")
    Path(output).write_text(
        "// The codec of sbgc as WebAssembly, in base64. Built from web/modules/.\n"
        f'"use strict";\nglobalThis.{variable} = "{text}";\n',
        encoding="ascii",
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
