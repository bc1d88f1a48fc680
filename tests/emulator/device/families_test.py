"""Every request with its own handler is handled in the folder of its family."""

import json
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
DEVICE = ROOT / "emulator/device"
MODEL = json.loads((ROOT / "generated/simplebgc.json").read_text())
FAMILY = {message["name"]: message["family"] for message in MODEL["messages"]}
HANDLER = re.compile(
    r"^Reaction handle\(\s*RequestContext&[ \w]*,\s*const msg::(\w+)&", re.MULTILINE
)


def test_handlers_are_in_the_folder_of_their_family() -> None:
    for source in DEVICE.rglob("*.cpp"):
        families = {FAMILY[request] for request in HANDLER.findall(source.read_text())}
        assert families <= {source.parent.name}, source


def test_every_declared_handler_is_defined() -> None:
    declared = HANDLER.findall((DEVICE / "handlers.hpp").read_text())
    defined = [name for path in DEVICE.rglob("*.cpp") for name in HANDLER.findall(path.read_text())]
    assert sorted(declared) == sorted(defined)
