// The client without threads, built for WebAssembly, sends and receives the same bytes at the same
// times as the one that is built for this machine.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";

import { root } from "./support.mjs";

const file = path.join(root, "build/wasm/web/modules/sbgc_passive_client.wasm");

test("the module and the program agree on every byte", async () => {
  const module = await WebAssembly.compile(fs.readFileSync(file));
  // What the C library wants for messages before it ends the program: no clock, no random numbers.
  const needed = WebAssembly.Module.imports(module).map(({ name }) => name);
  for (const name of needed) assert.match(name, /^(fd_(close|seek|write|fdstat_get)|proc_exit)$/);
  const files = Object.fromEntries(needed.map((name) => [name, () => 8]));
  const { exports } = await WebAssembly.instantiate(module, { wasi_snapshot_preview1: files });
  exports._initialize();
  exports.run();
  const bytes = new Uint8Array(exports.memory.buffer, exports.output(), exports.output_size());
  const lines = new TextDecoder().decode(bytes).split("\n");

  const program = spawnSync(process.env.SBGC_PASSIVE_CLIENT, { encoding: "utf8", maxBuffer: 64 << 20 });
  assert.equal(program.status, 0);
  assert.deepEqual(lines, program.stdout.split("\n"));
  for (const way of [/^\d+ > 3e/, /^\d+ < 3e/, /^connected$/, /^moved$/, /^read$/, /^ +"/, /^parsed$/, /^[1-9]\d+ parameters$/]) {
    assert.ok(lines.some((line) => way.test(line)), `${way} in\n${lines.slice(0, 20).join("\n")}`);
  }
});
