// Bundles the playground, and the page that sets up a real gimbal: node build.mjs SITE. The wasm modules are in SITE already.

import { createHash } from "node:crypto";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

import * as esbuild from "esbuild";

const here = path.dirname(fileURLToPath(import.meta.url));
const [site] = process.argv.slice(2);
if (!site) throw new Error("usage: node build.mjs SITE");
const output = path.join(site, "assets/playground");

const options = {
  absWorkingDir: here,
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
  external: ["node:*"], // for the same modules in Node
  // The notices of the packages are in licenses.txt.
  legalComments: "none",
  banner: { js: "/* Licenses of the packages: licenses.txt */" },
  metafile: true,
};

/** What a page and its worker are made of: they tell each other, since a cache can mix versions. */
function versionOf(folder, ...more) {
  const names = fs.readdirSync(folder, { recursive: true, withFileTypes: true });
  const sources = names.filter((one) => one.isFile()).map((one) => path.join(one.path, one.name));
  const version = createHash("sha256");
  for (const file of [...sources.sort(), ...more]) version.update(fs.readFileSync(file));
  return version.digest("hex").slice(0, 16);
}
const modules = fs.readdirSync(output).filter((name) => name.endsWith(".wasm"));
const version = versionOf(
  path.join(here, "src"),
  path.join(here, "package-lock.json"),
  ...modules.map((name) => path.join(output, name)),
);

const { metafile } = await esbuild.build({
  ...options,
  entryPoints: {
    main: "src/page/main.tsx",
    worker: "src/worker.ts",
    setup: "src/page/setup/main.tsx",
    setup_worker: "src/setup_worker.ts",
  },
  define: { VERSION: JSON.stringify(version) },
  splitting: true,
  outdir: path.resolve(output),
  chunkNames: "[name]-[hash]",
});

const packages = Object.keys(metafile.inputs)
  .map((input) => /node_modules\/((@[^/]+\/)?[^/]+)\//.exec(input)?.[1])
  .filter(Boolean);
const licenses = [...new Set(packages)].sort().map((name) => {
  const folder = path.join(here, "node_modules", name);
  const { version } = JSON.parse(fs.readFileSync(path.join(folder, "package.json"), "utf8"));
  const license = fs.readdirSync(folder).find((file) => /^licen[cs]e/i.test(file));
  if (!license) throw new Error(`${name} has no license`);
  return `${name} ${version}\n\n${fs.readFileSync(path.join(folder, license), "utf8").trim()}\n`;
});
fs.writeFileSync(path.join(output, "licenses.txt"), licenses.join(`\n${"-".repeat(80)}\n\n`));

// The files that the pages need without a network.
const files = [
  "playground.html",
  "setup.html",
  "assets/style.css",
  ...fs.readdirSync(path.join(site, "assets")).flatMap((file) =>
    /^(playground.*|theme\.js|page\.js|firmware\.js|icon\.svg)$/.test(file) &&
    fs.statSync(path.join(site, "assets", file)).isFile()
      ? [`assets/${file}`]
      : [],
  ),
  ...fs.readdirSync(output).map((file) => `assets/playground/${file}`),
].sort();
const fingerprint = createHash("sha256");
for (const file of files) fingerprint.update(fs.readFileSync(path.join(site, file)));
await esbuild.build({
  ...options,
  entryPoints: ["src/page/service_worker.ts"],
  outfile: path.resolve(site, "service-worker.js"),
  format: "iife",
  banner: {},
  define: {
    FILES: JSON.stringify(files),
    FINGERPRINT: JSON.stringify(fingerprint.digest("hex").slice(0, 16)),
  },
});
