// The npm package: its README, its types, and its bytes against those of the native program.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";

import { packageIn, root, sbgc, vectors } from "./support.mjs";

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "sbgc-npm-"));
const readme = fs.readFileSync(path.join(root, "docs/28-javascript.md"), "utf8");
const programs = [...readme.matchAll(/^```js( browser)?\n(.*?)^```/gms)].map(([, where, text], number) => ({
  name: `example${number}.mjs`,
  text,
  runs: where === undefined,
}));

let sdk;
before(async () => {
  sdk = await packageIn(folder);
  for (const { name, text } of programs) fs.writeFileSync(path.join(folder, name), text);
});
after(() => fs.rmSync(folder, { recursive: true }));

test("the programs of the README print what it says", () => {
  assert.equal(programs.filter(({ runs }) => runs).length, 2);
  for (const { name, text, runs } of programs) {
    if (!runs) continue;
    const said = [...text.matchAll(/console\.log\(.*\); \/\/ (.*)/g)].map(([, line]) => line);
    const printed = execFileSync(process.execPath, [path.join(folder, name)], { encoding: "utf8" });
    assert.deepEqual(printed.trimEnd().split("\n"), said, name);
  }
});

test("the programs and the types are strict", () => {
  const uses = `import { encode, decode, connect, type Gimbal, type BoardInfo } from "sbgc";
declare global { interface Navigator { serial: { requestPort(): Promise<{ open(o: { baudRate: number }): Promise<void>;
  readable: ReadableStream<Uint8Array>; writable: WritableStream<Uint8Array> }> } } }
export async function firmware(gimbal: Gimbal): Promise<number> {
  const info: BoardInfo = (await gimbal.call("BoardInfoRequest")).fields;
  return info.firmware_ver;
}
await encode("Control", { control_mode: ["MODE_SPEED"] });
const [frame] = await decode(new Uint8Array(1));
// @ts-expect-error: its body may be damaged
if (frame?.message === "Control") frame.fields.axes;
if (frame?.fields === undefined) frame?.error.code;
// @ts-expect-error: a misspelled name
await encode("Control", { control_mode: "MODE_SPED" });
// @ts-expect-error: no such field
await encode("Control", { axes: { pich: {} } });
`;
  fs.writeFileSync(path.join(folder, "uses.ts"), uses);
  const tsc = path.join(root, "web/node_modules/.bin/tsc");
  const target = ["--target", "es2022", "--module", "esnext", "--moduleResolution", "bundler", "--lib", "es2022,dom"];
  const files = ["uses.ts", ...programs.map(({ name }) => name)];
  const checks = ["--strict", "--noEmit", "--allowJs", "--checkJs", "--types", "", ...target];
  const said = spawnSync(tsc, [...checks, ...files], { cwd: folder, encoding: "utf8" });
  assert.equal(said.status, 0, said.stdout);
});

test("500 requests have the bytes of the native program", async () => {
  const codec = await sdk.messages();
  const lines = [];
  const frames = [];
  for (const { message, fields, direction, error } of vectors()) {
    if (direction === "from_board" || fields === undefined || error) continue;
    try {
      frames.push(Buffer.from(codec.encode(message, fields)).toString("hex"));
      lines.push(JSON.stringify({ message, fields }));
    } catch (error) {
      assert.ok(error instanceof sdk.ProtocolError, String(error)); // a value that is not allowed
    }
  }
  assert.ok(frames.length >= 500, `${frames.length}`);
  const options = { input: lines.join("\n"), encoding: "utf8", maxBuffer: 64 << 20 };
  const native = spawnSync(sbgc, ["encode", "--hex", "-"], options);
  assert.equal(native.status, 0, native.stderr);
  assert.deepEqual(frames, native.stdout.trimEnd().split("\n"));
});

test("each wrong value is named", async () => {
  await assert.rejects(sdk.encode("Control", { control_mode: "MODE_ANGL" }), /MODE_ANGLE/);
  await assert.rejects(sdk.encode("Control", { axes: { pitch: { angle: 1e6 } } }), /angle/);
  await assert.rejects(sdk.encode("Control", { axes: { pitch: { angel: 1 } } }), /angel/);
  await assert.rejects(sdk.encode("Controll"), { name: "ProtocolError" });
  await assert.rejects(sdk.emulator({ faults: ["low-batery"] }), /low-battery/);
  for (const [values, path] of [[{ axes: { roll: { angle: "30" } } }, "axes.roll.angle"], [{ axes: 1 }, "axes"]]) {
    const isNamed = ({ problems: [[field, text]] }) => field === path && text.endsWith("is needed");
    await assert.rejects(sdk.encode("Control", values), isNamed);
  }
  await assert.rejects(sdk.encode("ExtMotorsControl", { data_set: 1, setpoint16: [1] }), /^ProtocolError: setpoint16: .*excludes/);
});

test("what is missing has its default, and names stand for numbers, also in lists and optional fields", async () => {
  for (const [name, values, ids] of [
    ["GetAdjVarsVal", { param_id: [14, "FOLLOW_SPEED_YAW"] }, { num_vars: 2, param_id: [14, 15] }],
    ["SetAdjVarsVal", { params: [{ param_id: "FOLLOW_SPEED_YAW" }] }, { num_vars: 1, params: [{ param_id: 15, param_value: 0 }] }],
    ["ExtMotorsControlConfig", { data_set: ["MODE"], mode: "TORQUE" }, { for_motors: 0, data_set: 1, mode: 2 }],
    ["ExtMotorsControl", { data_set: 1 }, { for_motors: 0, data_set: 1, setpoint32: [] }],
  ]) {
    const [{ fields }] = await sdk.decode(await sdk.encode(name, values), "host");
    assert.deepEqual(fields, ids, name);
  }
});

test("an argument of a wrong type is a TypeError", async () => {
  for (const wrong of [
    () => sdk.decode("3e43"), () => sdk.decode(new Uint8Array(3), "gimbal"), () => sdk.connect({ readable: null }),
    () => sdk.encode("Control", {}, { framing: "old" }), () => sdk.emulator(null),
  ]) await assert.rejects(wrong, { name: "TypeError", message: /needed|is "|open the port/ });
});

test("a response is decoded with its request, and what is no number moves nothing", async () => {
  const board = await sdk.emulator();
  const gimbal = await sdk.connect(board);
  const { fields } = await gimbal.call("RealtimeDataCustomRequest", { flags: ["IMU_ANGLES"] });
  assert.equal(typeof fields.imu_angles.pitch, "number");
  await gimbal.call("SetAdjVarsVal", { params: [{ param_id: 14, param_value: 50 }] });
  const { fields: values } = await gimbal.call("GetAdjVarsVal", { param_id: [14] });
  assert.equal(values.params[0].param_value, 50);
  await assert.rejects(gimbal.move({ pitch: null }), /pitch: a number is needed/);
  await gimbal.close();
  board.close();
  assert.throws(() => board.change({}), /is off/);
});

test("an action that cannot be carried out rejects, and so does all that waits at the end", async () => {
  const board = await sdk.emulator();
  const gimbal = await sdk.connect(board);
  await assert.rejects(gimbal.move({}), /needs an angle/);
  await assert.rejects(gimbal.turn({ yaw: 10, seconds: 1000 }), /seconds/);
  await assert.rejects(gimbal.menu("DANCE"), /DANCE/);
  await gimbal.motorsOn();
  const move = gimbal.move({ yaw: 170, speed: 10 });
  const superseded = assert.rejects(move, /later/);
  await gimbal.stop();
  await superseded;
  const another = assert.rejects(gimbal.move({ yaw: -170, speed: 10 }), /closed/);
  await gimbal.close();
  await another;
  await assert.rejects(gimbal.stop(), /closed/);
  board.close();
});

test("without a board, connecting rejects", async () => {
  const line = { readable: new ReadableStream(), writable: new WritableStream() };
  await assert.rejects(sdk.connect(line), /no response/);
});
