"""Tests of sbgc params with emulated boards."""

from __future__ import annotations

import json
import os
import re
import resource
import signal
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from board_command import Watched, answer_on_terminal
from emulated_gimbal import emulated_gimbal
from sbgc_command import MODEL, PROGRAM, Result, decode, run


@pytest.fixture(name="board", scope="module")
def fixture_board() -> Iterator[str]:
    with emulated_gimbal() as gimbal:
        yield gimbal.address


@pytest.fixture(name="other_board")
def fixture_other_board() -> Iterator[str]:
    """A board whose parameters a test may change."""
    with emulated_gimbal() as gimbal:
        yield gimbal.address


def words(text: str) -> str:
    """Undoes the breaks of lines."""
    return " ".join(text.split())


def params(board: str, *arguments: str) -> Result:
    return run("params", *arguments, "-p", board)


def good(board: str, *arguments: str) -> str:
    result = params(board, *arguments)
    assert result.status == 0, result
    return result.text


def body_of(board: str, profile: int, message: str = "ReadParams3Request") -> dict[str, Any]:
    """The fields of a profile, counted from 0, read without `params`."""
    sent = run("send", message, f"profile_id={profile}", "--format", "jsonl", "-p", board)
    return sent.objects[0]["fields"]


def sets_in(path: Path) -> dict[tuple[str, int], str]:
    document = json.loads(path.read_text())
    return {(one["message"], one["copy"]): one["body"] for one in document["settings"]}


def test_show_lists_the_parameters_in_their_units(board: str) -> None:
    text = good(board, "show")
    assert text.startswith("profile 1, which is active\n")
    lines = dict(re.findall(r"^  ([a-z]\S*) +(.*)$", text, re.MULTILINE))
    fields = body_of(board, 0)
    assert lines["axes.pitch.p"] == str(fields["axes"]["pitch"]["p"])
    assert lines["rc.yaw.rc_max_angle"] == f"{fields['rc']['yaw']['rc_max_angle']} deg"
    assert "cur_profile_id" not in lines, "a state is not a parameter"
    filtered = good(board, "show", "RC_MIN")
    assert filtered.count("rc_min_angle") == 3 and "axes.pitch.p" not in filtered
    assert params(board, "show", "nonsense").status == 1


def test_show_groups_by_topic(board: str) -> None:
    """In the order of the model; each parameter once, in the first of its topics."""
    groups = re.split(r"^([a-z]+): .*\n", good(board, "show"), flags=re.MULTILINE)[1:]
    names = [topic["name"] for topic in MODEL["topics"]]
    assert [name for name in names if name in groups[::2]] == groups[::2]
    leaves = {
        leaf["path"]: leaf["topics"][0]
        for message in MODEL["messages"]
        if message["name"].startswith("ReadParams") and not message["name"].endswith("Request")
        for leaf in message["layout"]
        if "topics" in leaf
    }
    shown = {
        path: topic
        for topic, lines in zip(groups[::2], groups[1::2])
        for path in re.findall(r"^  ([a-z]\S*) ", lines, re.MULTILINE)
    }
    assert len(shown) > 150 and shown["axes.pitch.p"] == "pid" and shown["gyro_trust"] == "imu"
    assert {path: leaves[path] for path in shown if path in leaves}.items() <= shown.items()


@pytest.mark.parametrize(
    "words, paths, others",
    [
        (["pid"], ["axes.roll.p", "outer_i.yaw", "pid_gain.pitch"], ["gyro_trust"]),
        (["gain"], ["axes.roll.p", "notch1_gain.roll"], ["gyro_trust"]),
        (["tilt", "limit"], ["rc.pitch.rc_max_angle"], ["rc.yaw.rc_max_angle", "axes.pitch.p"]),
        (["compass"], ["mag_trust"], ["gyro_trust"]),
        (["SPEED"], ["follow_speed.roll", "rc.roll.rc_speed"], ["axes.roll.p"]),
        (["jello"], ["lpf_freq.roll"], ["axes.roll.p"]),
        (["shake"], ["lpf_freq.roll"], ["axes.roll.p"]),
        (["P_PITCH"], ["axes.pitch.p"], ["axes.roll.p"]),
    ],
)
def test_show_finds_words_that_people_use(
    board: str, words: list[str], paths: list[str], others: list[str]
) -> None:
    document = json.loads(good(board, "show", *words, "--format", "json"))
    found = [one["path"] for one in document["parameters"]]
    for path in paths:
        assert path in found, path
    for path in others:
        assert path not in found, path


@pytest.mark.parametrize("command", ["show", "get"])
def test_parameters_of_later_firmware(board: str, command: str) -> None:
    result = params(board, command, "amplitude")
    assert result.status == 1 and result.error == (
        "sbgc: this board does not have ReadParamsExt3; it needs firmware 2.66\n"
    )


def test_values_are_those_of_the_firmware() -> None:
    """The gains are logarithmic from firmware 2.73.1 on: 5 * 52^(raw / 255) - 5."""
    for firmware, raw, shown in (("2.73", 20, "20"), ("2.74.5", 104, "20.0513")):
        with emulated_gimbal("--firmware", firmware) as gimbal:
            text = good(gimbal.address, "set", "pitch.p=20", "--yes")
            assert f" -> {shown}\n" in text
            assert body_of(gimbal.address, 0)["axes"]["pitch"]["p"] == raw
            assert f"axes.pitch.p = {shown}\n" in good(gimbal.address, "get", "pitch.p")
            assert params(gimbal.address, "set", "pitch.p=300", "--yes").status == 2


def test_every_name_of_the_model_is_found(board: str) -> None:
    """Each path of the message can be read, and has the value of the frame."""
    shown = json.loads(good(board, "show", "ReadParams3.", "--format", "json"))
    assert shown["version"] == 1
    paths = {one["path"] for one in shown["parameters"]}
    (message,) = [one for one in MODEL["messages"] if one["name"] == "ReadParams3"]
    for leaf in message["layout"]:
        is_parameter = not leaf["reserved"] and leaf["path"] not in (
            "profile_id",
            "cur_imu",
            "cur_profile_id",
        )
        assert (leaf["path"] in paths) == is_parameter, leaf["path"]
    by_path = {one["path"]: one for one in shown["parameters"]}
    assert by_path["axes.roll.i"]["value"] == pytest.approx(
        int(by_path["axes.roll.i"]["raw"]) / 100
    )
    assert by_path["general_flags1"]["general"]


@pytest.mark.parametrize(
    "name, paths",
    [
        ("axes.pitch.p", ["axes.pitch.p"]),
        ("pitch.p", ["axes.pitch.p"]),
        ("RC_MAP_PITCH", ["rc_map.pitch"]),
        ("rc_min_angle", ["rc.roll.rc_min_angle", "rc.pitch.rc_min_angle", "rc.yaw.rc_min_angle"]),
        (
            "axes.roll",
            [f"axes.roll.{name}" for name in ("p", "i", "d", "power", "invert", "poles")],
        ),
        ("ReadParams3.gyro_trust", ["gyro_trust"]),
        ("P_PITCH", ["axes.pitch.p"]),
        ("pid_gain_YAW", ["pid_gain.yaw"]),
        ("PITCH_P", ["axes.pitch.p"]),
        ("tilt_lpf_freq", ["lpf_freq.pitch"]),
        ("tilt.p", ["axes.pitch.p"]),
        ("lpf_freq.pan", ["lpf_freq.yaw"]),
    ],
)
def test_names(board: str, name: str, paths: list[str]) -> None:
    found = json.loads(good(board, "get", name, "--format", "json"))
    assert [one["path"] for one in found["parameters"]] == paths


@pytest.mark.parametrize(
    "name, words",
    [
        ("pitch.q", ["pitch.q", "'pitch.p'"]),
        ("cur_imu", ["cur_imu", "state"]),
        ("gyro_trst", ["'gyro_trust'"]),
        ("a..b", ["a..b"]),
    ],
)
def test_names_that_are_wrong(board: str, name: str, words: list[str]) -> None:
    result = params(board, "get", name)
    assert result.status == 2
    for word in words:
        assert word in result.error


def test_get_explains(board: str) -> None:
    text = good(board, "get", "pitch.rc_min_angle")
    assert text.splitlines()[0] == "rc.pitch.rc_min_angle = -45 deg"
    assert "-720 to 720 deg" in text
    # A note that several parameters share comes once, after the last of them.
    lines = good(board, "get", "rc_min_angle", "gyro_trust").splitlines()
    values = [i for i, line in enumerate(lines) if " = " in line]
    assert values[:3] == [0, 1, 2] and values[3] > 4 and lines[-1] == "    0 to 255"
    assert lines.count("    -720 to 720 deg") == 1 and "    -720 to 720 deg" in lines[: values[3]]


def test_get_reads_only_what_it_prints(board: str) -> None:
    frames = params(board, "get", "lpf_freq", "--profile", "2", "--verbose").error
    asked = re.findall(r"host to board, .*  (\w+)$", frames, re.MULTILINE)
    # ReadParams3 has the active profile.
    assert {name for name in asked if name.startswith("Read")} == {
        "ReadParams3Request",
        "ReadParamsExtRequest",
    }


def test_set_changes_one_profile_and_nothing_else(board: str) -> None:
    before = {profile: body_of(board, profile) for profile in range(5)}
    text = good(board, "set", "pitch.p=20", "--profile", "2", "--yes")
    assert text == "ReadParams3 of profile 2:\n  axes.pitch.p: 14 -> 20\n"
    before[1]["axes"]["pitch"]["p"] = 20
    assert {profile: body_of(board, profile) for profile in range(5)} == before
    again = params(board, "set", "pitch.p=20", "--profile", "2")
    assert (again.status, again.text) == (0, "profile 2: nothing to change\n")


def test_set_takes_units_names_and_all_axes(board: str) -> None:
    text = good(
        board,
        "set",
        "rc_min_angle=-30deg",
        "roll.i=0.25",
        "follow_mode=fc",
        "pitch.rc_mode=RC_MODE_SPEED",
        "lpf_freq=50Hz,60,70",
        "--yes",
    )
    assert "rc.yaw.rc_min_angle: -180 deg -> -30 deg" in text
    fields = body_of(board, 0)
    assert [fields["rc"][axis]["rc_min_angle"] for axis in ("roll", "pitch", "yaw")] == [-30] * 3
    assert fields["axes"]["roll"]["i"] == 25
    assert fields["follow_mode"] == 1
    assert fields["rc"]["pitch"]["rc_mode"] == 1
    filters = body_of(board, 0, "ReadParamsExtRequest")["lpf_freq"]
    assert filters == {"roll": 50, "pitch": 60, "yaw": 70}


def test_general_parameters_are_set_in_all_profiles(board: str) -> None:
    text = good(board, "set", "serial_speed=BAUD_57600", "--profile", "3", "--yes")
    assert text.count("serial_speed: BAUD_115200 -> BAUD_57600") == 5
    assert {body_of(board, profile)["serial_speed"] for profile in range(5)} == {1}


@pytest.mark.parametrize(
    "values, words",
    [
        (["serial_speed=BAUD_38400"], "1 general parameter of all profiles"),
        (["yaw.d=77"], "1 parameter of profile 1, which is active"),
        (
            ["serial_speed=BAUD_38400", "yaw.d=77", "yaw.p=78"],
            "1 general parameter of all profiles and 2 parameters of profile 1, which is active",
        ),
    ],
)
def test_set_says_what_it_would_write(board: str, values: list[str], words: str) -> None:
    refused = params(board, "set", *values)
    assert refused.status == 1
    assert f"Writes {words}. Parameters take effect at once" in " ".join(refused.error.split())


@pytest.mark.parametrize(
    "value, status, words",
    [
        ("pitch.p=300", 2, ["axes.pitch.p", "300", "255"]),
        ("roll.i=20", 2, ["axes.roll.i", "20", "2.55"]),
        ("rc_min_angle=-800deg", 2, ["rc_min_angle", "-800 deg is below -720 deg"]),
        ("rc_min_angle=-30V", 2, ["'V'", "deg"]),
        ("follow_mode=FOLOW_MODE_FC", 2, ["did you mean 'FOLLOW_MODE_FC'"]),
        ("pitch.p", 2, ["NAME=VALUE"]),
        ("pitch.p=10%", 2, ["'10%' is not an integer\n"]),
        ("pitch.p=+2000%", 2, ["axes.pitch.p: 294 does not fit: 0 to 255"]),
        ("pitch.p-=15", 2, ["axes.pitch.p: -1 does not fit: 0 to 255"]),
        ("pitch.p=+1%", 2, ["axes.pitch.p: a change by +1% is less than its smallest step"]),
        ("pitch.p+=x", 2, ["axes.pitch.p: 'x' is not an integer"]),
        ("follow_mode+=1", 2, ["follow_mode: only numbers can be changed by an amount"]),
        ("pitch.p=1,5", 2, ["'1,5' is not an integer"]),
        ("roll.i=0,5", 2, ["'0,5' is not a number"]),
        ("pitch.rc_min_angle=95", 1, ["rc_min_angle", "95 deg is above 90 deg", "rc_max_angle"]),
        ("yaw.rc_max_angle=-200", 1, ["rc_min_angle", "above -200 deg", "rc_max_angle"]),
        ("pitch.encoder_limit_max=-3", 1, ["encoder_limit_min", "above"]),
        ("frame_cam_angle_min=1", 1, ["frame_cam_angle_min", "needs firmware 2.61"]),
    ],
)
def test_set_refuses_before_anything_is_written(
    board: str, value: str, status: int, words: list[str]
) -> None:
    before = [body_of(board, profile) for profile in range(5)]
    result = params(board, "set", value, "power=1", "--yes")
    assert result.status == status, result
    for word in words:
        assert word in result.error
    assert [body_of(board, profile) for profile in range(5)] == before


@pytest.mark.parametrize(
    "value, words",
    [
        ("tilt.p = 15", "axes.pitch.p: 14 -> 15"),
        ("tilt.rc_max_angle=30 degrees", "rc.pitch.rc_max_angle: 90 deg -> 30 deg"),
        ("pitch.p=+10%", "axes.pitch.p: 14 -> 15"),
        ("pitch.p=-50%", "axes.pitch.p: 14 -> 7"),
        ("pitch.p += 5", "axes.pitch.p: 14 -> 19"),
        ("pitch.p-=5", "axes.pitch.p: 14 -> 9"),
        ("pitch.p=+5", "axes.pitch.p: 14 -> 5"),
        ("pitch.rc_max_angle=-50%", "rc.pitch.rc_max_angle: 90 deg -> 45 deg"),
        ("pitch.rc_max_angle-=5deg", "rc.pitch.rc_max_angle: 90 deg -> 85 deg"),
    ],
)
def test_set_takes_values_as_people_write_them(board: str, value: str, words: str) -> None:
    result = params(board, "set", value)
    assert result.status == 1 and words in result.text


def test_profiles_count_from_1(board: str) -> None:
    for number in ("0", "6", "x"):
        assert params(board, "show", "--profile", number).status == 2
    assert good(board, "show", "gyro_trust", "--profile", "5").startswith("profile 5\n")


def test_unarmed_without_a_terminal(board: str, tmp_path: Path) -> None:
    backup = tmp_path / "b.json"
    good(board, "backup", str(backup))
    good(board, "set", "yaw.d=33", "--yes")
    before = body_of(board, 0)
    for arguments in (["set", "yaw.d=34"], ["restore", str(backup)], ["reset"]):
        result = (
            params(board, *arguments, "--profile", "1")
            if arguments[0] != "restore"
            else (params(board, *arguments))
        )
        assert result.status == 1
        assert "add --yes" in result.error and "the camera can move" in " ".join(
            result.error.split()
        )
    assert body_of(board, 0) == before
    assert list(tmp_path.iterdir()) == [backup]


def test_interactive_yes_and_no(board: str) -> None:
    before = body_of(board, 0)["axes"]["yaw"]["poles"]
    refused = answer_on_terminal("n", "params", "set", "yaw.poles=22", "-p", board)
    assert refused.status == 1 and "not confirmed" in refused.error
    assert body_of(board, 0)["axes"]["yaw"]["poles"] == before
    agreed = answer_on_terminal("y", "params", "set", "yaw.poles=22", "-p", board)
    assert agreed.status == 0
    assert body_of(board, 0)["axes"]["yaw"]["poles"] == 22


def test_backup_diff_restore(board: str, tmp_path: Path) -> None:
    file = tmp_path / "b.json"
    good(board, "backup", str(file))
    saved = sets_in(file)
    assert ("ReadParams3", 4) in saved and ("ReadProfileNames", 0) in saved
    assert params(board, "backup", str(file)).status == 1, "it exists"
    good(board, "backup", str(file), "--force")
    assert good(board, "diff", str(file)) == ""
    trust = body_of(board, 3)["gyro_trust"]
    good(board, "set", "gyro_trust=99", "--profile", "4", "--yes")
    differing = params(board, "diff", str(file))
    assert differing.status == 1
    assert f"ReadParams3 of profile 4:\n  gyro_trust: {trust} -> 99\n" in differing.text
    as_json = json.loads(params(board, "diff", str(file), "--format", "json").text)
    assert as_json["changes"][0]["fields"][0]["path"] == "gyro_trust"
    assert f"gyro_trust: 99 -> {trust}" in good(board, "restore", str(file), "--dry-run")
    assert params(board, "diff", str(file)).status == 1, "nothing was written"
    restored = params(board, "restore", str(file), "--yes")
    assert restored.status == 0
    assert good(board, "diff", str(file)) == ""
    (safety,) = [path for path in tmp_path.iterdir() if path != file]
    assert safety.name in restored.error.replace("\n", "")
    assert re.fullmatch(r"b\.before-restore-\d{8}T\d{6}Z\.json", safety.name)
    assert params(board, "diff", str(safety)).status == 1
    assert run("params", "diff", str(file), str(file)).status == 0
    assert run("params", "diff", str(file), str(safety)).status == 1
    assert "already" in good(board, "restore", str(file), "--yes")


def test_restore_names_what_was_removed_from_a_backup(other_board: str, tmp_path: Path) -> None:
    file = tmp_path / "b.json"
    changed_backup(other_board, file)
    before = body_of(other_board, 0)
    document = json.loads(file.read_text())
    whole = document["settings"]
    document["settings"] = [
        one for one in whole if (one["message"], one["copy"]) != ("ReadParamsExt", 4)
    ]
    file.write_text(json.dumps(document))
    refused = params(other_board, "restore", str(file), "--yes")
    assert refused.status == 1
    assert "ReadParamsExt of profile 5; --partial restores the others" in words(refused.error)
    assert list(tmp_path.iterdir()) == [file] and body_of(other_board, 0) == before
    restored = params(other_board, "restore", str(file), "--yes", "--partial")
    assert restored.status == 0
    note = "note: not in the backup, so left alone: ReadParamsExt of profile 5"
    assert note in words(restored.error)
    assert body_of(other_board, 0) != before

    document["settings"] = []
    file.write_text(json.dumps(document))
    for options in ([], ["--partial"]):
        empty = params(other_board, "restore", str(file), "--yes", *options)
        assert empty.status == 1
        assert words(empty.error).endswith("the backup holds no parameters")


def test_restore_of_a_backup_without_contents(other_board: str, tmp_path: Path) -> None:
    """As 0.1.0 made them."""
    file = tmp_path / "b.json"
    changed_backup(other_board, file)
    document = json.loads(file.read_text())
    del document["contents"], document["checksum"]
    file.write_text(json.dumps(document))
    restored = params(other_board, "restore", str(file), "--yes")
    assert restored.status == 0 and "left alone" not in restored.error
    document["settings"].pop(0)
    file.write_text(json.dumps(document))
    restored = params(other_board, "restore", str(file), "--yes")
    assert restored.status == 0
    assert "left alone: ReadParams3 of profile 1" in words(restored.error)


def test_restore_notices_an_edited_identity(board: str, tmp_path: Path) -> None:
    file = tmp_path / "b.json"
    good(board, "backup", str(file))
    document = json.loads(file.read_text())
    document["board"]["model"] = "3.1"
    file.write_text(json.dumps(document))
    refused = params(board, "restore", str(file), "--yes")
    assert refused.status == 1
    assert 'board.model: differs from the body, which says "3.0"' in words(refused.error)


def test_parameter_sets_that_only_one_backup_has(board: str, tmp_path: Path) -> None:
    both = tmp_path / "all.json"
    good(board, "backup", str(both))
    document = json.loads(both.read_text())
    document["settings"] = [
        one for one in document["settings"] if (one["message"], one["copy"]) != ("ReadParams3", 4)
    ]
    fewer = tmp_path / "fewer.json"
    fewer.write_text(json.dumps(document))
    for before, after, kind in ((both, fewer, "removed"), (fewer, both, "added")):
        texts = [str(before), str(after)]
        as_json = run("params", "diff", *texts, "--format", "json")
        assert as_json.status == 1
        assert json.loads(as_json.text)["changes"] == [
            {"message": "ReadParams3", "copy": 4, "kind": kind, "fields": []}
        ]
        assert f"\nReadParams3 of profile 5: {kind}\n" in run("params", "diff", *texts).text


def test_comparisons_that_cannot_be_made(board: str, tmp_path: Path) -> None:
    missing_file = tmp_path / "none.json"
    missing = params(board, "diff", str(missing_file))
    assert missing.status == 3 and "none.json" in missing.error
    broken = tmp_path / "broken.json"
    broken.write_text("{}")
    assert params(board, "diff", str(broken)).status == 3
    assert run("params", "diff").status == 2
    backup = str(tmp_path / "backup.json")
    good(board, "backup", backup)
    for options in (["--profile", "2"], ["--yes"]):
        needless = run("params", "diff", backup, backup, *options)
        assert needless.status == 2 and "needs --defaults" in needless.error


def test_disk_full_leaves_no_file(board: str, tmp_path: Path) -> None:
    file = tmp_path / "b.json"

    def limit_files() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

    for options in ([], ["--force"]):
        done = subprocess.run(
            [PROGRAM, "params", "backup", str(file), *options, "-p", board],
            stderr=subprocess.PIPE,
            preexec_fn=limit_files,
            timeout=30,
            check=False,
        )
        assert done.returncode == 1
        assert b"cannot write" in done.stderr and b"File too large" in done.stderr
        assert not list(tmp_path.iterdir())
    no_folder = params(board, "backup", str(tmp_path / "none" / "b.json"))
    assert no_folder.status == 1 and "cannot write" in no_folder.error


def changed_backup(board: str, path: Path) -> None:
    """Writes a backup that differs from the board in every profile."""
    good(board, "backup", str(path))
    document = json.loads(path.read_text())
    for one in document["settings"]:
        if one["message"] != "ReadParams3":
            continue
        body = bytearray.fromhex(one["body"])
        body[1] = 77  # axes.roll.p
        one["body"] = body.hex()
        del one["fields"]
    path.write_text(json.dumps(document))


def said_states(error: str) -> dict[str, str]:
    """Returns the state of each parameter set after "The board now holds"."""
    report = error.split("The board now holds:\n", 1)[1].split("\nsbgc: ", 1)[0]
    parts = re.split(r"((?:new|old|unknown)? ?values[^:]*): ", " ".join(report.split()))
    states = zip(parts[1::2], parts[2::2])
    return {name.strip(): state for state, names in states for name in names.split(",")}


def test_the_board_vanishes_in_the_middle_of_a_restore(tmp_path: Path) -> None:
    file = tmp_path / "b.json"
    with emulated_gimbal("--delay", "1:40") as gimbal:
        changed_backup(gimbal.address, file)
        restoring = Watched("params", "restore", str(file), "--yes", "-p", gimbal.address)
        restoring.wait_for("CMD_WRITE_PARAMS_3", 3)  # the second request
        gimbal.kill()
        ended = restoring.end()
    assert ended.status == 1
    text = " ".join(line for line in ended.error.splitlines() if "CMD_" not in line)
    assert "The board now holds:" in text
    assert "new values, verified: ReadParams3 of profile 1" in text
    assert "old values, not written:" in text and "ReadParams3 of profile 5" in text
    (safety,) = [path for path in tmp_path.iterdir() if path != file]
    assert safety.name in ended.error
    assert ("ReadParams3", 0) in sets_in(safety)


def test_ctrl_c_in_the_middle_of_a_restore(tmp_path: Path) -> None:
    file = tmp_path / "b.json"
    with emulated_gimbal("--delay", "1:40") as gimbal:
        changed_backup(gimbal.address, file)
        restoring = Watched("params", "restore", str(file), "--yes", "-p", gimbal.address)
        restoring.wait_for("CMD_WRITE_PARAMS_3")
        restoring.process.send_signal(signal.SIGINT)
        ended = restoring.end()
        assert ended.status == 130
        said = said_states(ended.error)
        assert said["ReadParams3 of profile 1"] == "new values, verified"
        assert said["ReadParams3 of profile 5"] == "old values, not written"
        # What it says is what the board holds.
        gains = {"new values, verified": 77, "old values, not written": 12}
        for profile in range(5):
            expected = gains[said[f"ReadParams3 of profile {profile + 1}"]]
            assert body_of(gimbal.address, profile)["axes"]["roll"]["p"] == expected


def test_reset_saves_a_backup_first(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal:
        board = gimbal.address
        original = body_of(board, 2)
        good(board, "set", "gyro_trust=11", "--profile", "3", "--yes")
        changed = body_of(board, 2)
        file = tmp_path / "before.json"
        text = good(board, "reset", "--profile", "3", "--yes", "--save-to", str(file))
        assert "gyro_trust: 11 -> " in text
        assert body_of(board, 2) == original
        good(board, "restore", str(file), "--yes", "--save-to", str(tmp_path / "again.json"))
        assert body_of(board, 2) == changed
        assert params(board, "reset", "--all", "--profile", "1").status == 2


def test_the_factory_defaults(tmp_path: Path) -> None:
    """Everything is as before afterwards."""
    with emulated_gimbal() as gimbal:
        board = gimbal.address

        def compare(*options: str) -> Result:
            done = subprocess.run(
                [PROGRAM, "params", "diff", "--defaults", *options, "-p", board],
                cwd=tmp_path,
                stdin=subprocess.DEVNULL,
                capture_output=True,
                timeout=30,
                check=False,
            )
            return Result(done.returncode, done.stdout, done.stderr.decode())

        assert compare("--yes").status == 0, "a new board has them"
        good(board, "set", "gyro_trust=11", "pitch.p=21", "--yes")
        good(board, "set", "gyro_trust=12", "--profile", "5", "--yes")
        before = [body_of(board, profile) for profile in range(5)]
        unarmed = compare()
        assert unarmed.status == 3 and "add --yes" in unarmed.error
        differing = compare("--yes")
        assert differing.status == 1, differing
        assert "-> 11\n" in differing.text and "axes.pitch.p: 14 -> 21" in differing.text
        assert compare("--yes", "--profile", "2").text.count("gyro_trust") == 0
        assert [body_of(board, profile) for profile in range(5)] == before
        comparing = Watched("params", "diff", "--defaults", "--yes", "-p", board, cwd=tmp_path)
        comparing.wait_for("CMD_USE_DEFAULTS")
        comparing.process.send_signal(signal.SIGINT)
        ended = comparing.end()
        assert ended.status == 130 and "are back as they were" in ended.error
        assert [body_of(board, profile) for profile in range(5)] == before


def test_an_interrupted_reset_says_what_is_reset(tmp_path: Path) -> None:
    # The line is so slow that the command does not end before its output is read.
    with emulated_gimbal("--delay", "0.001:100") as gimbal:
        options = ("--all", "--yes", "--save-to", str(tmp_path / "saved.json"))
        resetting = Watched("params", "reset", *options, "-p", gimbal.address)
        resetting.wait_for("CMD_USE_DEFAULTS")
        resetting.process.send_signal(signal.SIGINT)
        ended = resetting.end()
    assert ended.status == 130
    last = " ".join(ended.error.splitlines()[-3:])
    assert "reset; the parameters from before are in" in last and "saved.json" in last
    done = re.search(r"profiles? ([\d, ]+) (?:is|are) reset;", last)
    assert done, last
    assert [int(number) for number in done[1].split(",")] == list(range(1, done[1].count(",") + 2))


def test_a_reset_without_confirmation_is_none(tmp_path: Path) -> None:
    with emulated_gimbal("--delay", "1:40") as gimbal:
        options = ("--profile", "3", "--yes", "--save-to", str(tmp_path / "saved.json"))
        resetting = Watched("params", "reset", *options, "-p", gimbal.address)
        resetting.wait_for("CMD_USE_DEFAULTS")
        gimbal.kill()
        ended = resetting.end()
    assert ended.status == 1
    last = " ".join(" ".join(ended.error.splitlines()[-3:]).split())
    assert "resetting profile 3: " in last
    assert "; no profile is reset; the parameters from before are in" in last


def test_profile_names(board: str) -> None:
    assert "* 1  " in good(board, "profiles")
    assert good(board, "rename", "2", "Front é", "--yes").endswith('-> "Front é"\n')
    names = json.loads(good(board, "profiles", "--format", "json"))["profiles"]
    assert names[1] == {"profile": 2, "name": "Front é", "active": False}
    assert params(board, "rename", "1", "x" * 49, "--yes").status == 2
    assert params(board, "rename", "9", "x", "--yes").status == 2


def test_no_board() -> None:
    result = run("params", "show", "-p", "tcp:127.0.0.1:1", "--timeout", "1")
    assert result.status == 1 and result.error.startswith("sbgc: ")


def test_over_a_pseudo_terminal() -> None:
    with emulated_gimbal("--pty") as gimbal:
        address = f"serial:{gimbal.address}?baud=115200&parity=none"
        assert "axes.pitch.p = 14" in good(address, "get", "pitch.p")
        good(address, "set", "pitch.p=15", "--yes")
        assert "axes.pitch.p = 15" in good(address, "get", "pitch.p")


def test_the_environment_is_not_needed(board: str) -> None:
    done = subprocess.run(
        [PROGRAM, "params", "get", "pitch.d", "-p", board],
        env={"PATH": os.environ["PATH"]},
        capture_output=True,
        check=True,
    )
    assert b"axes.pitch.d" in done.stdout


def test_what_was_set_is_what_decode_prints(board: str) -> None:
    """The raw number that `raw:` sets goes to the board as it is."""
    good(board, "set", "roll.i=raw:42", "--profile", "5", "--yes")
    sent = run("send", "ReadParams3Request", "profile_id=4", "--format", "jsonl", "-p", board)
    (again,) = decode(run("encode", stdin=sent.out).out, "--from", "board")
    assert again["fields"]["axes"]["roll"]["i"] == 42
