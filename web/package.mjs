// Makes the npm package: node package.mjs MODULES FOLDER. MODULES has the wasm modules; FOLDER gets
// package/, and the archive that `npm pack` makes of it.

import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

import * as esbuild from "esbuild";

const here = path.dirname(fileURLToPath(import.meta.url));
const [modules, folder] = process.argv.slice(2);
if (!folder) throw new Error("usage: node package.mjs MODULES FOLDER");
const header = fs.readFileSync(path.join(here, "../runtime/core/include/sbgc/version.hpp"), "utf8");
const parts = [...header.matchAll(/^#define SBGC_VERSION_[A-Z]+ (\d+)$/gm)];
const version = parts.map(([, number]) => number).join(".");
const output = path.resolve(folder, "package");
fs.rmSync(output, { recursive: true, force: true });
fs.mkdirSync(output, { recursive: true });

await esbuild.build({
  absWorkingDir: here,
  entryPoints: ["src/index.ts"],
  outfile: path.join(output, "index.js"),
  bundle: true,
  format: "esm",
  target: "es2022",
  external: ["node:*"],
});
const tsc = path.join(here, "node_modules/.bin/tsc");
const emit = ["--noEmit", "false", "--declaration", "--emitDeclarationOnly", "--outDir", output];
execFileSync(tsc, ["--project", path.join(here, "tsconfig.package.json"), ...emit], { stdio: "inherit" });
for (const name of ["gimbal.wasm", "messages.wasm"]) {
  fs.writeFileSync(path.join(output, name), fs.readFileSync(path.join(modules, name)));
}
fs.copyFileSync(path.join(here, "../docs/28-javascript.md"), path.join(output, "README.md"));
fs.copyFileSync(path.join(here, "../LICENSE"), path.join(output, "LICENSE"));

const { name, description, license, type, engines } = JSON.parse(
  fs.readFileSync(path.join(here, "package.json"), "utf8"),
);
const entry = { types: "./index.d.ts", default: "./index.js" };
const keywords = ["simplebgc", "basecam", "gimbal", "serial", "webserial"];
const about = { name, version, description, license, keywords, type, engines };
const manifest = { ...about, exports: { ".": entry, "./*.wasm": "./*.wasm" }, types: entry.types };
fs.writeFileSync(path.join(output, "package.json"), `${JSON.stringify(manifest, null, 2)}\n`);
execFileSync("npm", ["pack", "--silent", "--pack-destination", path.resolve(folder)], {
  cwd: output,
  stdio: "inherit",
});
