"""The configuration of `sbgc gateway`."""

from __future__ import annotations

from pathlib import Path

import pytest

from sbgc_command import run

FLEET = """[fleet]
name = "studio"
[metrics]
[gimbal.front]
port = "tcp:127.0.0.1:1"
"""
SAMPLE = Path(__file__).parents[1] / "deploy/fleet.toml"


def test_the_sample_is_a_fleet(tmp_path: Path) -> None:
    file = tmp_path / "fleet.toml"
    file.write_text(SAMPLE.read_text().replace("/var/lib/sbgc-gateway", str(tmp_path)))
    result = run("gateway", "--config", str(file), "--check")
    assert result.status == 0 and "studio: 2 gimbals" in result.error


@pytest.mark.parametrize(
    "text, place, reason",
    [
        ("", "1:1", "[fleet] with its name"),
        ('[fleet]\nname = "Studio"\n', "2:8", "'Studio' cannot be a part of a topic"),
        (
            '[fleet]\nname = "a"\n[metrics]\n',
            "1:1",
            "a section [gimbal.NAME] with a port is missing",
        ),
        (FLEET.replace("[metrics]\n", ""), "1:1", "[metrics] or [broker]"),
        (FLEET + '[gimbal."a/b"]\n', "6:1", "'a/b' cannot be a part of a topic"),
        (FLEET + "[gimbal.reply]\n", "6:1", "'reply' has another meaning"),
        (FLEET + "[gimbal.front]\n", "6:1", "cannot redefine existing table 'gimbal.front'"),
        (FLEET + "[gimbals.back]\n", "6:1", "did you mean 'gimbal'?"),
        (
            FLEET + 'prot = "x"\n',
            "6:1",
            "unknown key 'prot' of [gimbal.front]; did you mean 'port'?",
        ),
        (FLEET + 'allow = ["mov"]\n', "6:10", "no task 'mov'; did you mean 'move'?"),
        (FLEET + 'raw-effects = ["reads",\n  "explodes"]\n', "7:3", "no effect 'explodes'"),
        (FLEET + 'units = "V"\n', "6:9", '\'units\' must be "yes" or "no"'),
        (FLEET + 'telemetry = ["RealtimeData4"]\n', "6:14", "is not a message and its rate"),
        (FLEET + 'telemetry = "RealtimeDat4 1"\n', "6:13", "did you mean 'RealtimeData4'"),
        (
            FLEET + 'telemetry = "RealtimeDataCustom 1"\n',
            "6:13",
            "say what RealtimeDataCustom contains",
        ),
        (
            FLEET + 'telemetry = ["RealtimeData4 1", "REALTIME_DATA_4 2"]\n',
            "6:33",
            "RealtimeData4 is there twice",
        ),
        (FLEET + 'password-file = "-"\n', "6:17", "nobody to ask"),
        (FLEET + "[broker]\n", "6:1", "[broker] has no address"),
        (FLEET + '[broker]\naddress = "a:b"\n', "7:11", "'a:b' is not an address"),
        (FLEET + '[broker]\naddress = "a"\nmqtt = "4"\n', "8:8", 'must be "3.1.1" or "5"'),
        (FLEET + '[broker]\naddress = "a"\nkeep-alive = "100000s"\n', "8:14", "at most 65535 s"),
        (FLEET + '[broker]\naddress = "a"\nstop-after = "100h"\n', "8:14", "at most 60 s"),
        (FLEET + '[broker]\naddress = "a"\nclock-skew = "2m"\n', "8:14", "at most 60 s"),
        (FLEET + '[broker]\naddress = "a"\nlongest-deadline = "25h"\n', "8:20", "at most 86400 s"),
        (FLEET + '[broker]\naddress = "a"\nkey-file = "k"\n', "8:12", "belong together"),
        (FLEET.replace("[metrics]", '[metrics]\nlisten = "9110"'), "4:10", "and a port"),
        (FLEET + 'allow = ["move\n', "6:15", "Error while parsing string"),
        (FLEET + "allow = [move]\n", "6:10", "texts need quotes"),
        (FLEET + 'allow = ["move" "stop"]\n', "6:17", "expected comma or closing ']'"),
        (FLEET + "attempts = 3 4\n", "6:14", "expected a comment or whitespace"),
        (FLEET + 'port = "y"\n', "6:8", "cannot redefine existing string 'port'"),
    ],
)
def test_mistakes(tmp_path: Path, text: str, place: str, reason: str) -> None:
    file = tmp_path / "fleet.toml"
    file.write_text(text)
    result = run("gateway", "--config", str(file), "--check")
    assert result.status == 1 and f"{file}:{place}: " in result.error
    assert reason in " ".join(result.error.split())


def test_names_and_values_of_toml(tmp_path: Path) -> None:
    file = tmp_path / "fleet.toml"
    file.write_text(
        "fleet.name = 'a' # the first letter\r\n\r\n[metrics]\r\n"
        '[ gimbal . "b" ]\n"port" = "t\\u0063p:127.0.0.1:1"\nallow = [ # two\n  "move",\n  \'stop\',\n]\n'
    )
    result = run("gateway", "--config", str(file), "--check")
    assert result.status == 0 and "a: 1 gimbal" in result.error


def test_files_count_from_the_configuration(tmp_path: Path) -> None:
    file = tmp_path / "fleet.toml"
    file.write_text(FLEET + 'password-file = "front.password"\n')
    result = run("gateway", "--config", str(file), "--check")
    assert result.status == 1 and f"{tmp_path}/front.password" in result.error
