// Tests of every page of the site in Chromium, opened from files.

import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";

import { axeProblems, testsOf } from "./browsing.mjs";
import { addressOf, forEachItem, launch, model, pages, site, slug } from "./support.mjs";

const all = pages();
const browser = await launch();
const inPage = testsOf(browser);
after(() => browser.close());

/** Loads a page of the site. Returns errors and all requested addresses. */
async function visit(page, name) {
  const problems = [];
  const requests = [];
  const listeners = {
    console: (message) => {
      const bad = ["error", "warning"].includes(message.type());
      if (bad) problems.push(`console: ${message.text()}`);
    },
    pageerror: (error) => problems.push(`exception: ${error}`),
    requestfailed: (request) => {
      const reason = request.failure().errorText;
      // Nothing waits for the icon; leaving the page aborts its request.
      if (reason !== "net::ERR_ABORTED") problems.push(`failed: ${request.url()}: ${reason}`);
    },
    request: (request) => {
      requests.push(request.url());
      if (!/^(file|blob|data):/.test(request.url())) problems.push(`network: ${request.url()}`);
    },
  };
  for (const [event, listener] of Object.entries(listeners)) page.on(event, listener);
  await page.goto(addressOf(name));
  for (const [event, listener] of Object.entries(listeners)) page.off(event, listener);
  return { problems, requests };
}

/** Returns the pages to check closely: all at the top level, and each of its folders' one of median size. */
function samples() {
  const size = (name) => fs.statSync(path.join(site, name)).size;
  const kinds = new Map();
  for (const name of [...all].sort((a, b) => size(a) - size(b))) {
    const kind = name.split("/")[0];
    kinds.set(kind, [...(kinds.get(kind) ?? []), name]);
  }
  return [...kinds.values()].map((names) => names[names.length >> 1]);
}

/** Returns the elements that overflow a window of this width. Scrollable boxes may be wider. */
async function overflowing(width) {
  while (innerWidth !== width) {
    await new Promise((resolve) => addEventListener("resize", resolve, { once: true }));
  }
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

// Every page takes a minute: only `./dev test --long`, which sets SBGC_LONG, visits them all.
for (const [width, names] of [
  [320, process.env.SBGC_LONG ? all : samples()],
  [1280, samples()],
]) {
  const which = names === all ? "every page" : "a page of each kind";
  test(`${which} loads without an error, asks only for files, fits into ${width} pixels`, async () => {
    assert.ok(names.length > 1);
    const problems = [];
    const look = { viewport: { width, height: 600 } };
    await forEachItem(browser, names, look, async (page, name) => {
      const { problems: found } = await visit(page, name);
      const wide = await page.evaluate(overflowing, width);
      found.push(...wide.map((what) => `too wide for ${width} pixels: ${what}`));
      problems.push(...found.map((problem) => `${name}: ${problem}`));
    });
    assert.deepEqual(problems, []);
  });
}

test("a page that fails is noticed", inPage(async (page) => {
  const name = path.join(os.tmpdir(), `sbgc-broken-${process.pid}.html`);
  const body = '<img src="missing.png"><script>nonsense()</script><p style="width: 400px">wide';
  fs.writeFileSync(name, `<!DOCTYPE html><title>x</title>${body}`);
  const { problems } = await visit(page, path.relative(site, name));
  fs.unlinkSync(name);
  assert.match(problems.join("\n"), /failed: .*missing\.png/);
  assert.match(problems.join("\n"), /exception: .*nonsense/);
  assert.match((await page.evaluate(overflowing, 320)).join("\n"), /width: 400px/);
}, { viewport: { width: 320, height: 600 } }));

// These take long, and are tables and lists like those of the units, the enums and the availability.
const alike = ["headers.html", "messages.html", "variables.html"];
// Only colors differ between the two looks of a page, and the largest pages have no colors of their own.
const small = (names) => names.filter((name) => fs.statSync(path.join(site, name)).size < 90_000);
for (const [colorScheme, width, names, rules] of [
  ["light", 1280, samples().filter((name) => !alike.includes(name)), undefined],
  ["dark", 390, small(samples()), ["color-contrast"]],
]) {
  test(`axe-core has nothing to say about ${colorScheme} pages of ${width} pixels`, async () => {
    const problems = [];
    // The policy of the playground forbids scripts from elsewhere, such as this one.
    const look = { colorScheme, viewport: { width, height: 900 }, bypassCSP: true };
    await forEachItem(browser, names, look, async (page, name) => {
      await visit(page, name);
      problems.push(...(await axeProblems(page, "html", rules)).map((problem) => `${name}: ${problem}`));
    });
    assert.deepEqual(problems, []);
  });
}

test("the start page weighs less than 300 kB", inPage(async (page) => {
  const { requests } = await visit(page, "index.html");
  const files = new Set(requests.filter((url) => url.startsWith("file:")));
  const sizes = [...files].map((url) => fs.statSync(fileURLToPath(url)).size);
  const weight = sizes.reduce((sum, size) => sum + size, 0);
  assert.ok(files.size > 3);
  assert.ok(weight < 300_000, `${weight} bytes: ${[...files].join(" ")}`);
}));

test("search finds a message, a command and a field, and leads there", inPage(async (page) => {
  const { messages } = model();
  const message = messages.find((m) => m.layout.some((leaf) => leaf.path.startsWith("axes.")));
  const leaf = message.layout.find((l) => l.path.startsWith("axes.") && !l.reserved);
  const field = `#field-${encodeURIComponent(leaf.path)}`;
  for (const [query, target] of [
    [message.name, ".html"],
    [message.command, ".html"],
    [`${message.name} ${leaf.path}`, field],
  ]) {
    await visit(page, "index.html");
    await page.keyboard.press("/");
    await page.locator("#search").fill(query);
    await page.locator(`#search-results a[href*="${target}"]`).first().click();
    await page.waitForURL(/\/(messages|families)\/[^/]*$/);
    assert.ok((await page.locator("main").textContent()).includes(message.command), page.url());
    if (target === field) await page.locator(":target").waitFor();
  }
  const notes = { accelerometr: "Showing “accelerometer” for “accelerometr”.", qqqqzzzz: "Nothing found." };
  for (const [query, note] of Object.entries(notes)) {
    await page.locator("#search").fill(query);
    await page.locator("#search-results .nothing", { hasText: note }).waitFor();
  }
}));

test("what moves has a badge that leads to what it does, and a link to the page about safety", inPage(async (page) => {
  const moving = model().messages.filter((m) => m.effect?.does.includes("moves"));
  assert.ok(moving.length > 5);
  for (const { name } of moving.slice(0, 3)) {
    await visit(page, `messages/${slug(name)}.html`);
    await page.locator("h1 + p a.effect", { hasText: "moves" }).click();
    await page.locator("#effect:target a[href*='guides/safety.html']").click();
    assert.equal(await page.locator("h1").textContent(), "Safety");
  }
}));

test("the languages of an example are tabs; the choice holds for other pages", inPage(async (page) => {
  const [first, second] = all.filter((file) => file.startsWith("messages/"));
  const shown = async () => {
    const tabs = page.getByRole("tab", { selected: true });
    const panels = page.locator(".tab:visible");
    assert.equal(await panels.count(), 1);
    assert.equal(await panels.getAttribute("data-tab"), await tabs.textContent());
    return tabs.textContent();
  };
  await visit(page, first);
  const names = ["Command line", "C++ client", "C++ codec", "Python", "Bytes"];
  assert.deepEqual(await page.getByRole("tab").allTextContents(), names);
  assert.equal(await shown(), "Command line");
  await page.getByRole("tab", { name: "Command line" }).press("ArrowRight");
  assert.equal(await shown(), "C++ client");
  await page.getByRole("tab", { name: "C++ codec" }).click();
  await visit(page, second);
  assert.equal(await shown(), "C++ codec");
  await page.goto(`${addressOf(second)}#example-bytes`);
  await page.getByRole("tab", { name: "Bytes", selected: true }).waitFor();
  assert.equal(await shown(), "Bytes");
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.locator(".tab:visible").count(), names.length);
}));

for (const javaScriptEnabled of [true, false]) {
  const how = javaScriptEnabled ? "" : ", without JavaScript";
  test(`the outline of a long page stays in view and leads to its sections${how}`, inPage(async (page) => {
    for (const [name, isBeside] of [["messages/control.html", false], ["guides/streams.html", true]]) {
      await page.setViewportSize({ width: 1280, height: 700 });
      await page.goto(addressOf(name));
      const outline = page.locator(".outline");
      const links = await outline.locator("a").all();
      assert.ok(links.length > 2, name);
      await links.at(-1).click();
      const { top, bottom } = await outline.evaluate((e) => {
        const { top, bottom } = e.getBoundingClientRect();
        return { top, bottom };
      });
      const bar = await page.locator(".bar").evaluate((e) => e.getBoundingClientRect().bottom);
      assert.ok(top >= bar - 1 && bottom <= 700, `${name}: ${top} to ${bottom}`);
      const target = await page.locator(":target").evaluate((e) => e.getBoundingClientRect().top);
      assert.ok(target >= (isBeside ? bar : bottom) - 1 && target < 700, `${name}: ${target}`);
      await page.setViewportSize({ width: 1000, height: 700 });
      assert.equal(await outline.isVisible(), !isBeside);
      await page.emulateMedia({ media: "print" });
      assert.ok(await outline.isHidden());
      await page.emulateMedia({ media: "screen" });
    }
  }, { javaScriptEnabled }));
}

test("names in the menu are whole", inPage(async (page) => {
  await visit(page, all.find((name) => name.startsWith("messages/i2c-read-reg-buf-request")));
  const cut = await page.locator("#menu a").evaluateAll((links) =>
    links
      .filter((a) => a.scrollWidth > a.clientWidth || getComputedStyle(a).textOverflow === "ellipsis")
      .map((a) => a.textContent),
  );
  assert.deepEqual(cut, []);
}, { viewport: { width: 1280, height: 800 } }));

test("the example of a message opens in the decoder", inPage(async (page) => {
  for (const name of all.filter((file) => file.startsWith("messages/")).slice(0, 5)) {
    await visit(page, name);
    const title = await page.locator("h1 small").textContent();
    await page.locator("a[href*='decoder.html#hex=']").first().click();
    await page.waitForFunction(() => document.querySelector("#summary")?.textContent);
    const names = await page.locator(".opener .what .muted").allTextContents();
    assert.equal(names.at(-1), title);
  }
}));

for (const width of [1280, 390]) {
  test(`without JavaScript there is the content and a menu, ${width} pixels wide`, inPage(async (page) => {
    await page.goto(addressOf("index.html"));
    await page.locator("h1").waitFor();
    if (width < 960) await page.locator(".menu-button").click();
    await page.locator("#menu a[href$='decoder.html']").click();
    await page.waitForURL(addressOf("decoder.html"));
    const hint = page.locator("noscript");
    await hint.waitFor();
    assert.match(await hint.textContent(), /sbgc decode --hex/);
    assert.ok(await page.locator("#search").isHidden());
  }, { javaScriptEnabled: false, viewport: { width, height: 800 } }));
}

test("on paper there is the content without bars and menus", async () => {
  const problems = [];
  await forEachItem(browser, samples(), { colorScheme: "dark" }, async (page, name) => {
    await page.emulateMedia({ media: "print" });
    await visit(page, name);
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
  });
  assert.deepEqual(problems, []);
});
