"""A small WebSocket client for the tests, after RFC 6455."""

from __future__ import annotations

import base64
import hashlib
import os
import socket
import struct
from typing import Optional

GUID = b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11"


class WebSocket:
    """Connects on construction; `status` is that of the HTTP response, 101 for success."""

    def __init__(
        self,
        address: str,
        query: str = "",
        origin: Optional[str] = None,
        protocols: Optional[str] = None,
        behind: bytes = b"",
    ) -> None:
        place = address.removeprefix("ws://").split("/")[0]
        host, port = place.rsplit(":", 1)
        self.socket = socket.create_connection((host, int(port)), timeout=20)
        self.stream = self.socket.makefile("rb")
        key = base64.b64encode(os.urandom(16))
        lines = [
            f"GET /{query} HTTP/1.1",
            f"Host: {place}",
            "Upgrade: websocket",
            "Connection: Upgrade",
            f"Sec-WebSocket-Key: {key.decode()}",
            "Sec-WebSocket-Version: 13",
        ]
        if origin is not None:
            lines.append(f"Origin: {origin}")
        if protocols is not None:
            lines.append(f"Sec-WebSocket-Protocol: {protocols}")
        self.socket.sendall(("\r\n".join(lines) + "\r\n\r\n").encode() + behind)
        self.status = int(self.stream.readline().split()[1])
        self.headers = {}
        while line := self.stream.readline().strip():
            name, value = line.decode().split(":", 1)
            self.headers[name.lower()] = value.strip()
        if self.status == 101:
            accept = base64.b64encode(hashlib.sha1(key + GUID).digest()).decode()
            assert self.headers["sec-websocket-accept"] == accept

    def send(self, data: bytes, opcode: int = 2) -> None:
        mask = os.urandom(4)
        size = len(data)
        head = bytes([0x80 | opcode])
        head += bytes([0x80 | size]) if size < 126 else b"\xfe" + struct.pack(">H", size)
        self.socket.sendall(head + mask + bytes(b ^ mask[i % 4] for i, b in enumerate(data)))

    def receive(self) -> tuple[int, bytes]:
        """Returns opcode and data of the next frame."""
        first, second = self.stream.read(2)
        size = second & 0x7F
        if size == 126:
            (size,) = struct.unpack(">H", self.stream.read(2))
        return first & 0x0F, self.stream.read(size)

    def close(self) -> None:
        self.stream.close()
        self.socket.close()
