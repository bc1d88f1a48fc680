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
const options = { cwd: here, stdio: "inherit" };
process.exit(spawnSync(process.execPath, ["--test", ...process.argv.slice(2)], options).status ?? 1);
