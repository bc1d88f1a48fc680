"""Certificates for the tests of `sbgc gateway`."""

from __future__ import annotations

import subprocess
from pathlib import Path


def openssl(folder: Path, *arguments: str) -> None:
    subprocess.run(["openssl", *arguments], cwd=folder, check=True, capture_output=True)


def signed(folder: Path, name: str, days: int = 2) -> None:
    """A key and a certificate for 127.0.0.1, and for as many days."""
    openssl(folder, "req", "-newkey", "ed25519", "-nodes", "-keyout", f"{name}.key",
            "-out", f"{name}.csr", "-subj", f"/CN={name}")  # fmt: skip
    (folder / "names").write_text("subjectAltName=IP:127.0.0.1\n")
    openssl(folder, "x509", "-req", "-in", f"{name}.csr", "-CA", "ca.crt", "-CAkey", "ca.key",
            "-CAcreateserial", "-days", str(days), "-extfile", "names", "-out", f"{name}.crt")  # fmt: skip


def certificates(folder: Path) -> None:
    """Makes a CA, and a key and a certificate of the broker and of the gateway."""
    folder.mkdir(exist_ok=True)
    openssl(folder, "req", "-x509", "-newkey", "ed25519", "-nodes", "-keyout", "ca.key",
            "-out", "ca.crt", "-days", "2", "-subj", "/CN=test")  # fmt: skip
    for name in ("server", "sbgc-gateway"):
        signed(folder, name)
