// Takes the picture of the page "Set up": SBGC=PROGRAM node setup.mjs, after ./dev docs and npm ci in
// tests/site.

import path from "node:path";
import { fileURLToPath } from "node:url";

import { cables, gimbal, giveSerial } from "../../tests/site/serial.mjs";
import { launch, serve } from "../../tests/site/support.mjs";

const picture = path.join(path.dirname(fileURLToPath(import.meta.url)), "setup.png");
const board = await gimbal("--firmware", "2.70", "--motion", "handheld");
const ends = await cables(board);
const server = await serve();
const browser = await launch(["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]);
const context = await browser.newContext({ viewport: { width: 1280, height: 860 } });
await giveSerial(context, server, ends.url);
const page = await context.newPage();
await page.goto(`${server.address}setup.html`);
await page.getByRole("button", { name: "Connect by USB or serial", exact: true }).click();
await page.getByRole("button", { name: "Record", exact: true }).waitFor();
await page.waitForTimeout(3000);
await page.screenshot({ path: picture });
await browser.close();
server.close();
ends.close();
board.stop();
