"""The fleet `studio` for the tests of `sbgc gateway`: a broker, a gateway with a gimbal, and a client."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, closing, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from brokers import Commander, Mosquitto, Subscriber
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from gateway import Gateway, eventually, running_gateway


def fleet_of(addresses: str, *gimbals: str, settings: str = "") -> str:
    """The text of a fleet; `settings` apply to the broker."""
    head = f'[fleet]\nname = "studio"\n[broker]\naddress = {addresses}\njournal = "fleet.db"\n'
    return "\n".join([head, settings, *gimbals])


def gimbal_of(address: str, allow: str = "", *more: str, name: str = "front") -> str:
    """The text of a gimbal, which performs the tasks in `allow`."""
    tasks = ", ".join(f'"{task}"' for task in allow.split())
    return "\n".join(
        [f'[gimbal.{name}]\nport = "{address}"', f"allow = [{tasks}]" if allow else "", *more, ""]
    )


class Conversation:
    """Commands for the gimbal `front`, and their results."""

    seen: Subscriber
    say: Commander

    def result(self, task: str, parameters: Any = None, **members: Any) -> Any:
        return self.seen.result(self.say.command("front", task, parameters, **members))

    def moved(self, pitch: float, **members: Any) -> Any:
        """The result of a move. On a busy machine, the emulated board may answer too late for one."""
        for _ in range(5):
            target = {"angles": {"pitch": pitch}, "speed": 30}
            result = self.result("move", target, **members)
            if result["status"] == "done" or result["error"]["code"] != "timeout":
                break
        assert result["status"] == "done", result
        return result


@dataclass
class Studio(Conversation):
    broker: Mosquitto
    gateway: Gateway
    front: EmulatedGimbal
    seen: Subscriber
    say: Commander


@contextmanager
def running_broker(folder: Path, settings: str = "allow_anonymous true\n") -> Iterator[Mosquitto]:
    broker = Mosquitto(folder / "broker", settings)
    broker.start()
    try:
        yield broker
    finally:
        broker.kill()


@contextmanager
def running_studio(
    folder: Path,
    settings: str = "",
    *,
    of_broker: str = "allow_anonymous true\n",
    user: tuple[str, ...] = (),
    allow: str = "move motors get set home raw",
    more: str = "",
    waits: bool = True,
) -> Iterator[Studio]:
    """`more` goes to the gimbal. Waits until that is online, and motion is no longer refused as queued."""
    with ExitStack() as stack:
        broker = stack.enter_context(running_broker(folder, of_broker))
        front = stack.enter_context(emulated_gimbal())
        seen = stack.enter_context(closing(Subscriber(broker.port, "sbgc/#", *user)))
        gimbal = gimbal_of(front.address, allow, more)
        text = fleet_of(f'"127.0.0.1:{broker.port}"', gimbal, settings=settings)
        gateway = stack.enter_context(running_gateway(folder, text))
        if waits:
            seen.wait_for()
            eventually(lambda: "'sbgc/studio/gateway/raw'" in broker.log.read_text())
        yield Studio(broker, gateway, front, seen, Commander(broker.port, "studio", *user))
