// The location of the site, and a browser for the tests.

import { execFileSync, spawnSync } from "node:child_process";
import fs from "node:fs";
import http from "node:http";
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import vm from "node:vm";

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
export const site = process.env.SBGC_SITE ?? path.join(root, "build/site");

/** The command that the decoder must agree with. */
export const sbgc = process.env.SBGC ?? path.join(root, "build/release/tools/sbgc");

export const addressOf = (page) => pathToFileURL(path.join(site, page)).href;

/** Returns all pages by their path in the site. */
export function pages() {
  const found = [];
  const walk = (folder) => {
    for (const entry of fs.readdirSync(path.join(site, folder), { withFileTypes: true })) {
      const name = path.posix.join(folder, entry.name);
      if (entry.isDirectory()) walk(name);
      else if (name.endsWith(".html")) found.push(name);
    }
  };
  walk("");
  return found.sort();
}

/** The name of a page: BoardInfo3 is board-info3. */
export const slug = (name) => name.replace(/([a-z0-9])(?=[A-Z])/g, "$1-").toLowerCase();

/** Returns the exported model. */
export const model = () =>
  JSON.parse(fs.readFileSync(path.join(root, "generated/simplebgc.json"), "utf8"));

/** Returns the lines of all test vectors. */
export function vectors() {
  const folder = path.join(root, "generated/vectors");
  return fs
    .readdirSync(folder)
    .flatMap((file) => fs.readFileSync(path.join(folder, file), "utf8").trim().split("\n"))
    .map((line) => JSON.parse(line));
}

/** Returns a frame around a body. */
export function frame(id, body) {
  const sum = (bytes) => bytes.reduce((total, byte) => total + byte, 0) & 0xff;
  const content = Buffer.from(body);
  const header = [0x3e, id, content.length, (id + content.length) & 0xff];
  return Buffer.concat([Buffer.from(header), content, Buffer.from([sum(content)])]);
}

/** Starts a WebAssembly module. `call(name, input, ...numbers)` calls a function, and returns its output. */
export async function startModule(code) {
  const module = await WebAssembly.compile(code);
  const needed = WebAssembly.Module.imports(module).map(({ name }) => name);
  const files = Object.fromEntries(needed.map((name) => [name, () => 8]));
  const { exports } = await WebAssembly.instantiate(module, { wasi_snapshot_preview1: files });
  exports._initialize();
  const call = (name, input, ...numbers) => {
    const pointer = input && exports.input(input.length);
    if (input) new Uint8Array(exports.memory.buffer, pointer, input.length).set(input);
    exports[name](...numbers);
    return Buffer.from(exports.memory.buffer, exports.output(), exports.output_size()).toString();
  };
  return { call, needed };
}

/** The WebAssembly module of the decoder and the frame builder. */
export function messagesModule() {
  createRequire(import.meta.url)(path.join(site, "assets/messages-module.js"));
  return Buffer.from(globalThis.sbgcMessagesModule, "base64");
}

/** Runs a program in Python with the package; returns what it prints, or how it fails. */
export function runPython(program) {
  const env = { ...process.env, PYTHONPATH: path.resolve(path.dirname(sbgc), "../python") };
  const ran = spawnSync("/usr/bin/python3", ["-"], { input: program, env, encoding: "utf8" });
  return ran.stderr || ran.stdout.trim();
}

/** Installs the npm package into a folder, as npm does, and imports it. */
export function packageIn(folder) {
  const installed = path.join(folder, "node_modules/sbgc");
  fs.mkdirSync(installed, { recursive: true });
  const [archive] = fs.readdirSync(path.join(root, "build/npm")).filter((file) => file.endsWith(".tgz"));
  execFileSync("tar", ["xzf", path.join(root, "build/npm", archive), "-C", installed, "--strip-components=1"]);
  return import(pathToFileURL(path.join(installed, "index.js")));
}

/** Returns the search of the site as a function of the query. */
export async function searchOfSite() {
  const context = vm.createContext({ setTimeout });
  for (const name of ["minisearch", "finder", "search-index"]) {
    vm.runInContext(fs.readFileSync(path.join(site, `assets/${name}.js`), "utf8"), context);
  }
  return vm.runInContext("sbgcFinder(MiniSearch, sbgcSearchIndex)", context);
}

/** Launches the Chromium in CHROMIUM, Debian's headless one, or another. */
export async function launch(args = []) {
  const { chromium } = await import("playwright-core");
  const programs = ["chromium-headless-shell", "chromium", "chromium-browser"];
  const paths = [process.env.CHROMIUM, ...programs.map((name) => `/usr/bin/${name}`)];
  const executablePath = paths.find((path) => path && fs.existsSync(path));
  if (executablePath === undefined) throw new Error("no browser: package chromium-headless-shell");
  // Without its sandbox, which is unavailable to root and in many containers. It opens only our own
  // pages.
  // Drawing with an emulated graphics processor takes much processor time: only WebGL needs one.
  const plain = ["--disable-gpu-compositing", "--disable-gpu-rasterization", "--disable-accelerated-2d-canvas"];
  return chromium.launch({ executablePath, chromiumSandbox: false, args: [...plain, ...args] });
}

/** Serves the site; `address` is where, and `close` ends it. `changed` has files that differ, by their paths. */
export async function serve() {
  const types = { html: "text/html", js: "text/javascript", css: "text/css", wasm: "application/wasm", svg: "image/svg+xml" };
  const changed = {};
  const server = http.createServer((request, response) => {
    const name = decodeURIComponent(new URL(request.url, "http://site").pathname);
    fs.readFile(path.join(site, path.normalize(name)), (error, content) => {
      const type = types[path.extname(name).slice(1)] ?? "application/octet-stream";
      response.writeHead(error ? 404 : 200, { "content-type": type }).end(changed[name] ?? content);
    });
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, changed, close: () => server.closeAllConnections() ?? server.close() };
}

/** Calls `work(page, item)` for each item, in one page: pages side by side take more processor time. */
export async function forEachItem(browser, items, options, work) {
  const page = await browser.newPage(options);
  for (const item of items) await work(page, item);
  await page.close();
}
