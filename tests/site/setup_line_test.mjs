// The line of the page that sets up a gimbal: it is found, lost and found again, and what moves ends when
// page, cable or bridge do. The gimbal is `sbgc emulate`; another client watches its camera.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import net from "node:net";
import os from "node:os";
import path from "node:path";
import { Duplex } from "node:stream";
import { after, before, test } from "node:test";

import { button, drawSeldom } from "./browsing.mjs";
import { cables, gimbal, giveSerial, start } from "./serial.mjs";
import { launch, packageIn, sbgc, serve, site } from "./support.mjs";

/** Kills during motion; the night runs more. */
const kills = Number(process.env.SBGC_KILLS ?? 8);
const speed = 20;
/** CMD_CONTROL in a frame of the host. */
const isControl = (bytes) => bytes[1] === 67;

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "sbgc-setup-"));
const sdk = await packageIn(folder);
const browser = await launch();
const server = await serve();
let board;
let camera;
const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

before(() => powerOn("2.59"));
after(async () => {
  await browser.close();
  server.close();
  board?.stop();
  fs.rmSync(folder, { recursive: true });
});

/** Before 2.61, a board has no timeout that bounds a motion. */
async function powerOn(firmware) {
  await camera?.close();
  board?.stop();
  board = await gimbal("--firmware", firmware);
  camera = await sdk.connect(Duplex.toWeb(net.connect(board.port, "127.0.0.1")));
}

async function comesTrue(holds, ms = 10_000) {
  for (let left = ms; left > 0; left -= 50) {
    if (holds()) return true;
    await wait(50);
  }
  return false;
}
const until = async (holds, what) => assert.ok(await comesTrue(holds), what);
const yaw = () => camera.view.camera[2];
const turns = () => Math.abs(camera.view.speeds[2]) > speed / 4;

/** Opens the page with a line, and connects it. */
async function withSerial(line, work) {
  const ends = await cables(board, line);
  const context = await browser.newContext();
  const page = await context.newPage();
  try {
    await context.addInitScript(drawSeldom);
    await giveSerial(context, server, ends.url);
    await page.goto(`${server.address}setup.html`);
    await connect(page);
    await work(page, ends.cable, context);
  } finally {
    await context.close();
    ends.close();
  }
}

/** A busy machine may answer too late for the search, or after it: then it is repeated. */
async function connect(page, by = "Connect by USB or serial") {
  const found = page.getByText(/board 3\.\d, firmware/).first();
  const problem = page.getByRole("region", { name: "Connect" }).locator("p.bad");
  const problems = [];
  for (let i = 0; i < 5; ++i) {
    await button(page, by).click();
    await found.or(problem).first().waitFor({ timeout: 60_000 });
    if (await found.isVisible()) return;
    problems.push(await problem.innerText());
  }
  assert.fail(problems.join("; "));
}

async function arm(page) {
  await page.getByRole("switch", { name: "Arm motion" }).first().click();
  await button(page, "Motors on").click();
  await until(() => camera.view.motorsOn, "the motors are on");
}

/** Turns right as long as the key is held. A busy machine may interrupt it: then it is pressed again. */
async function turn(page) {
  for (let i = 0; i < 5; ++i) {
    await button(page, "Yaw right").focus();
    await page.keyboard.down("ArrowRight");
    if (await comesTrue(turns, 3000)) return;
    await page.keyboard.up("ArrowRight");
    await wait(200);
  }
  assert.fail("the camera does not turn");
}

async function armAndTurn(page) {
  await arm(page);
  await turn(page);
}

/** Moves far to the other side. */
async function move(page) {
  await page.getByRole("spinbutton", { name: "Yaw" }).first().fill(yaw() > 0 ? "-170" : "170");
  await button(page, "Move").first().click();
  await until(turns, "the camera turns");
}

/** Fails if the camera still turns after the bound of a motion, and some time to brake. */
async function brakes() {
  const begin = yaw();
  await wait(1500);
  const rest = yaw();
  await wait(500);
  assert.ok(Math.abs(yaw() - rest) < 0.5, `it still turns: ${rest}, ${yaw()}`);
  // 0.5 s of turning, and what the machine takes to notice.
  assert.ok(Math.abs(rest - begin) < 1.5 * speed, `${begin} to ${rest}`);
}

test("an unusual line is found, on the chosen one of two equal adapters", () =>
  withSerial({ baudRate: 38400, parity: "even" }, async (page, cable) => {
    const [last] = cable.opened.slice(-1);
    assert.deepEqual(last, { index: "1", baudRate: 38400, parity: "even" });
    await page.getByText("38400").first().waitFor();
  }));

test("a cable that is pulled is told, and found again; motion is locked then", () =>
  withSerial({}, async (page, cable) => {
    await arm(page);
    cable.pull();
    await page.getByText("the port is gone").first().waitFor();
    await page.getByText("motion locked").waitFor();
    await wait(2500); // it is looked for in vain
    cable.plug();
    await page.getByText(/^115200 baud/).waitFor();
    assert.ok(await button(page, "Motors on").isDisabled());
    await arm(page);
  }));

test("a second tab says who holds the port", () =>
  withSerial({}, async (page, _, context) => {
    const other = await context.newPage();
    await other.goto(`${server.address}setup.html`);
    await button(other, "Connect by USB or serial").click();
    await other.getByText("another tab").first().waitFor();
  }));

test("a stop overtakes what waits: at most the frame in the port is before it", () =>
  withSerial({}, async (page, cable) => {
    await armAndTurn(page);
    await page.getByRole("radio", { name: "Parameters" }).check({ force: true });
    await button(page, "Read the parameters").click();
    await page.keyboard.up("ArrowRight");
    const times = [];
    for (let i = 0; i < 5; ++i) {
      await wait(50);
      const before = cable.writes.length;
      const pressed = performance.now();
      await page.keyboard.press("Escape");
      await until(() => cable.writes.slice(before).some(({ bytes }) => isControl(bytes)), "a stop is sent");
      const sent = cable.writes.slice(before).find(({ bytes }) => isControl(bytes));
      times.push(sent.at - pressed);
    }
    // On a busy machine one may be late, but not the fastest of all.
    assert.ok(Math.min(...times) < 50, `${times.map((ms) => ms.toFixed(0))} ms`);
  }));

test("a page that is hidden goes on, and is locked", () =>
  withSerial({}, async (page, _, context) => {
    await armAndTurn(page);
    const front = await context.newPage();
    await front.bringToFront();
    await page.evaluate(() => {
      Object.defineProperty(document, "visibilityState", { value: "hidden" });
      Object.defineProperty(document, "hidden", { value: true });
      document.dispatchEvent(new Event("visibilitychange"));
    });
    await brakes();
    await page.getByText("motion locked").waitFor();
  }));

/** Stops the camera as another program: again while the page, on a busy machine, has not noticed the stop. */
async function stopFromOutside() {
  for (let attempt = 1; ; ++attempt) {
    try {
      return await camera.stop();
    } catch (error) {
      if (attempt === 3 || !/still turns|not come to rest/.test(error.message)) throw error;
    }
  }
}

for (const firmware of ["2.59", "2.70"]) {
  test(`another program stops a turn and a move of ${firmware}: the page yields`, async () => {
    await powerOn(firmware);
    await withSerial({}, async (page) => {
      await armAndTurn(page);
      await stopFromOutside();
      await brakes(); // the key is still held
      await page.keyboard.up("ArrowRight");
      await turn(page);
      await page.keyboard.up("ArrowRight");
      await until(() => !turns(), "the camera is still"); // or this turn would be taken for the move
      await move(page);
      await stopFromOutside();
      await brakes();
      const told = page.getByText("has stopped the camera").first();
      await told.waitFor().catch(async () => assert.fail(await page.locator("body").innerText()));
    });
  });
}

test("a computer that has slept wakes up with motion locked", () =>
  withSerial({}, async (page) => {
    await armAndTurn(page);
    const [worker] = page.workers();
    await worker.evaluate(() => {
      const asleep = performance.now();
      while (performance.now() - asleep < 2500);
    });
    await page.getByText("the computer has slept").first().waitFor();
    await page.getByText("motion locked").waitFor();
    await brakes();
  }));

const ways = {
  page: ({ context }) => context.close(),
  worker: ({ page }) => page.evaluate(() => location.replace("about:blank")),
  cable: ({ cable }) => cable.pull(),
  crash: async ({ page }) => page.goto("chrome://crash").catch(() => {}),
};
const versions = ["2.59", "2.70"];
for (let i = 0; i < kills; ++i) {
  const [name, kill] = Object.entries(ways)[i % Object.keys(ways).length];
  const isMove = i % 8 >= 4;
  const firmware = versions[(i >> 1) % 2];
  test(`kill ${i}: ${name} during ${isMove ? "a move" : "a turn"} of ${firmware}: the camera brakes`, async () => {
    await powerOn(firmware);
    await withSerial({}, async (page, cable, context) => {
      await arm(page);
      await (isMove ? move : turn)(page);
      await kill({ page, cable, context });
      await brakes();
    });
  });
}

const bridgeArguments = () => ["bridge", `tcp:127.0.0.1:${board.port}`, "--page", site];

test("a bridge that serves the page is killed during motion: the camera brakes", async (t) => {
  const bridge = await start(bridgeArguments(), /(http:.*token=.*)/);
  const context = await browser.newContext();
  t.after(() => Promise.all([context.close(), bridge.stop()]));
  const page = await context.newPage();
  await page.goto(bridge.found[1]);
  await connect(page, "Connect to the bridge");
  await armAndTurn(page);
  bridge.child.kill("SIGKILL");
  await brakes();
  await page.getByText("motion locked").waitFor();
});

test("the bridge serves its pages to this machine, and nothing else", async (t) => {
  const bridge = await start(bridgeArguments(), /(http:[^#]*)setup.html/);
  t.after(bridge.stop);
  const status = async (name) => (await fetch(bridge.found[1] + name)).status;
  assert.equal(await status("setup.html"), 200);
  assert.equal(await status("assets/playground/setup.wasm"), 200);
  assert.equal(await status("%2e%2e/CMakeCache.txt"), 404);
  assert.equal(await status(".git"), 404);
  const refused = spawnSync(sbgc, [...bridgeArguments(), "--ws", "0.0.0.0:0"], { encoding: "utf8" });
  assert.match(refused.stderr, /only for this machine/);
});

test("a recording is what `sbgc decode` reads", () =>
  withSerial({}, async (page) => {
    await button(page, "Record").click();
    await wait(500);
    const [download] = await Promise.all([page.waitForEvent("download"), button(page, /record/i).first().click()]);
    const file = path.join(folder, "one.capture");
    await download.saveAs(file);
    const { stdout, status } = spawnSync(sbgc, ["decode", file], { encoding: "utf8" });
    assert.equal(status, 0, stdout);
    assert.match(stdout, /CMD_REALTIME_DATA_4/);
  }));
