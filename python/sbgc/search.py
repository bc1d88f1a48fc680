"""The search for gimbals on the serial ports of this machine."""

from __future__ import annotations

from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Optional, Union

from sbgc import _core
from sbgc.client import connect
from sbgc.emulator import Board
from sbgc.errors import GimbalError
from sbgc.link import Identity, Path, seconds_of

# All of them are opened at the same time.
_MOST_PORTS = 128


@dataclass(frozen=True)
class Usb:
    """The identity of a USB adapter; missing texts are ""."""

    vendor_id: int
    product_id: int
    manufacturer: str
    product: str
    serial_number: str


@dataclass(frozen=True)
class Port:
    """A serial port; `usb` is only set for USB adapters."""

    name: str
    description: str
    usb: Optional[Usb]


@dataclass(frozen=True)
class Found:
    """A gimbal, and the address for connect()."""

    place: Union[Path, Board]
    identity: Identity


def ports() -> list[Port]:
    """Return the serial ports of this machine."""
    return [
        Port(name, description, None if usb is None else Usb(*usb))
        for name, description, usb in _core.list_ports()
    ]


def find(
    places: Optional[Iterable[Union[Path, Board]]] = None, *, timeout: float = 5.0
) -> list[Found]:
    """Return the gimbals that answer at these places, or at all serial ports of this machine.

    If there are USB adapters, only these are probed, as by the command.
    """
    if isinstance(places, (str, Board)) or not isinstance(places, (Iterable, type(None))):
        raise TypeError(f"places: a list of addresses or boards is needed, not {places!r}")
    seconds_of(timeout)  # raises an error if it is invalid
    asked = searched() if places is None else list(places)
    if not asked:
        return []
    with ThreadPoolExecutor(min(len(asked), _MOST_PORTS)) as pool:
        return [found for found in pool.map(lambda place: _ask(place, timeout), asked) if found]


def searched() -> list[Union[Path, Board]]:
    """Return the names of the ports where a gimbal is likely."""
    all_ports = ports()
    adapters = [port for port in all_ports if port.usb is not None]
    return [port.name for port in adapters or all_ports]


def _ask(place: Union[Path, Board], timeout: float) -> Optional[Found]:
    try:
        with connect(place, timeout=timeout) as gimbal:
            return Found(place, gimbal.identity)
    except GimbalError:
        return None
