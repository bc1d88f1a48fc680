// Every page of the site in Chromium, from files.

import assert from "node:assert/strict";
import fs from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";

import { addressOf, inParallel, launch, pages } from "./support.mjs";

const all = pages();
let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

/** Notes in `problems` whatever goes wrong on a page, and every address that it asks for. */
function watch(page, problems, requests = []) {
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) problems.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => problems.push(`exception: ${error}`));
  page.on("requestfailed", (request) => problems.push(`failed: ${request.url()}`));
  page.on("request", (request) => {
    requests.push(request.url());
    if (!/^(file|blob|data):/.test(request.url())) problems.push(`network: ${request.url()}`);
  });
}

/** The pages to look at closely: of each folder the smallest and the largest, and all at the top. */
function samples() {
  const kinds = new Map();
  for (const name of all) {
    const folder = name.includes("/") ? name.split("/")[0] : name;
    kinds.set(folder, [...(kinds.get(folder) ?? []), name]);
  }
  const size = (name) => fs.statSync(fileURLToPath(addressOf(name))).size;
  return [...kinds.values()].flatMap((names) => {
    const sorted = names.sort((a, b) => size(a) - size(b));
    return [...new Set([sorted[0], sorted.at(-1)])];
  });
}

/** What sticks out to the right of the window. Boxes that scroll by themselves may hold more. */
function overflowing() {
  if (document.documentElement.scrollWidth <= innerWidth) return [];
  const scrolls = (element) =>
    element !== null &&
    element !== document.body &&
    (getComputedStyle(element).overflowX !== "visible" || scrolls(element.parentElement));
  return [...document.body.querySelectorAll("*")]
    .filter((e) => e.getBoundingClientRect().right > innerWidth && !scrolls(e.parentElement))
    .map((e) => e.outerHTML.slice(0, 100))
    .concat(`scrollWidth ${document.documentElement.scrollWidth}`);
}

test("every page loads without an error, asks only for files, and fits into 320 pixels", async () => {
  assert.ok(all.length > 1);
  const problems = [];
  const context = await browser.newContext({ viewport: { width: 320, height: 600 } });
  await inParallel(all, async (name) => {
    const page = await context.newPage();
    const found = [];
    watch(page, found);
    await page.goto(addressOf(name));
    found.push(...(await page.evaluate(overflowing)).map((what) => `too wide: ${what}`));
    if ((await page.locator("h1").count()) !== 1) found.push("not exactly one h1");
    problems.push(...found.map((problem) => `${name}: ${problem}`));
    await page.close();
  });
  await context.close();
  assert.deepEqual(problems, []);
});

test("axe-core has nothing to say about the pages", async () => {
  const axe = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
  const looks = [
    { colorScheme: "light", viewport: { width: 1280, height: 900 } },
    { colorScheme: "dark", viewport: { width: 390, height: 844 } },
  ];
  const problems = [];
  const jobs = samples().flatMap((name) => looks.map((look) => [name, look]));
  await inParallel(jobs, async ([name, look]) => {
    const page = await browser.newPage(look);
    await page.goto(addressOf(name));
    await page.addScriptTag({ path: axe });
    const { violations } = await page.evaluate(() => globalThis.axe.run({ preload: false }));
    for (const { id, help, nodes } of violations) {
      const where = nodes.map((node) => node.target.join(" ")).slice(0, 3);
      problems.push(`${name} (${look.colorScheme}): ${id}: ${help}: ${where.join(", ")}`);
    }
    await page.close();
  });
  assert.deepEqual(problems, []);
});

test("the start page weighs less than 300 kB", async () => {
  const page = await browser.newPage();
  const requests = [];
  watch(page, [], requests);
  await page.goto(addressOf("index.html"));
  const files = [...new Set(requests)].filter((url) => url.startsWith("file:"));
  const weight = files.reduce((sum, url) => sum + fs.statSync(fileURLToPath(url.split("#")[0])).size, 0);
  await page.close();
  assert.ok(files.length > 1);
  assert.ok(weight < 300_000, `${weight} bytes: ${files.join(" ")}`);
});

test("without JavaScript there is the content and a menu", async () => {
  const context = await browser.newContext({ javaScriptEnabled: false });
  for (const width of [1280, 390]) {
    const page = await context.newPage();
    await page.setViewportSize({ width, height: 800 });
    await page.goto(addressOf("index.html"));
    assert.ok(await page.locator("h1").isVisible());
    if (width < 960) await page.locator(".menu-button").click();
    const link = page.locator("#menu a[href$='decoder.html']");
    assert.ok(await link.isVisible());
    await link.click();
    assert.match(page.url(), /decoder\.html$/);
    const hint = page.locator("noscript");
    assert.ok(await hint.isVisible());
    assert.match(await hint.textContent(), /sbgc decode --hex/);
    assert.ok(!(await page.locator("#search").isVisible()));
    await page.close();
  }
  await context.close();
});

test("on paper there is the content without bars and menus", async () => {
  const problems = [];
  await inParallel(samples(), async (name) => {
    const page = await browser.newPage({ colorScheme: "dark" });
    await page.emulateMedia({ media: "print" });
    await page.goto(addressOf(name));
    const looks = await page.evaluate(() => {
      const hidden = (selector) =>
        [...document.querySelectorAll(selector)].every((e) => e.getClientRects().length === 0);
      const body = getComputedStyle(document.body);
      const cut = [...document.querySelectorAll("main .table")].some(
        (e) => getComputedStyle(e).overflowY !== "visible",
      );
      return {
        bars: hidden(".bar") && hidden(".menu"),
        content: !hidden("h1"),
        colours: [body.color, body.backgroundColor].join(" on "),
        cut,
      };
    });
    const expected = {
      bars: true,
      content: true,
      colours: "rgb(0, 0, 0) on rgb(255, 255, 255)",
      cut: false,
    };
    for (const [key, value] of Object.entries(expected)) {
      if (looks[key] !== value) problems.push(`${name}: ${key}: ${looks[key]}`);
    }
    await page.close();
  });
  assert.deepEqual(problems, []);
});
