// The location of the site, and a browser for the tests.

import { execFileSync } from "node:child_process";
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

/** Returns the exports of the WebAssembly module of the decoder and the frame builder. */
export async function loadModule() {
  createRequire(import.meta.url)(path.join(site, "assets/messages-module.js"));
  const code = Buffer.from(globalThis.sbgcMessagesModule, "base64");
  const nothing = () => 8;
  const files = { fd_close: nothing, fd_seek: nothing, fd_write: nothing };
  const { instance } = await WebAssembly.instantiate(code, { wasi_snapshot_preview1: files });
  instance.exports._initialize();
  return instance.exports;
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
  return chromium.launch({ executablePath, chromiumSandbox: false, args });
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
