"""Alterations of the model, each of which a kind of fact notices.

An alteration has the kind of the check that must fail, the place in the model, and what is changed there; then a part of
the check's name, if that is not the last part of the place.
"""

from __future__ import annotations

from typing import Any

from documents import Json

Alteration = tuple[Any, ...]


def alter(model: Json, place: str, change: Json) -> None:
    """Changes what is at a place, such as "CMD_EVENT", "BoardInfo.DEBUG_MODE" or "EventId.SCRIPT"."""
    owner, _, member = place.partition(".")
    kinds = ("commands", "messages", "enums", "packed", "framings", "adjustable_variables")
    found = next(thing for kind in kinds for thing in model[kind] if thing["name"] == owner)
    if member:
        members = next(found[key] for key in ("layout", "values", "parts") if key in found)
        found = next(m for m in members if member in (m.get("spec_name"), m.get("name")))
    for key, value in change.items():
        found[key] = value(found[key]) if callable(value) else value


def _without(*names: str) -> Any:
    return lambda leaves: [leaf for leaf in leaves if leaf["spec_name"] not in names]


def _but(last: int) -> Any:
    return lambda values: values[:-last]


def _and_more(value: int) -> Any:
    return lambda values: [*values, {**values[-1], "name": "MORE", "value": value}]


SPECIFICATION: list[Alteration] = [
    ("id", "CMD_REALTIME_DATA_3", {"id": 200}),
    ("board", "CMD_BOARD_INFO_3", {"since": None}),
    ("framing", "v1", {"header_size": 5}, "header"),
    ("command", "CMD_BOOT_MODE_3", {"name": "CMD_BOOT"}),
    ("extra command", "CMD_BOOT", {}),
    ("form", "ControlExt", {"form_name": "wide"}, "CMD_CONTROL"),
    ("body", "CalibPoles", {"direction": "from_board"}, "CMD_CALIB_POLES"),
    ("extra message", "CalibPoles", {}),
    ("field", "ReadParams3.SKIP_GYRO_CALIB", {"spec_name": "SKIP_CALIB"}),
    ("field", "BoardInfo", {"layout": lambda leaves: leaves[::-1]}, "BoardInfo."),
    ("field", "AdjVarsState", {"layout": _but(1)}, "AdjVarsState."),
    ("type", "RealtimeData3.SERIAL_ERROR_CNT", {"type": "i16"}),
    ("offset", "RealtimeData3.CYCLE_TIME", {"offset": 99}),
    ("size", "CalibBat", {"max_size": 3}),
    ("index", "ReadParams3.P", {"path": "axes.yaw.p"}),
    ("special", "ApiVirtChControl.VAL_CH7", {"special": {}}),
    ("value", "RC_FOLLOW_YAW", {"min": 1}),
    ("bits", "I2cWriteRegBuf.DEVICE_ADDR", {"packed": "BoardVersion"}),
    ("same field", "I2cWriteRegBuf.REG_ADDR", {"type": "u16"}),
    ("same body", "WriteParamsExt", {"layout": _but(1)}, "CMD_WRITE_PARAMS_EXT"),
    ("align", "EepromWrite.ADDR", {"align": 1}),
    ("since", "BeepSound", {"since": None}, "CMD_BEEP_SOUND.MODE"),
    ("row", "ReadParams3.EULER_ORDER", {"spec_name": "EULER"}),
    ("row type", "ReadParams3.SPEKTRUM_MODE", {"type": "u16"}),
    ("min", "ReadParams3.SERVO_RATE", {"min": 4}),
    ("max", "CalibInfo.PROGRESS", {"max": 101}),
    ("range", "ReadParams3.SERVO3_OUT", {"max": 31}),
    ("extra range", "ReadParams3.GYRO_SENS", {"min": 0, "max": 9}),
    ("unit", "RealtimeData3.BAT_LEVEL", {"scale": 0.1}),
    ("unit", "RealtimeData4.CURRENT", {"unit": "A"}),
    ("extra unit", "ReadParams3.POWER", {"scale": 0.5, "quantity": "W"}),
    ("count", "RealtimeDataCustom.TARGET_ANGLES", {"count": 2}),
    ("digits", "FirmwareVersion.minor", {"divide": 100}),
    ("constant", "MenuCommand.MENU_CMD_RUN_SCRIPT1", {"value": 99}),
    ("constant", "SystemErrors.ERR_SYSTEM", {"name": "ERR_SYS"}),
    ("extra constant", "SystemErrors.ERR_SYS", {}),
    ("reference", "CalibInfo.ACC_DATA", {"unit": "m"}),
    ("part", "DataStreamInterval.CONFIG", {"cases": _without("FLAGS")}, "CONFIG.flags"),
    ("answer", "RealtimeData4Request", {"response": None}, "CMD_REALTIME_DATA_4"),
    ("variable", "FOLLOW_SPEED_YAW", {"name": "FOLLOW_SPEED"}),
    ("extra variable", "FOLLOW_SPEED", {}),
    ("variable id", "FOLLOW_LPF_ROLL", {"id": 99}),
    ("variable type", "LPF_FREQ_YAW", {"type": "u8"}),
    ("variable min", "LPF_FREQ_ROLL", {"min": 9}),
    ("variable max", "LPF_FREQ_PITCH", {"max": 401}),
]

LATER: list[Alteration] = [
    ("id", "CMD_SIGN_MESSAGE", {"id": 5}),
    ("board", "CMD_AUTO_PID2", {"since": {"board": "3.0"}}),
    ("since", "CMD_PROFILE_SET", {"since": None}),
    ("since", "ProfileSet", {"since": {"firmware": "2.66"}}),
    ("body", "ModuleListRequest", {"direction": "from_board"}, "CMD_MODULE_LIST to_board"),
    ("size", "ControlQuatStatus", {"max_size": 98}),
    ("length", "Event", {"layout": _but(1)}),
    ("field", "ProfileSet.SLOT", {"spec_name": "SLOTS"}),
    ("field", "SyncMotors", {"layout": lambda leaves: leaves[::-1]}, "SyncMotors."),
    ("type", "ServoOutExt.SERVO_TIME", {"type": "i8"}),
    ("offset", "BoardInfo3.HW_FLAGS", {"offset": 48}),
    ("offset", "ReadParamsExt3.SOFT_LIMIT_WIDTH", {"offset": 41}),
    ("same body", "WriteParamsExt3", {"layout": _but(1)}),
    ("when", "CanDrvTelemetryFlags.TEMP_BOARD", {"value": 1}, "CanDrvTelemetry."),
    ("unit", "ReadParamsExt2.MOTOR_RES", {"scale_exact": "1"}),
    ("unit", "ExtMotorsState.CURRENT", {"unit": "A"}),
    ("extra unit", "SignMessageRequest.SIGN_TYPE", {"scale": 2, "quantity": "W"}),
    ("range", "CalibCogging.SMOOTH", {"max": 101}),
    ("extra range", "SignMessageRequest.SIGN_TYPE", {"min": 0, "max": 9}),
    ("since", "DebugVarsInfo3Request.START_IDX", {"since": None}),
    ("extra since", "CalibCogging.SPEED", {"since": {"firmware": "2.70"}}),
    ("place", "AutoPid2.ACTION", {"spec_name": "ACT"}),
    ("value", "CalibMode.COGGING", {"value": 99}),
    ("since", "EventId.SCRIPT", {"since": None}),
    ("value", "EventId.SCRIPT", {"name": "SKRIPT"}),
    ("extra constant", "EventId", {"values": _and_more(7)}, "EventId.MORE"),
    ("extra constant", "StateFlags", {"values": _and_more(1 << 31)}, "StateFlags.MORE"),
    ("bits", "PackedQuaternion.a", {"mask": 1}),
    ("sign", "PackedQuaternion.b", {"sign": 1}),
    ("stream", "DataStreamInterval.CONFIG", {"cases": _but(2)}, "CMD_EXT_MOTORS_STATE"),
    ("variable", "SHAKE_FREQ_RANGE", {"name": "SHAKE"}),
    ("variable range", "SHAKE_FREQ", {"max": 254}),
    ("variable since", "VariableId.EULER_ORDER", {"since": None}),
]
