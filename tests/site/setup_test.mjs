// Tests of the page that sets up a real gimbal, in Chromium: an emulated board behind the real bridge.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, test } from "node:test";

import { button, checkLook, looks, outcome, spy, tabTo, told, toldAtLeast, visit } from "./browsing.mjs";
import { gimbal, start } from "./serial.mjs";
import { launch, root, sbgc, serve, site } from "./support.mjs";

const token = (process.env.SBGC_TOKEN = "token-of-the-test");
const browser = await launch();
const server = await serve();
const board = await gimbal("--calibration-time", "10");
/** The same board for the command. */
const native = ["-p", `tcp:127.0.0.1:${board.port}`];
const origin = server.address.replace(/\/$/, "");
const bridge = await start(["bridge", native[1], "--ws", "0", "--origin", origin], /ws:\S+:\d+/);
after(async () => {
  await browser.close();
  server.close();
  bridge.stop();
  board.stop();
});

const view = (page, name) => page.getByRole("radio", { name }).check();
const arm = (page) => page.getByRole("switch", { name: "Arm motion" }).and(page.locator(":visible")).first();

const open = (work, { hash = "", prepare = [], ...look } = {}) =>
  visit(browser, `${server.address}setup.html${hash}`, async (page) => {
    await page.getByRole("heading", { name: "Connect" }).waitFor();
    await work(page);
  }, { ...look, prepare: [spy, ...prepare] });

/** Opens the page, and connects it to the board. */
const connected = (work, options) =>
  open(async (page) => {
    await view(page, "sbgc bridge");
    await page.getByLabel("Address").fill(bridge.found[0]);
    await page.getByLabel("Token").fill(token);
    await button(page, "Connect to the bridge").click();
    await page.getByRole("radio", { name: "Look and move" }).waitFor();
    await work(page);
  }, options);

async function readParameters(page) {
  await view(page, "Parameters");
  await button(page, "Read the parameters").click();
  await page.locator(".topic").first().waitFor({ timeout: 60_000 });
}

/** Shows one parameter; returns its field. */
async function field(page, name) {
  await page.getByLabel("Search the parameters").fill(name);
  return page.locator(".parameter", { has: page.getByText(name, { exact: true }) }).locator("input, select").first();
}

/** Writes what is under review. */
async function write(page) {
  await page.locator(".review").getByRole("button", { name: "Write" }).click();
  await page.getByRole("dialog").getByRole("button", { name: "Write" }).click();
  await page.locator(".written.good").waitFor({ timeout: 60_000 });
}

const nativeValue = (...name) => {
  const { stdout, stderr } = spawnSync(sbgc, ["params", "get", ...name, ...native]);
  return stdout.toString() + stderr.toString();
};

test("opening the page, with any address, sends and arms nothing; the token does not stay in it", async () => {
  for (const hash of ["", `#token=${token}`, "#pitch=30&send=3e56005600&arm=1"]) {
    await open(async (page) => {
      await page.waitForTimeout(300);
      assert.deepEqual(await page.evaluate(() => globalThis.told), []);
      assert.ok(!page.url().includes("token"), page.url());
      const kept = await page.evaluate(() => JSON.stringify([{ ...localStorage }, { ...sessionStorage }]));
      assert.ok(!kept.includes("token-of"), kept);
      if (hash.includes("token")) assert.equal(await page.getByLabel("Token").inputValue(), token);
    }, { hash });
  }
});

test("without Web Serial, the page says why and what helps", async () => {
  const prepare = () => delete Navigator.prototype.serial;
  await open(async (page) => {
    const note = await page.locator(".note.warn:visible").innerText();
    assert.match(note, /no Web Serial.*sbgc bridge --page/s);
    await button(page, "Connect to the bridge").and(page.locator(":enabled")).waitFor();
  }, { prepare: [prepare] });
});

test("a worker of another version makes the page load again, once, and does not connect", async () => {
  const worker = "/assets/playground/setup_worker.js";
  const code = fs.readFileSync(path.join(site, worker), "utf8");
  const [version] = /"[0-9a-f]{16}"/.exec(code);
  server.changed[worker] = code.replace(version, '"0123456789abcdef"');
  try {
    await open(async (page) => {
      await page.getByRole("alert").filter({ hasText: "although it was loaded again" }).waitFor();
      assert.ok(await page.getByRole("button", { name: /^Connect/ }).first().isDisabled());
    });
  } finally {
    delete server.changed[worker];
  }
});

test("motion is locked until it is armed; held keys turn, and let go they stop", () => connected(async (page) => {
  assert.ok(await button(page, "Motors on").isDisabled());
  await arm(page).click();
  await button(page, "Motors on").click();
  await outcome(page, "Motors on: done");
  await button(page, "Arrow keys").click();
  await page.keyboard.down("ArrowRight");
  await toldAtLeast(page, "hold", 8);
  await page.keyboard.up("ArrowRight");
  const holds = (await told(page, "hold")).map(({ speeds }) => speeds);
  assert.deepEqual(holds[0], [0, 0, 20]);
  assert.deepEqual(holds.at(-1), [0, 0, 0]);
  await page.locator(".numbers", { hasText: /\d\.\d° right/ }).waitFor();
  await page.keyboard.down("ArrowLeft");
  await page.waitForTimeout(200);
  await page.keyboard.press("Escape");
  const before = (await told(page, "hold")).length;
  await page.waitForTimeout(300);
  assert.equal((await told(page, "hold")).length, before, "after a stop, what is still held turns nothing");
  await page.keyboard.up("ArrowLeft");
}));

test("a pointer turns as long as it presses, a gamepad as long as its shoulder button is held", async () => {
  const prepare = () => {
    globalThis.pad = { id: "Test pad", axes: [0.05, -1, 0], buttons: Array.from({ length: 12 }, () => ({ pressed: false })) };
    navigator.getGamepads = () => [null, globalThis.pad];
  };
  await connected(async (page) => {
    const speeds = async () => (await told(page, "hold")).map((one) => one.speeds);
    await page.waitForTimeout(200);
    assert.deepEqual(await speeds(), []);
    await arm(page).click();
    let pressed = [];
    for (const [name, turn] of [["Pitch down", [0, 20, 0]], ["Roll right", [20, 0, 0]]]) {
      await button(page, name).hover();
      const before = pressed.length;
      await page.mouse.down();
      await toldAtLeast(page, "hold", before + 5);
      await page.mouse.up();
      pressed = await speeds();
      assert.deepEqual([pressed[before], pressed.at(-2), pressed.at(-1)], [turn, turn, [0, 0, 0]], name);
    }
    const hold = (on) => page.evaluate((is) => (globalThis.pad.buttons[5].pressed = is), on);
    await page.waitForTimeout(200);
    assert.equal((await speeds()).length, pressed.length, "tilted sticks alone turn nothing");
    await hold(true);
    await page.waitForTimeout(300);
    await hold(false);
    await page.waitForTimeout(150);
    const tilted = (await speeds()).slice(pressed.length);
    assert.deepEqual([tilted[0], tilted.at(-1)], [[0, -20, 0], [0, 0, 0]]);
  }, { prepare: [prepare] });
});

test("with the keyboard alone: connected, armed, turned, stopped", () => open(async (page) => {
  await tabTo(page, "USB or serial");
  await page.keyboard.press("ArrowRight");
  await tabTo(page, "Address");
  await page.keyboard.press("Control+A");
  await page.keyboard.type(bridge.found[0]);
  await tabTo(page, "Token");
  await page.keyboard.type(`${token}\n`);
  await page.getByRole("radio", { name: "Look and move" }).waitFor();
  for (const name of ["Arm motion", "Motors on"]) {
    await tabTo(page, name);
    await page.keyboard.press("Space");
  }
  await outcome(page, "Motors on: done");
  await tabTo(page, "Roll left");
  await page.keyboard.down("Space");
  await page.waitForTimeout(200);
  await page.keyboard.press("Escape");
  await page.keyboard.up("Space");
  await outcome(page, "Stop: done");
  assert.deepEqual((await told(page, "hold"))[0].speeds, [-20, 0, 0]);
}));

test("a parameter is edited, planned, tried, written, read by the command, and undone", () => connected(async (page) => {
  await readParameters(page);
  const p = await field(page, "axes.roll.p");
  const old = await p.inputValue();
  await p.fill("999");
  await button(page, "Review").click();
  await page.locator(".review [role=alert]").waitFor();
  assert.ok(await page.locator(".review").getByRole("button", { name: "Write" }).isDisabled());
  await p.fill("77");
  const profile = page.getByLabel("Profile of the parameters");
  await profile.selectOption("2");
  await page.waitForFunction((one) => one.value !== "77", await p.elementHandle());
  await p.fill("55");
  await page.getByText("1 changed in profile 1, 1 changed in profile 2", { exact: true }).waitFor();
  await button(page, "Review").click();
  await write(page);
  assert.match(nativeValue("axes.roll.p", "--profile", "2"), /\b55\b/);
  assert.doesNotMatch(nativeValue("axes.roll.p", "--profile", "1"), /\b77\b/);
  await profile.selectOption("1");
  await page.waitForFunction((one) => one.value === "77", await p.elementHandle());
  await button(page, "Review").click();
  await page.locator(".review tbody", { hasText: "axes.roll.p" }).waitFor();
  await button(page, "Try on the emulated board").click();
  await page.getByRole("heading", { name: "With the changes" }).waitFor({ timeout: 60_000 });
  await button(page, "Write").click();
  const kinds = async () => (await told(page, "stop", "write")).map(({ kind, name }) => name ?? kind);
  const before = await kinds();
  await page.keyboard.press("Escape"); // stops before it closes the dialog
  await page.getByRole("dialog").waitFor({ state: "detached" });
  assert.deepEqual(await kinds(), [...before, "stop"]);
  await write(page);
  assert.match(nativeValue("axes.roll.p"), /\b77\b/);
  await button(page, "Undo the last write").click();
  await write(page);
  await page.waitForFunction(([one, value]) => one.value === value, [await p.elementHandle(), old]);
  assert.doesNotMatch(nativeValue("axes.roll.p"), /\b77\b/);
}));

test("a backup is saved and restored, by the page and by the command", async () => {
  const file = path.join(fs.mkdtempSync(path.join(os.tmpdir(), "sbgc-")), "backup.json");
  await connected(async (page) => {
    await readParameters(page);
    const [saved] = await Promise.all([page.waitForEvent("download"), button(page, "Save a backup").click()]);
    assert.match(saved.suggestedFilename(), /^sbgc-[\dT-]+\.json$/);
    await saved.saveAs(file);
    const old = nativeValue("axes.pitch.p");
    await (await field(page, "axes.pitch.p")).fill("66");
    await button(page, "Review").click();
    await write(page);
    await page.locator("input[type=file]").setInputFiles(file);
    await page.locator(".review tbody", { hasText: "axes.pitch.p" }).waitFor({ timeout: 60_000 });
    await write(page);
    assert.equal(nativeValue("axes.pitch.p"), old);
    await page.locator("input[type=file]").setInputFiles(path.join(root, "tests/data/studio.profile"));
    await page.locator(".review li, .review tbody").first().waitFor();
    const { stderr, status } = spawnSync(sbgc, ["params", "restore", file, "--yes", ...native]);
    assert.equal(status, 0, stderr.toString());
  });
  fs.rmSync(path.dirname(file), { recursive: true });
});

test("what the line says is text, never markup", async () => {
  const hostile = "<img src=x onerror=globalThis.hacked=1>";
  const renamed = spawnSync(sbgc, ["params", "rename", "1", hostile, "--yes", ...native], { encoding: "utf8" });
  assert.equal(renamed.status, 0, renamed.stderr);
  await connected(async (page) => {
    await readParameters(page);
    await page.getByLabel("Search the parameters").fill("readprofilenames");
    assert.ok((await page.locator(".parameter input").evaluateAll((all) => all.map((one) => one.value))).includes(hostile));
    await page.locator(".parameter input").first().fill(`${hostile}2`);
    await button(page, "Review").click();
    await page.locator(".review tbody", { hasText: "<img" }).waitFor();
    assert.equal(await page.locator("#application img").count(), 0);
    assert.equal(await page.evaluate(() => globalThis.hacked), undefined);
  });
});

test("a calibration says what to prepare, is checked, asks and is done", () => connected(async (page) => {
  await view(page, "Care");
  const card = page.locator(".topic:visible", { hasText: "gyro" }).first();
  await card.locator("summary").click();
  await card.getByRole("button", { name: "Check" }).click();
  await card.locator(".good, .bad", { hasText: /./ }).waitFor();
  await card.getByRole("button", { name: "Calibrate" }).click();
  await page.getByRole("dialog").getByRole("button", { name: "Calibrate" }).click();
  await card.getByText("The calibration is done.").waitFor({ timeout: 60_000 });
}));

test("axe-core has nothing to say, and all fits, in every look", () => connected(async (page) => {
  await arm(page).click();
  await checkLook(page, "move");
  await readParameters(page);
  await (await field(page, "axes.yaw.p")).fill("9");
  await button(page, "Review").click();
  await page.locator(".review tbody").waitFor();
  await checkLook(page, "parameters");
  for (const { viewport } of looks) {
    await page.setViewportSize(viewport);
    await page.locator(".status .stop").click({ trial: true }); // nothing covers it
  }
  await button(page, "Write").click();
  await checkLook(page, "dialog");
  await button(page, "Leave it").click();
  await view(page, "Care");
  await page.locator(".topic:visible summary").first().click();
  await checkLook(page, "care");
  await button(page, "Disconnect").click();
  await page.getByRole("heading", { name: "Connect" }).waitFor();
  await checkLook(page, "connect");
}, { bypassCSP: true }));
