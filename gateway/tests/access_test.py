"""Access to the broker: passwords, certificates, the sample ACL, and MQTT 5; and the gateway's warning about
a broker without TLS."""

from __future__ import annotations

import json
import subprocess
from contextlib import ExitStack, closing
from pathlib import Path

from brokers import (
    Commander,
    Mosquitto,
    Subscriber,
    certificates,
    client,
    program,
    signed,
)
from gateway import Gateway, eventually, running_gateway
from sbgc_command import free_port
from studio import fleet_of, gimbal_of, running_studio

ACL = Path(__file__).parents[1] / "deploy/mosquitto.acl"


def passwords(folder: Path, *users: str) -> Path:
    file = folder / "passwords"
    file.touch(mode=0o600)
    for user in users:
        subprocess.run(
            [program("mosquitto_passwd"), "-b", str(file), user, f"{user}-secret"],
            check=True,
            capture_output=True,
        )
    return file


def secret_file(folder: Path, text: str) -> None:
    file = folder / "broker.password"
    file.touch(mode=0o600)
    file.write_text(text + "\n")


def login(user: str) -> tuple[str, ...]:
    return ("-u", user, "-P", f"{user}-secret")


def test_the_sample_of_an_acl(tmp_path: Path) -> None:
    users = passwords(tmp_path, "sbgc-gateway", "viewer", "operator")
    secret_file(tmp_path, "sbgc-gateway-secret")
    settings = f"allow_anonymous false\npassword_file {users}\nacl_file {ACL}\n"
    own = 'user = "sbgc-gateway"\npassword-file = "broker.password"'
    viewer, operator = login("viewer"), login("operator")
    with (
        running_studio(tmp_path, own, of_broker=settings, user=viewer) as studio,
        closing(Subscriber(studio.broker.port, "sbgc/#", *operator)) as mine,
    ):
        by_operator = Commander(studio.broker.port, "studio", *operator)
        box = "sbgc/studio/reply/operator/1"
        # The broker does not deliver these to the gateway: `raw`, and everything from the viewer.
        by_operator.command("front", "raw", {"message": "GetAnglesRequest"}, key="raw", reply=box)
        studio.say.command("front", "home", key="viewer", reply=box)
        by_operator.command("front", "home", key="home", reply=box)
        assert mine.result("home")["key"] == "home"
        assert {one["key"] for one in mine.results()} == {"home"}
        # No other user sees the results, and none sees the commands.
        assert not studio.seen.results()
        heard = studio.seen.messages + mine.messages
        assert not [one for one in heard if "/cmd/" in one.topic]


def test_a_wrong_password_is_reported(tmp_path: Path) -> None:
    users = passwords(tmp_path, "sbgc-gateway")
    secret_file(tmp_path, "wrong-secret")
    settings = f"allow_anonymous false\npassword_file {users}\n"
    own = 'user = "sbgc-gateway"\npassword-file = "broker.password"'
    user = login("sbgc-gateway")
    with running_studio(tmp_path, own, of_broker=settings, user=user, waits=False) as studio:
        log = studio.gateway.log
        eventually(lambda: "no connection to the broker" in log.read_text())
        eventually(lambda: "not authorised" in log.read_text())
        assert "wrong-secret" not in log.read_text()
        assert studio.gateway.end() == 0


def tls(folder: Path) -> str:
    return (
        f"cafile {folder}/ca.crt\ncertfile {folder}/server.crt\nkeyfile {folder}/server.key\n"
        f"require_certificate true\nuse_identity_as_username true\nacl_file {ACL}\n"
    )


def test_tls_with_certificates(tmp_path: Path) -> None:
    certificates(tmp_path)
    own = 'ca-file = "ca.crt"\ncertificate-file = "sbgc-gateway.crt"\nkey-file = "sbgc-gateway.key"'
    words = ("--cafile", "ca.crt", "--cert", "sbgc-gateway.crt", "--key", "sbgc-gateway.key")
    user = tuple(str(tmp_path / one) if "." in one else one for one in words)
    with running_studio(tmp_path, own, of_broker=tls(tmp_path), user=user) as studio:
        assert studio.result("home")["status"] in ("done", "failed")
        # It reconnects.
        studio.broker.kill()
        studio.broker.start()
        with closing(Subscriber(studio.broker.port, "sbgc/#", *user)) as seen:
            seen.wait_for()


def test_mqtt_5_has_its_properties(tmp_path: Path) -> None:
    box = "sbgc/studio/reply/five"
    with running_studio(tmp_path, 'mqtt = "5"') as studio:
        broker, seen = studio.broker, studio.seen
        once = f"-V 5 -t {box} -C 1 -F %C|%D|%p".split()
        replies = subprocess.Popen(
            [*client("mosquitto_sub", broker.port), *once], stdout=subprocess.PIPE, text=True
        )
        try:
            eventually(lambda: f"{box} (QoS 1)" in broker.log.read_text())
            said = f"-D publish response-topic {box} -D publish correlation-data c9".split()
            say = Commander(broker.port, "studio", "-V", "5")
            payload = say.payload(reply=None)
            say.publish("sbgc/studio/front/cmd/home", json.dumps(payload), *said)
            out, _ = replies.communicate(timeout=60)
        finally:
            replies.kill()
        kind, data, text = out.strip().split("|", 2)
        assert kind == "application/json" and data == "c9"
        result = json.loads(text)
        assert result["key"] == payload["key"] and result["correlation"] == "c9"
        # Also instead of the members: the key, and the deadline.
        bare = say.payload(key=None, deadline=None)
        said = "-D publish user-property key k5 -D publish message-expiry-interval 20".split()
        say.publish("sbgc/studio/front/cmd/home", json.dumps(bare), *said)
        assert seen.result("k5")["status"] in ("done", "failed")
        # The session outlives the gateway.
        assert studio.gateway.end() == 0
        key = say.command("front", "raw", {"message": "GetAnglesRequest"})
        studio.gateway.restart()
        assert seen.result(key)["status"] in ("done", "failed")


def listener(port: int, authority: Path, name: str, more: str = "", host: str = "127.0.0.1") -> str:
    files = f"certfile {authority}/{name}.crt\nkeyfile {authority}/{name}.key\n"
    return f"listener {port} {host}\ncafile {authority}/ca.crt\n{files}{more}"


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
            text = fleet_of(str(addresses), gimbal_of("tcp:127.0.0.1:1"), settings=more)
            return stack.enter_context(running_gateway(tmp_path / name, text))

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
