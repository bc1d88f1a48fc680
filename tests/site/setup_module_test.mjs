// The module that sets a board up, without a page and in virtual time: every parameter is read, planned,
// written and read back.

import assert from "node:assert/strict";
import fs from "node:fs";
import { createRequire } from "node:module";
import os from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";

import { root, site } from "./support.mjs";

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "sbgc-module-"));
let web;
before(async () => {
  const esbuild = createRequire(path.join(root, "web/package.json"))("esbuild");
  const outfile = path.join(folder, "web.mjs");
  const source = (name) => path.join(root, "web/src", name);
  const contents = ["line.ts", "setup_client.ts", "wasm.ts"].map((one) => `export * from ${JSON.stringify(source(one))};`);
  await esbuild.build({
    stdin: { contents: contents.join("\n"), resolveDir: root },
    bundle: true,
    format: "esm",
    external: ["node:*"],
    outfile,
  });
  web = await import(pathToFileURL(outfile));
});
after(() => fs.rmSync(folder, { recursive: true }));

const load = (name) => web.Wasm.load(fs.readFileSync(path.join(site, "assets/playground", `${name}.wasm`)));

/** Another valid value, or undefined. */
function other({ text, kind, names, least, most }) {
  if (kind === "text") return "another";
  if (kind === "enum" || kind === "flags") return names.map(([name]) => name).find((name) => name !== text);
  if (kind !== "number") return undefined;
  return [least ?? 0, most ?? 1].map(String).find((one) => Number(one) !== Number(text));
}

for (const [board, firmware] of [[30, 2590], [36, 2745]]) {
  test(`every parameter of firmware ${firmware} is read, planned, written and read back`, async () => {
    const client = new web.SetupClient(await load("setup"));
    const gimbal = new web.EmulatedGimbal(await load("gimbal"), { board, firmware }, client);
    await gimbal.during(client.identified);
    assert.deepEqual([client.board.board, client.board.firmware], [board, firmware]);
    await gimbal.during(client.read());
    const all = (await client.profile(1)).flatMap(({ parameters }) => parameters);
    assert.ok(all.length > 400, `${all.length}`);
    const same = client.plan(Object.fromEntries(all.map(({ name, text }) => [name, text])), 1);
    assert.deepEqual(same, { changes: [], problems: [], remarks: [] });

    const wanted = { gyro_trust: "60", serial_speed: "BAUD_57600", rc_deadband: "33" };
    const mixed = client.plan(Object.fromEntries(Object.entries(wanted).map(([name, value]) => [`ReadParams3.${name}`, value])), 1);
    const order = mixed.changes.map(({ name, line }) => [name.split(".")[1], line]);
    assert.deepEqual(order, [["gyro_trust", false], ["rc_deadband", false], ["serial_speed", true]], JSON.stringify(mixed));

    let written = 0;
    for (const { name, parameters } of await client.profile(1)) {
      const pairs = parameters.map((one) => [one.name, other(one)]).filter(([, value]) => value !== undefined);
      const values = Object.fromEntries(pairs);
      // Some are for later firmware, some exclude each other.
      for (const [place] of client.plan(values, 1).problems) delete values[place];
      const { changes, problems } = client.plan(values, 1);
      assert.deepEqual(problems, [], name);
      assert.deepEqual(changes.map((one) => one.name).sort(), Object.keys(values).sort(), name);
      if (changes.length === 0) continue;
      const { ok, text } = await gimbal.during(client.write());
      assert.ok(ok, text);
      assert.deepEqual(client.plan(values, 1).changes, [], "it is what was written");
      const now = new Map((await client.profile(1)).flatMap((topic) => topic.parameters).map((one) => [one.name, one.text]));
      for (const one of parameters) assert.equal(now.get(one.name) !== one.text, one.name in values, one.name);
      written += changes.length;
      assert.equal(client.planUndo().changes.length, changes.length, name);
    }
    assert.ok(written > 300, `${written}`);
  });
}
