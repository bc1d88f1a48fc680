// Tests of the playground in Chromium, with software WebGL, from a server of its own.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { after, test } from "node:test";
import zlib from "node:zlib";

import { button, checkLook, looks, outcome, spy, tabTo, testsOf, told, visit } from "./browsing.mjs";
import { addressOf, launch, root, sbgc, serve, site } from "./support.mjs";

const browser = await launch(["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--js-flags=--expose-gc"]);
const server = await serve();
const inPage = testsOf(browser);
after(() => Promise.all([browser.close(), server.close()]));

const withoutWebGL = () => {
  const get = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
    return kind.startsWith("webgl") ? null : get.call(this, kind, ...rest);
  };
};

/** Opens the playground, and runs `work(page)` when the gimbal is there. `scene`: with WebGL, which takes much time. */
const play = (work, { hash = "", scene = false, prepare = [], ...look } = {}) =>
  visit(browser, `${server.address}playground.html${hash}`, async (page) => {
    await button(page, "Motors off").and(page.locator(":enabled")).waitFor();
    await work(page);
  }, { ...look, prepare: [spy, ...(scene ? [] : [withoutWebGL]), ...prepare] });

const axisOfScene = (page) => page.evaluate(() => globalThis.sbgcPlayground.opticalAxis());

async function motorsOn(page) {
  await button(page, "Motors on").click();
  await outcome(page, "Motors on: done");
}

/** Makes time pass quickly. */
const hurry = (page) => page.locator(".pace select").selectOption("16");

async function findings(page) {
  await button(page, "Examine").click();
  await page.locator(".doctor [aria-busy=false]").waitFor({ timeout: 60_000 });
  const found = page.locator("[data-finding]");
  return found.evaluateAll((all) => all.map((one) => one.dataset.finding));
}

test("a move to 30 degrees down and 40 right is where the lens of the scene points", () => play(async (page) => {
  await motorsOn(page);
  await page.getByLabel("Yaw", { exact: true }).first().fill("40");
  await page.getByLabel("Pitch", { exact: true }).first().fill("30");
  await button(page, "Move").click();
  await outcome(page, "Move: done");
  await page.waitForFunction(() => globalThis.sbgcPlayground.opticalAxis());
  await page.waitForTimeout(300); // for the next view
  const [right, up, forward] = await axisOfScene(page);
  const degrees = (radians) => (radians * 180) / Math.PI;
  assert.ok(Math.abs(degrees(Math.asin(-up)) - 30) < 0.5, `${degrees(Math.asin(-up))} down`);
  assert.ok(Math.abs(degrees(Math.atan2(right, forward)) - 40) < 0.5, "to the right");
  assert.match(await page.locator(".numbers").textContent(), /30\.\d° down/);
}, { scene: true }));

test("the camera stays where it is while the frame moves", () => play(async (page) => {
  await motorsOn(page);
  await page.getByLabel("Vehicle").check();
  const seen = await page.evaluate(async () => {
    const all = [];
    for (let n = 0; n < 60; ++n) {
      await new Promise((resolve) => setTimeout(resolve, 50));
      const cells = [...document.querySelectorAll(".numbers tbody tr:nth-child(2) td")];
      all.push([0, 2].map((cell) => parseFloat(cells[cell].textContent)));
    }
    return all;
  });
  const most = (column) => Math.max(...seen.map((row) => row[column]));
  assert.ok(most(1) > 1, `the frame: ${most(1)}`);
  assert.ok(most(0) < most(1) / 3, `the camera: ${most(0)}`);
}));

test("the doctor names each fault that is switched on, and no other", async () => {
  const expected = {
    "Low battery": "battery",
    Imbalance: "balance",
    "Blocked motor": "motor-power",
    Resonance: "vibration",
    "Gyroscope drifts": "attitude",
    "Errors of the I2C bus": "i2c",
    "Errors the board counts": "line",
    "Slow controller": "cycle-time",
    "No motion sensor": "ERR_NO_SENSOR",
    "Missed steps": "ERR_MISS_STEPS",
    "Emergency stop": "ERR_EMERGENCY_STOP",
    "Bits flip": "line",
    "Bytes are lost": "line",
    "Bytes double": "line",
  };
  const damage = ["Bits flip", "Bytes are lost", "Bytes double"];
  await play(async (page) => {
    const switches = await page.locator(".fault label").allTextContents();
    for (const label of [null, ...Object.keys(expected)]) {
      const box = page.getByLabel(label ?? "", { exact: true });
      if (label) await box.check();
      await page.waitForTimeout(300); // the page waits for more changes
      await button(page, "New board").click();
      await button(page, "Motors on").and(page.locator(":enabled")).waitFor();
      await hurry(page);
      await motorsOn(page);
      const found = await findings(page);
      // Some damage passes the sums of the first framing, and may look like another fault.
      const sure = damage.includes(label) ? found.filter((one) => one === "line") : found;
      assert.deepEqual(sure, label ? [expected[label]] : [], label ?? "no fault");
      if (label) await box.uncheck();
    }
    // Late bytes damage nothing.
    assert.deepEqual(switches.filter((one) => !expected[one]), ["Bytes are late"]);
  });
});

test("with the keyboard alone, a gimbal turns and Escape stops it", () => play(async (page) => {
  await tabTo(page, "Motors on");
  await page.keyboard.press("Enter");
  await outcome(page, "Motors on: done");
  await tabTo(page, "Yaw, slider");
  for (let n = 0; n < 5; ++n) await page.keyboard.press("ArrowRight");
  await outcome(page, "Move");
  await tabTo(page, "Turn");
  await page.keyboard.press("Space");
  await page.waitForTimeout(500);
  await page.keyboard.press("Escape");
  await outcome(page, "Stop: done");
  const actions = (await told(page, "act")).map(({ action }) => action.split(" ")[0]);
  assert.equal(actions[0], "motors");
  assert.ok(actions.includes("move"), "a slider takes the camera along");
  assert.deepEqual(actions.slice(-2), ["turn", "stop"]);
}));

for (const scene of [false, true]) {
  test(`axe-core has nothing to say, and all fits, ${scene ? "with" : "without"} WebGL`, () => play(async (page) => {
    await motorsOn(page);
    await page.getByLabel("Resonance").check();
    await page.getByLabel("Bits flip").check();
    await button(page, "Show the log").click();
    await page.locator(".log details").first().waitFor();
    await button(page, "Pause").click();
    await page.locator(".log summary").first().click();
    await page.locator(".pace select").selectOption("0"); // what changes is drawn again meanwhile
    await checkLook(page, "", looks.filter(({ viewport }) => viewport.width > 1000 === scene));
  }, { bypassCSP: true, scene }));
}

test("a bad link is refused in words, and nothing of it is used", () => visit(browser, "about:blank", async (page) => {
  for (const [hash, words] of [
    ["#pitch=999", "from -90 to 90"],
    ["#yaw=20&pitch=1e1", "from -90 to 90"],
    ["#yaw=20&faults=imu,none", "no such fault"],
    ["#yaw=20&faults=resonance=37Hz:2:left", "no such fault"],
    ["#yaw=20&motion=boat", "rest, handheld, drone, vehicle"],
    ["#yaw=20&send=3e5", "in hex"],
    ["#yaw=20&yaw=30", "twice"],
    ["#yaw=20&__proto__=1", "no such value"],
    [`#yaw=20&send=${"00".repeat(3000)}`, "longer than"],
    ["#yaw=20&<img src=x onerror=alert(1)>", "no such value"],
  ]) {
    await page.goto(`${server.address}playground.html${hash}`);
    await page.reload(); // another link alone does not open the page anew
    const said = await page.getByRole("alert").textContent();
    assert.ok(said.includes(words), `${hash.slice(0, 40)}: ${said}`);
    assert.equal(await page.getByLabel("Yaw", { exact: true }).first().inputValue(), "0");
  }
}, { prepare: [withoutWebGL] }));

test("the link that skips to the content is no bad link", async () => {
  const work = async (page) => assert.equal(await page.getByRole("alert").count(), 0);
  await play(work, { hash: "#main" });
});

test("opening a link fills in its values and sends nothing", async () => {
  const frame = "3e56005600"; // a request for CMD_BOARD_INFO
  await play(async (page) => {
    assert.equal(await page.getByLabel("Pitch", { exact: true }).first().inputValue(), "-12.5");
    assert.ok(await page.getByLabel("Drone").isChecked());
    assert.ok(await page.getByLabel("No motion sensor").isChecked());
    const [{ options }] = await told(page, "start");
    assert.deepEqual(options.faults, ["resonance=50Hz:1:roll", "imu"]);
    await page.locator(".trial summary", { hasText: "BoardInfoRequest" }).waitFor();
    assert.deepEqual([...(await told(page, "act")), ...(await told(page, "send"))], []);
    await button(page, "Send").click();
    await page.locator(".trial summary", { hasText: /BoardInfo(?!Request)/ }).waitFor();
    const link = page.locator(".trial a", { hasText: /^BoardInfo$/ });
    assert.ok(fs.existsSync(path.join(site, await link.getAttribute("href"))));
    await button(page, "Link to these values").click();
    await page.locator(".share [role=status]", { hasText: "link" }).waitFor();
    assert.match(page.url(), /#pitch=-12.5&.*motion=drone.*&send=3e56005600$/);
  }, { hash: `#pitch=-12.5&motion=drone&faults=imu,resonance=50Hz:1:roll&send=${frame}` });
});

test("a message page leads to the playground with the values of its form, unless one is a secret", inPage(async (page) => {
  await page.goto(`${addressOf("messages/control.html")}`);
  await page.locator("#builder summary").click();
  const href = await page.locator(".built-trial").getAttribute("href");
  assert.match(href, /playground\.html#send=3e43[0-9a-f]+$/);
  await page.goto(addressOf("messages/pass-protect-write.html"));
  await page.locator("#builder summary").click();
  await page.locator("[id='build-new_password']").fill("secret");
  await page.locator(".built-command", { hasText: "new_password=@FILE" }).waitFor();
  assert.equal(await page.locator(".built-trial").count(), 0);
}));

test("the log decodes frames as `sbgc decode` does, and leads to their pages", () => play(async (page) => {
  await button(page, "Show the log").click();
  await page.locator(".log details").nth(20).waitFor();
  // Paused by the page itself, before new frames displace the request.
  const paused = page.waitForFunction(() => {
    const isThere = document.querySelector(".log details.host") !== null;
    if (isThere) document.querySelector(".log button:last-child").click();
    return isThere;
  }, null, { polling: 5 });
  await motorsOn(page);
  await paused;
  await page.waitForTimeout(300); // it still takes frames until it is drawn
  const entries = page.locator(".log details");
  await entries.evaluateAll((all) => all.forEach((one) => (one.open = true)));
  await page.waitForFunction(() => [...document.querySelectorAll(".log details")].every((one) => one.querySelector("pre")));
  const frames = await entries.evaluateAll((all) =>
    all.map((one) => ({
      from: one.classList.contains("host") ? "host" : "board",
      message: one.querySelector("b").textContent,
      hex: one.querySelector("pre").textContent.trim(),
      page: one.querySelector("a")?.getAttribute("href"),
    })),
  );
  assert.ok(frames.length > 10);
  for (const from of ["host", "board"]) {
    const sent = frames.filter((one) => one.from === from);
    const input = sent.map(({ hex }) => hex).join("\n");
    const { stdout } = spawnSync(sbgc, ["decode", "--hex", "--format", "jsonl", "--from", from], { input });
    const decoded = stdout.toString().trim().split("\n").map((line) => JSON.parse(line).message);
    assert.deepEqual(sent.map(({ message }) => message), decoded);
    for (const one of sent) assert.ok(fs.existsSync(path.join(site, one.page)), one.message);
  }
}));

test("the lines of C++ compile, and those of the command are known to it", async () => {
  const lines = {};
  await play(async (page) => {
    for (const language of ["Command", "C++"]) {
      await page.getByLabel(language, { exact: true }).check();
      lines[language] = await page.locator(".line code").allTextContents();
    }
  });
  const commands = lines.Command.filter((one) => !/^sbgc (emulate|doctor)/.test(one));
  for (const command of commands) {
    const { stderr } = spawnSync("bash", ["-c", `${command.replace(/^sbgc/, `'${sbgc}'`)} -p /nowhere`]);
    // It fails when it asks or opens the port, not before.
    assert.match(stderr.toString(), /no port|no terminal/, command);
  }
  const functions = lines["C++"].map((text, n) => `sbgc::Result<void> f${n}(sbgc::Client& client) {\n${text}\nreturn {};\n}`);
  assert.ok(functions.length > 6);
  const headers = ["client/client", "client/motion", "client/speed_control", "doctor/findings", "doctor/measure", "messages/control"];
  const program = [
    ...headers.map((one) => `#include <sbgc/${one}.hpp>`),
    "#include <chrono>\n#include <cstdio>\n#include <thread>",
    "using namespace sbgc::literals;\nusing namespace std::chrono_literals;",
    ...functions,
  ].join("\n");
  const libraries = ["core", "session", "tasks", "any", "io", "client", "analysis", "doctor"];
  const folders = [...libraries.map((one) => `runtime/${one}/include`), "generated/include"].map((one) => `-I${path.join(root, one)}`);
  const made = spawnSync("g++", ["-std=c++20", "-fsyntax-only", "-Wall", ...folders, "-x", "c++", "-"], { input: program });
  assert.equal(made.stderr.toString(), "");
});

test("without WebGL there are numbers, charts and the horizon", () => play(async (page) => {
  await page.locator(".gimbal-view", { hasText: "no WebGL" }).waitFor();
  await motorsOn(page);
  await button(page, "Move").click();
  await page.locator(".numbers", { hasText: /30\.\d° down/ }).waitFor();
  await page.locator(".horizons canvas[aria-label*='down']").first().waitFor();
  await page.locator(".charts canvas").first().waitFor();
  const loaded = await page.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => name));
  assert.deepEqual(loaded.filter((name) => name.includes("view3d")), []);
}));

test("without JavaScript, the page says what it needs", inPage(async (page) => {
  await page.goto(`${server.address}playground.html`);
  assert.match(await page.locator("noscript").textContent(), /sbgc emulate/);
}, { javaScriptEnabled: false }));

test("from a file, the page says what it needs", () =>
  visit(browser, addressOf("playground.html"), async (page) => {
    assert.match(await page.locator("main").innerText(), /only from a server.*python3 -m http\.server/s);
  }));

/** Opens the playground, and waits for what keeps it for use without a network. */
async function openKept(page) {
  await page.goto(`${server.address}playground.html`);
  await page.evaluate(async () => (await navigator.serviceWorker.ready).active.state);
}

test("it is usable without a network, once it was open", inPage(async (page) => {
  await openKept(page);
  await page.context().setOffline(true);
  await page.reload();
  await button(page, "Motors on").and(page.locator(":enabled")).click();
  await outcome(page, "Motors on: done");
  await page.waitForFunction(() => globalThis.sbgcPlayground.opticalAxis());
}));

test("it says when a newer version is there, and goes over to it", inPage(async (page) => {
  await openKept(page);
  await page.reload(); // under the service worker
  await button(page, "Motors on").and(page.locator(":enabled")).waitFor();
  assert.equal(await button(page, "Use it").count(), 0);
  const old = fs.readFileSync(path.join(site, "service-worker.js"), "utf8");
  const fingerprint = /"([0-9a-f]{16})"/.exec(old)[1];
  server.changed["/service-worker.js"] = old.replace(fingerprint, "0123456789abcdef");
  await page.reload();
  await Promise.all([page.waitForEvent("load"), button(page, "Use it").click()]);
  await button(page, "Motors on").and(page.locator(":enabled")).waitFor();
  const caches = await page.evaluate(async () => (await globalThis.caches.keys()).map((name) => name.split(" ").at(-1)));
  assert.deepEqual(caches, ["0123456789abcdef"]);
  delete server.changed["/service-worker.js"];
}));

test("it is light: what comes first, and all of it", () => {
  const sizes = {};
  for (const name of fs.readdirSync(path.join(site, "assets/playground"))) {
    const file = fs.readFileSync(path.join(site, "assets/playground", name));
    const key = name.replace(/-[A-Z0-9]{8}/, "");
    sizes[key] = (sizes[key] ?? 0) + zlib.gzipSync(file, { level: 9 }).length;
  }
  const sum = (names) => names.reduce((total, name) => total + sizes[name], 0);
  assert.ok(sum(["main.js", "chunk.js"]) < 30_000, JSON.stringify(sizes));
  assert.ok(sizes["gimbal.wasm"] < 350_000, JSON.stringify(sizes));
  assert.ok(sum(["main.js", "chunk.js", "worker.js", "plot.js", "gimbal.wasm"]) < 400_000, JSON.stringify(sizes));
  assert.ok(sum(Object.keys(sizes)) < 1_175_000, JSON.stringify(sizes));
});

// SBGC_PLAY_SECONDS: how long it plays.
test("minutes of play, with the log, take no more memory than the first", () => play(async (page) => {
  const session = await page.context().newCDPSession(page);
  const used = async () => {
    await session.send("HeapProfiler.collectGarbage");
    const { usedSize } = await session.send("Runtime.getHeapUsage");
    return { usedSize, elements: await page.evaluate(() => document.querySelectorAll("*").length) };
  };
  await motorsOn(page);
  await page.getByLabel("Hand-held").check();
  await button(page, "Show the log").click();
  await hurry(page);
  const seconds = async () => Number(/([\d.]+) s\b/.exec(await page.locator(".status .board").innerText())[1]);
  await page.waitForTimeout(10_000);
  const [first, from] = [await used(), await seconds()];
  await page.waitForTimeout(Number(process.env.SBGC_PLAY_SECONDS ?? 20) * 1000);
  const [last, to] = [await used(), await seconds()];
  assert.ok(to - from > 60, `${to - from} s`);
  assert.ok(last.usedSize < first.usedSize * 1.15 + 2e6, `${first.usedSize} to ${last.usedSize} bytes`);
  assert.ok(last.elements < first.elements * 1.1, `${first.elements} to ${last.elements} elements`);
}, { scene: true, viewport: { width: 390, height: 500 } }));
