"""Reading captures into numpy arrays; only this module needs numpy."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Union

from sbgc import _core
from sbgc.errors import DecodeError

if TYPE_CHECKING:
    from sbgc.tables import Capture

_CHUNK = 1 << 20


def read_capture(path: Union[str, os.PathLike[str]]) -> Capture:
    """Read a file that `sbgc record` or `connect(capture=...)` has written.

    Damaged frames are skipped and counted, as by `sbgc decode`. Raises DecodeError if the file is
    not a capture, and ImportError without numpy.
    """
    try:
        from sbgc.tables import Capture
    except ImportError as error:
        text = "read_capture() needs numpy: apt-get install python3-numpy, or pip install numpy"
        raise ImportError(text, name="numpy") from error
    reader = _core.CaptureReader()
    chunk = bytearray(_CHUNK)
    with open(path, "rb", buffering=0) as file:
        while size := file.readinto(chunk):
            reader.feed(memoryview(chunk)[:size])
    reader.finish()
    for is_something_else, text in reader.damage:
        if is_something_else:
            raise DecodeError(f"{os.fspath(path)}: {text}", "not_a_capture", "", 0)
    return Capture(reader)
