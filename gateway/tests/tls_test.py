"""Tests of the messages of `sbgc gateway` about a broker without TLS."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path

from brokers import Mosquitto, free_port
from certificates import certificates, signed
from gateway import Gateway, eventually, running_gateway


def listener(port: int, authority: Path, name: str, more: str = "", host: str = "127.0.0.1") -> str:
    files = f"certfile {authority}/{name}.crt\nkeyfile {authority}/{name}.key\n"
    return f"listener {port} {host}\ncafile {authority}/ca.crt\n{files}{more}"


def fleet(addresses: list[str], more: str) -> str:
    return (
        f'[fleet]\nname = "studio"\n[broker]\naddress = {addresses}\njournal = "fleet.db"\n{more}\n'
        '[gimbal.front]\nport = "tcp:127.0.0.1:1"\n'
    )


def says(gateway: Gateway, *words: str) -> bool:
    return any(all(word in line for word in words) for line in gateway.log.read_text().split("\n"))


def test_each_failure_has_its_sentence(tmp_path: Path) -> None:
    ours, theirs = tmp_path / "ours", tmp_path / "theirs"
    certificates(ours)
    certificates(theirs)
    signed(ours, "expired", -1)
    good, other, expired, unknown, strict = (free_port() for _ in range(5))
    settings = (
        "allow_anonymous true\n"
        + listener(good, ours, "server")
        + listener(other, ours, "server", host="127.0.0.2")
        + listener(expired, ours, "expired")
        + listener(unknown, theirs, "server")
        + listener(strict, ours, "server", "require_certificate true\n")
    )
    broker = Mosquitto(tmp_path / "broker", settings)
    with ExitStack() as stack:
        stack.callback(broker.kill)
        broker.start()

        def run(name: str, ports: list[int | str], more: str) -> Gateway:
            (tmp_path / name).mkdir()
            addresses = [one if isinstance(one, str) else f"127.0.0.1:{one}" for one in ports]
            return stack.enter_context(running_gateway(tmp_path / name, fleet(addresses, more)))

        ca = f'ca-file = "{ours}/ca.crt"\n'
        places: list[int | str] = [expired, f"127.0.0.2:{other}", unknown, broker.port, strict]
        theirs_too = f'certificate-file = "{theirs}/server.crt"\nkey-file = "{theirs}/server.key"'
        of_versions = [run("three", places, ca), run("five", places, ca + 'mqtt = "5"')]
        without_tls = run("without", [good], "")
        refused = run("refused", [strict], ca + theirs_too)
        for gateway in of_versions:
            for port, *words in (
                (expired, "has expired", "needs a new one"),
                (other, "for another host", "'address' must be a name", "have 127.0.0.2"),
                (unknown, "not in 'ca-file'", f"{ours}/ca.crt", "add the certificate"),
                (broker.port, "no TLS at", "8883"),
                (strict, "a certificate of the gateway", "'certificate-file' and 'key-file'"),
            ):
                eventually(lambda: says(gateway, f":{port}", *words))
            assert "TLS error" not in gateway.log.read_text()
            assert gateway.log.read_text().count("for another host") == 1
        eventually(lambda: says(without_tls, f"127.0.0.1:{good}", "needs 'ca-file'"))
        eventually(lambda: says(refused, f":{strict}", "another certificate", "theirs/server.crt"))
