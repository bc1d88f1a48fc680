"""Frequency responses: recordings, their files, and gain and phase."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional, Union

from sbgc import _core
from sbgc.message import wrap
from sbgc.msg import BodeTestStartStopRequest

HIGHEST = 500.0
"""Hz; the upper end of a response."""


@dataclass(frozen=True)
class ResponsePoint:
    """The response at one frequency.

    `gain` is in dB, `phase` in degrees without jumps. `coherence` is the share of the output that follows
    the input, and `deviation` the uncertainty of the response, as a share of it: 95 % deviate by less than
    twice that. Both are None for recordings of fewer than four segments.
    """

    frequency: float
    response: complex
    gain: float
    phase: float
    coherence: Optional[float]
    deviation: Optional[float]


@dataclass(frozen=True)
class BodeRecording:
    """The input and the output of an axis, every 0.8 ms. A lost sample is NaN in both.

    `end_lost` is true if the final message was lost: the board may have reported an error in it.
    """

    request: BodeTestStartStopRequest
    input: list[float]
    output: list[float]
    lost: int
    end_lost: bool = False

    def response(
        self, start: Optional[float] = None, end: Optional[float] = None
    ) -> list[ResponsePoint]:
        """Return gain and phase between two frequencies; by default those of the request."""
        low = float(self.request.start_freq) if start is None else start
        high = min(float(self.request.end_freq), HIGHEST) if end is None else end
        _, points = _core.frequency_response(self.input, self.output, low, high)
        return [ResponsePoint(*point) for point in points]

    def csv(self) -> str:
        """Return the recording in the format of the vendor's program."""
        return _core.bode_csv(self.request._message, self.input, self.output)


def recording_of(found: Any) -> BodeRecording:
    request, *samples = found
    wrapped = wrap(request)
    assert isinstance(wrapped, BodeTestStartStopRequest)
    return BodeRecording(wrapped, *samples)


def read_bode(file: Union[str, Path]) -> BodeRecording:
    """Read a recording of the vendor's program, `sbgc bode -o` or BodeRecording.csv()."""
    with Path(file).open("rb") as opened:
        text = opened.read(_core.MAX_BODE_CSV + 1)  # parsing refuses what is longer
    try:
        return recording_of(_core.parse_bode_csv(text))
    except ValueError as error:
        raise ValueError(f"{file}: {error}") from None
