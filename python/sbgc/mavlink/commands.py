"""Commands and their answers, and the list of parameters, which ground stations ask of all components."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Optional

from sbgc.mavlink.codec import Message
from sbgc.mavlink.protocol import Ids, Result

if TYPE_CHECKING:
    from sbgc.mavlink.device import Device

PARAMETER = "STATUS_RATE"
REAL32 = 9


@dataclass(frozen=True)
class Order:
    """COMMAND_LONG or COMMAND_INT: seven numbers; the fifth and sixth of COMMAND_INT are integers."""

    command: int
    parameters: tuple[float, ...]
    sender: Ids


def answer(device: Device, message: Message, execute: Callable[[Order], Optional[Result]]) -> None:
    """Execute a command and acknowledge it. To all, only who supports a command answers."""
    values = message.values
    names = [f"param{number}" for number in range(1, 8)]
    if message.name == "COMMAND_INT":
        names[4:] = ["x", "y", "z"]
    order = Order(values.command, tuple(getattr(values, name) for name in names), message.sender)
    result = execute(order)
    if result is None:
        device.vehicle.counters["unsupported"] += 1
        if not values.target_component:
            return
        result = Result.UNSUPPORTED
    to = {"target_system": message.system, "target_component": message.component}
    device.reports.send("COMMAND_ACK", command=order.command, result=int(result), **to)


def answer_parameters(device: Device, message: Message, rate: float) -> None:
    """Tell the only parameter, the rate of statuses; who sets it is told that it has not changed."""
    values = message.values
    is_named = getattr(values, "param_id", PARAMETER).rstrip("\0") == PARAMETER
    if not is_named and getattr(values, "param_index", -1) != 0:
        return
    place = {"param_type": REAL32, "param_count": 1, "param_index": 0}
    device.reports.send("PARAM_VALUE", param_id=PARAMETER.encode(), param_value=rate, **place)
