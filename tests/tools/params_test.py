"""Tests of sbgc params with emulated boards."""

from __future__ import annotations

import json
import os
import re
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from board_command import Watched, answer_on_terminal, limit_files
from emulated_gimbal import emulated_gimbal
from sbgc_command import MODEL, Result, run


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


def test_get_explains_once(board: str) -> None:
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


def test_interactive_yes_and_no(board: str) -> None:
    before = body_of(board, 0)["axes"]["yaw"]["poles"]
    refused = answer_on_terminal("", "params", "set", "yaw.poles=22", "-p", board)
    assert refused.status == 1 and "not confirmed" in refused.error
    assert body_of(board, 0)["axes"]["yaw"]["poles"] == before
    agreed = answer_on_terminal("y", "params", "set", "yaw.poles=22", "-p", board)
    assert agreed.status == 0
    assert body_of(board, 0)["axes"]["yaw"]["poles"] == 22


def test_restore_names_what_was_removed_from_a_backup(other_board: str, tmp_path: Path) -> None:
    file = tmp_path / "b.json"
    changed_backup(other_board, file)
    before = body_of(other_board, 0)
    document = json.loads(file.read_text())
    document["settings"] = [
        one for one in document["settings"] if (one["message"], one["copy"]) != ("ReadParamsExt", 4)
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


def test_parameter_sets_that_only_one_backup_has(board: str, tmp_path: Path) -> None:
    both = tmp_path / "all.json"
    good(board, "backup", str(both))
    document = json.loads(both.read_text())
    document["settings"] = [
        one for one in document["settings"] if (one["message"], one["copy"]) != ("ReadParams3", 4)
    ]
    fewer = tmp_path / "fewer.json"
    fewer.write_text(json.dumps(document), encoding="utf-8-sig")  # as some editors do
    for before, after, kind in ((both, fewer, "removed"), (fewer, both, "added")):
        said = run("params", "diff", str(before), str(after))
        assert said.status == 1 and f"\nReadParams3 of profile 5: {kind}\n" in said.text


def test_a_difference_of_two_files_names_them(board: str, tmp_path: Path) -> None:
    old, new = str(tmp_path / "old.json"), str(tmp_path / "new.json")
    good(board, "backup", old)
    with emulated_gimbal("--firmware", "2.70") as newer:
        good(newer.address, "backup", new)
    said = run("params", "diff", old, new).error
    assert f"the board of {new} has the firmware 2.70, {old} is of 2.59" in words(said)


def test_disk_full_leaves_no_file(board: str, tmp_path: Path) -> None:
    for options in ([], ["--force"]):
        backup = ("params", "backup", str(tmp_path / "b.json"), *options, "-p", board)
        done = run(*backup, preexec_fn=lambda: limit_files(4096))
        assert done.status == 1
        assert "cannot write" in done.error and "File too large" in done.error
        assert not list(tmp_path.iterdir())


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
        ended = restoring.interrupt()
        assert ended.status == 130
        said = said_states(ended.error)
        assert said["ReadParams3 of profile 1"] == "new values, verified"
        assert said["ReadParams3 of profile 5"] == "old values, not written"
        # The reported states agree with the board's.
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
            return run("params", "diff", "--defaults", *options, "-p", board, cwd=tmp_path)

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


def test_interrupted_factory_defaults_are_undone(tmp_path: Path) -> None:
    # The line is so slow that the command does not end before its output is read.
    with emulated_gimbal("--delay", "0.001:100") as gimbal:
        board = gimbal.address
        good(board, "set", "gyro_trust=11", "pitch.p=21", "--yes")
        before = [body_of(board, profile) for profile in range(5)]
        for _ in range(5):
            comparing = Watched("params", "diff", "--defaults", "--yes", "-p", board, cwd=tmp_path)
            comparing.wait_for("CMD_USE_DEFAULTS")
            ended = comparing.interrupt()
            assert [body_of(board, profile) for profile in range(5)] == before
            # Otherwise it was at its end: a busy machine delays, but not each time.
            if ended.status not in (1, -signal.SIGINT):
                break
        assert ended.status == 130 and "are back as they were" in ended.error


def test_an_interrupted_reset_says_what_is_reset(tmp_path: Path) -> None:
    # The line is so slow that the command does not end before its output is read.
    with emulated_gimbal("--delay", "0.001:100") as gimbal:
        options = ("--all", "--yes", "--save-to", str(tmp_path / "saved.json"))
        resetting = Watched("params", "reset", *options, "-p", gimbal.address)
        resetting.wait_for("CMD_USE_DEFAULTS")
        ended = resetting.interrupt()
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


def test_the_environment_is_not_needed(board: str) -> None:
    done = run("params", "get", "pitch.d", "-p", board, env={"PATH": os.environ["PATH"]})
    assert "axes.pitch.d" in done.text


def test_variables_have_the_units_of_the_model(board: str) -> None:
    listed = json.loads(run("vars", "list", "--format", "json", "-p", board).text)["variables"]
    units = {variable["name"]: variable["unit"] for variable in MODEL["adjustable_variables"]}
    assert len(listed) > 40 and all(one["unit"] == units[one["name"]] for one in listed)
