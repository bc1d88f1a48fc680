// Runs one test file: node run.mjs NAME_test.mjs. Exits with status 77 if the site is missing.

import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

import { site } from "./support.mjs";

const here = path.dirname(fileURLToPath(import.meta.url));
const needed = {
  [path.join(site, "assets/messages-module.js")]: "./dev docs makes the site",
  [path.join(here, "node_modules")]: "npm ci in tests/site installs what the tests need",
};
for (const [file, advice] of Object.entries(needed)) {
  if (fs.existsSync(file)) continue;
  console.error(`${file} is missing: ${advice}`);
  process.exit(77);
}
// Without the right to a high priority, which a Chromium of root takes from the tests beside it.
const plain = ["setpriv", "--bounding-set=-sys_nice", "--inh-caps=-sys_nice"];
const isRoot = process.getuid?.() === 0 && spawnSync(plain[0], [...plain.slice(1), "true"]).status === 0;
const [program, ...rest] = [...(isRoot ? plain : []), process.execPath, "--test", ...process.argv.slice(2)];
process.exit(spawnSync(program, rest, { cwd: here, stdio: "inherit" }).status ?? 1);
