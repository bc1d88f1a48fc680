// Tests of the WebAssembly module and its engine without a browser: the results match the
// command's.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";

import { frame, messagesModule, model, root, sbgc, site, startModule, vectors } from "./support.mjs";

const assets = path.join(site, "assets");
const { decoderEngine } = (() => {
  // The published file, which is a plain script.
  const module = { exports: {} };
  new Function("module", fs.readFileSync(path.join(assets, "decoder-engine.js"), "utf8"))(module);
  return module.exports;
})();

const { call } = await startModule(messagesModule());

/** Returns the lines of output of the module, fed in pieces, as text. */
function decode(input, { from = "auto", hex = false, pieces = 1 << 16 } = {}) {
  call("start", null, ["auto", "host", "board"].indexOf(from), hex);
  let text = "";
  for (let at = 0; at < input.length; at += pieces) text += call("feed", input.subarray(at, at + pieces));
  return (text + call("finish")).split("\n").slice(0, -1);
}

const isFrame = (line) => line.startsWith('{"frame":');
const framesIn = (input, options) => decode(input, options).filter(isFrame).map((line) => JSON.parse(line));

/** Asserts that the module prints the same line for each frame as the command. */
function agree(input, from, hex = false) {
  const options = ["decode", "--format", "jsonl", "--from", from, ...(hex ? ["--hex"] : [])];
  const expected = spawnSync(sbgc, options, { input, maxBuffer: 64 << 20 }).stdout.toString().split("\n").slice(0, -1);
  const found = decode(input, { from, hex }).filter(isFrame);
  assert.equal(found.length, expected.length);
  for (const [i, line] of expected.entries()) {
    const start = `{"frame":${line},"size":`;
    assert.ok(found[i].startsWith(start), `${found[i]}\n  does not begin with\n${start}`);
  }
  return found.length;
}

const ofVector = (vector) =>
  Buffer.concat([
    ...(vector.after ?? []).map((earlier) => frame(earlier.id, Buffer.from(earlier.hex, "hex"))),
    frame(vector.id, Buffer.from(vector.hex, "hex")),
  ]);

// Vectors without hex test encoding only; no frame carries the id 0.
const decodable = vectors().filter((vector) => vector.hex !== undefined && vector.id !== 0);

test("every vector gives the line that the command prints", () => {
  const all = Buffer.concat(decodable.map(ofVector));
  for (const from of ["auto", "host", "board"]) {
    assert.ok(agree(all, from) >= decodable.length);
  }
});

test("captures give the lines that the command prints", () => {
  const folder = path.join(root, "examples/captures");
  let compared = 0;
  for (const name of fs.readdirSync(folder)) {
    const capture = fs.readFileSync(path.join(folder, name));
    if (!name.endsWith(".bin") && !name.endsWith(".hex")) continue;
    compared += agree(capture, "auto", name.endsWith(".hex"));
  }
  assert.ok(compared > 0);
});

test("pieces of any size give the same", () => {
  const all = Buffer.concat(decodable.slice(0, 300).map(ofVector));
  const whole = decode(all);
  for (const pieces of [1, 7, 300]) assert.deepEqual(decode(all, { pieces }), whole);
  const hex = Buffer.from(all.toString("hex").replace(/(..)/g, "$1 "));
  const ofText = whole.map((line) => line.replace('"reading":"raw bytes"', '"reading":"hex text"'));
  for (const pieces of [1, 5, 1000]) assert.deepEqual(decode(hex, { hex: true, pieces }), ofText);
});

test("rows stand where the model says, and cover every byte that is not 0", () => {
  const offsets = new Map();
  for (const message of model().messages) {
    for (const leaf of message.layout) {
      if (leaf.offset === null) continue;
      offsets.set(`${message.name} ${message.direction} ${leaf.path}`, leaf.offset);
    }
  }
  let compared = 0;
  for (const vector of decodable) {
    if (vector.error || vector.after || "chosen" in vector) continue;
    const from = vector.direction === "to_board" ? "host" : "board";
    const [{ frame: found, rows, body, checksum }] = framesIn(ofVector(vector), { from });
    assert.notEqual(found.message, null, JSON.stringify(vector));
    const bytes = Buffer.from(vector.hex, "hex");
    let end = body;
    for (const [name, , , , at, length] of [...rows, ["", "", "", "", checksum, 0]]) {
      const skipped = bytes.subarray(end - body, at - body);
      assert.ok(at >= end, `${found.message} ${name}: overlap`);
      assert.ok(skipped.every((byte) => byte === 0), `${found.message}: gap before ${name}`);
      end = at + length;
      const offset = offsets.get(`${found.message} ${vector.direction} ${name}`);
      if (offset === undefined) continue;
      assert.equal(at - body, offset, `${found.message} ${name}`);
      ++compared;
    }
  }
  assert.ok(compared > 5000, `only ${compared}`);
});

test("bad hex has a place and a reason, and what is before it is decoded", () => {
  const good = "3e 56 00 56 00\n";
  const cases = {
    "3e 5g": [2, 5, "half a byte: a second digit is missing before 'g'"],
    "# fine\n  zz": [3, 3, "'z' is not a hex digit"],
    "3e\t567\n": [2, 7, "half a byte at the end of the line"],
    "3e 5": [2, 4, "half a byte at the end: the number of hex digits is odd"],
    "é": [2, 1, "byte 0xc3 is not a hex digit"],
  };
  for (const [text, [line, column, reason]] of Object.entries(cases)) {
    const lines = decode(Buffer.from(good + text), { hex: true }).map((l) => JSON.parse(l));
    assert.equal(lines[0].frame.command, "CMD_BOARD_INFO");
    const { text_error: error } = lines.find((l) => l.text_error);
    assert.deepEqual(error, { reading: "hex text", line, column, reason });
    const said = spawnSync(sbgc, ["decode", "--hex"], { input: good + text }).stderr.toString();
    assert.match(said, new RegExp(`line ${line} column ${column}: `));
  }
});

test("the summary counts", () => {
  const noise = Buffer.from([0, 1, 0x3e, 0x3e, 5]);
  const input = Buffer.concat([noise, frame(86, []), frame(86, []).subarray(0, 4)]);
  const { end } = JSON.parse(decode(input).at(-1));
  const expected = { bytes: 14, frames: 1, skipped_bytes: 9, body_errors: 0, incomplete: 1 };
  for (const [key, value] of Object.entries(expected)) assert.equal(end[key], value, key);
});

test("the module is small", () => {
  const size = messagesModule().length;
  assert.ok(size < 620_000, `${size} bytes`);
});

/** The engine as the page uses it. */
class Engine {
  constructor() {
    this.messages = [];
    this.scope = { postMessage: (message) => this.receive(message) };
    decoderEngine(this.scope);
  }
  receive(message) {
    this.messages.push(message);
    this.waiting?.();
  }
  say(message) {
    this.scope.onmessage({ data: message });
  }
  async hear(matches) {
    for (;;) {
      const found = this.messages.find(matches);
      if (found) return found;
      await new Promise((resolve) => (this.waiting = resolve));
    }
  }
  static async load() {
    const engine = new Engine();
    engine.say({ type: "load", module: globalThis.sbgcMessagesModule });
    await engine.hear((message) => message.type === "ready");
    return engine;
  }
  async decode(job, data, options = {}) {
    this.say({ type: "decode", job, data, hex: true, from: "auto", ...options });
    await this.hear((message) => message.job === job && (message.end || message.type === "failed"));
    return this.messages.filter((message) => message.job === job).flatMap((m) => m.items ?? []);
  }
  async details(job, index, item) {
    const { offset, size } = item;
    this.say({ type: "details", job, index, offset, length: size });
    return this.hear((m) => m.type === "details" && m.job === job && m.index === index);
  }
}

test("the engine lists frames and gaps without holes and tells everything about each", async () => {
  const engine = await Engine.load();
  const broken = frame(67, [77]);
  broken[5] ^= 1;
  const input = Buffer.concat([
    Buffer.from([1, 2]),
    frame(86, []),
    broken,
    Buffer.from([0x3e, 0x56, 9, 0]),
    frame(77, []),
    frame(67, [1, 2, 3]).subarray(0, 6),
  ]);
  const items = await engine.decode(1, input.toString("hex"));
  assert.deepEqual(items.map((item) => item.kind), ["gap", "frame", "gap", "frame", "gap"]);
  let at = 0;
  for (const [i, item] of items.entries()) {
    assert.equal(item.offset, at);
    at += item.size;
    const details = await engine.details(1, i, item);
    assert.deepEqual(Buffer.from(details.bytes), input.subarray(item.offset, at));
  }
  assert.equal(at, input.length);

  const misses = async (i) => (await engine.details(1, i, items[i])).misses;
  assert.deepEqual(await misses(0), []);
  assert.deepEqual(await misses(2), [
    [0, "looks like CMD_CONFIRM (67) from the board with a body of 1 byte, but the checksum of its body is 0x4c, not 0x4d", [5, 1],
      "Confirm", [["cmd", "77", "CMD_MOTORS_ON", "", 4, 1], ["data", "", "", "", 5, 0]]],
    [6, "a start byte, but the checksum of its header is 0x00, not 0x5f", [3, 1], "", []],
  ]);
  assert.deepEqual(await misses(4), [
    [0, "looks like CMD_CONFIRM (67) from the board with a body of 3 bytes, but the last 2 of its 8 bytes are missing", [7, 0],
      "", []],
  ]);
});

test("frames without their start bytes are shown as what is in no frame", async () => {
  const engine = await Engine.load();
  const [item] = await engine.decode(1, "58 08 60 c1 0e fd ff 0c 00 49 00");
  assert.equal(item.kind, "gap");
  const [[at, reason, , message, rows]] = (await engine.details(1, 0, item)).misses;
  assert.equal(at, 0);
  assert.match(reason, /^CMD_REALTIME_DATA_CUSTOM without its start byte and the checksum behind its body/);
  assert.equal(message, "RealtimeDataCustom");
  assert.deepEqual(rows[0].slice(0, 2), ["timestamp_ms", "3777"]);
});

test("who sent the bytes decides what they nearly are", async () => {
  const engine = await Engine.load();
  const broken = frame(67, Array(15).fill(0));
  broken[19] = 1;
  const said = async (job, options) => {
    const [item] = await engine.decode(job, broken.toString("hex"), options);
    return (await engine.details(job, 0, item)).misses[0][1];
  };
  assert.match(await said(1, {}), /^looks like CMD_CONTROL \(67\) from the host with a body of 15 bytes, but/);
  assert.match(await said(2, { from: "board" }), /^looks like CMD_CONFIRM \(67\) from the board/);
  const [item] = await engine.decode(3, broken.subarray(0, 19).toString("hex"));
  const { misses } = await engine.details(3, 0, item);
  assert.match(misses[0][1], /but the checksum of its body, 0x00, is missing at the end$/);
});

test("a new input cancels the one before", async () => {
  const engine = await Engine.load();
  const long = frame(77, []).toString("hex").repeat(200_000);
  engine.say({ type: "decode", job: 1, data: long, hex: true, from: "auto" });
  await engine.hear((message) => message.job === 1);
  const items = await engine.decode(2, "3e 56 00 56 00");
  assert.equal(items.length, 1);
  assert.ok(!engine.messages.some((message) => message.job === 1 && message.end));
});

test("an empty input is an input", async () => {
  const engine = await Engine.load();
  assert.deepEqual(await engine.decode(1, "# nothing"), []);
});

// The client without threads, built for WebAssembly, sends and receives the same bytes at the same
// times as the one that is built for this machine.
const client = path.join(root, "build/wasm/web/modules/sbgc_passive_client.wasm");

test("the client without threads and its program for this machine agree on every byte", async () => {
  const { call: callClient, needed } = await startModule(fs.readFileSync(client));
  // The C library needs these for messages before it ends the program: no clock, no random numbers.
  for (const name of needed) assert.match(name, /^(fd_(close|seek|write|fdstat_get)|proc_exit)$/);
  const lines = callClient("run").split("\n");

  const program = spawnSync(process.env.SBGC_PASSIVE_CLIENT, { encoding: "utf8", maxBuffer: 64 << 20 });
  assert.equal(program.status, 0);
  assert.deepEqual(lines, program.stdout.split("\n"));
  for (const way of [/^\d+ > 3e/, /^\d+ < 3e/, /^connected$/, /^moved$/, /^read$/, /^ +"/, /^parsed$/, /^[1-9]\d+ parameters$/]) {
    assert.ok(lines.some((line) => way.test(line)), `${way} in\n${lines.slice(0, 20).join("\n")}`);
  }
});
