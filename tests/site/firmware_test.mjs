// Tests of the choice of a firmware, and of the pages about each firmware, in Chromium.

import assert from "node:assert/strict";
import { after, test } from "node:test";

import { axeProblems, testsOf } from "./browsing.mjs";
import { addressOf, launch, model, pages, slug } from "./support.mjs";

const { messages, enums, adjustable_variables: variables, commands } = model();
const browser = await launch();
after(() => browser.close());

/** The number of a version as on the wire: 2.68b7 is 2687. */
const numberOf = (version) => {
  const [, major, minor, beta] = version.match(/^(\d+)\.(\d+)(?:[b.](\d+))?$/);
  return Number(major) * 1000 + Number(minor) * 10 + Number(beta ?? 0);
};
const since = (thing) => (thing.since?.firmware ? numberOf(thing.since.firmware) : 0);

/** A version with things before and after it, from the middle of all versions. */
const versions = [...new Set(variables.map(since))].filter(Boolean).sort((a, b) => a - b);
const chosen = String(versions[versions.length >> 1]);

/** Opens a page for a reader who has chosen a firmware. */
async function open(page, name, firmware = chosen) {
  await page.goto(addressOf(name));
  await page.evaluate((number) => localStorage.setItem("firmware", number), firmware);
  await page.reload();
}

const inPage = testsOf(browser);

/** Expects that exactly the things of the chosen firmware are visible. */
async function expectVisible(page, things, idOf, needs = since) {
  assert.ok(things.some((t) => needs(t) > Number(chosen)) && things.some((t) => needs(t) <= Number(chosen)));
  const shown = await page.evaluate(
    (ids) => ids.map((id) => document.getElementById(id)?.getClientRects().length > 0),
    things.map(idOf),
  );
  things.forEach((thing, i) => {
    assert.equal(shown[i], needs(thing) <= Number(chosen), `${idOf(thing)} on ${page.url()}`);
  });
}

test("a choice hides what the firmware lacks, at once, and lasts", inPage(async (page) => {
  await page.goto(addressOf("variables.html"));
  const later = variables.find((v) => since(v) > Number(chosen));
  assert.ok(await page.locator(`[id="${later.name}"]`).isVisible());
  assert.ok(await page.locator("#firmware-now").isHidden());
  await page.getByLabel("Firmware of your board").selectOption(chosen);
  await expectVisible(page, variables, (v) => v.name);
  const count = variables.filter((v) => since(v) > Number(chosen)).length;
  assert.match(await page.locator("#firmware-now").textContent(), new RegExp(`${count} entries .* hidden`));
  await page.goto(addressOf("index.html"));
  assert.equal(await page.locator("#firmware").inputValue(), chosen);
  await page.goto(addressOf("variables.html"));
  await expectVisible(page, variables, (v) => v.name);
  await page.getByRole("button", { name: "Show all versions" }).click();
  assert.ok(await page.locator(`[id="${later.name}"]`).isVisible());
  await page.reload();
  assert.equal(await page.locator("#firmware").inputValue(), "");
}));

test("every release from 2.43 on can be chosen, on the page where the reader is, with one banner", inPage(async (page) => {
  const { name } = messages.find((m) => since(m) > 2550 && m.layout.length > 2);
  const address = `${addressOf(`messages/${slug(name)}.html`)}#fields`;
  await page.goto(address);
  const offered = await page.locator("#firmware option").allTextContents();
  for (let minor = 43; minor <= 74; ++minor) assert.ok(offered.includes(`2.${minor}`), `2.${minor}`);
  for (const release of ["2.43", "2.74", "2.50"]) {
    await page.getByLabel("Firmware of your board").selectOption(release);
    assert.equal(page.url(), address);
    assert.equal(await page.locator("h1 small").textContent(), name);
    assert.equal(await page.locator("#firmware-now").count(), 1);
    const banner = await page.locator("#firmware-now").textContent();
    assert.ok(banner.startsWith(`Firmware ${release}: `), banner);
    assert.equal(banner.includes("does not have this message"), release !== "2.74", banner);
  }
}));

test("it works on the pages of commands, enums, units and messages", inPage(async (page) => {
  const family = commands.find((c) => since(c) > Number(chosen)).family;
  await open(page, `families/${family}.html`);
  const own = commands.filter((c) => c.family === family);
  await expectVisible(page, own, (c) => c.name);

  const isMixed = (things) =>
    things.some((t) => since(t) > Number(chosen)) && things.some((t) => since(t) <= Number(chosen));
  const named = enums.filter((e) => isMixed(e.values));
  assert.ok(named.length > 3);
  for (const { name, values } of named.slice(0, 4)) {
    await page.goto(addressOf(`enums/${slug(name)}.html`));
    await expectVisible(page, values, (v) => v.name);
  }

  // A field of a body whose bytes were reserved, or that ended before.
  const grown = messages.filter((m) => since(m) <= Number(chosen) && isMixed(m.layout) && !m.same_as);
  assert.ok(grown.length > 2);
  for (const { name, layout } of grown.slice(0, 4)) {
    await page.goto(addressOf(`messages/${slug(name)}.html`));
    await expectVisible(page, layout, (leaf) => `field-${leaf.path}`);
  }
  await page.goto(addressOf("messages.html"));
  for (const title of ["Messages by id", "Messages by name"]) {
    const rows = await page.getByRole("region", { name: title }).locator("tbody tr:visible").count();
    const all = await page.getByRole("region", { name: title }).locator("tbody tr").count();
    assert.ok(rows > 0 && rows < all, `${title}: ${rows} of ${all}`);
  }
  for (const name of ["units.html", "enums.html"]) {
    await page.goto(addressOf(name));
    assert.ok((await page.locator("main tbody tr:visible").count()) > 10, name);
  }
}));

test("a message that the firmware lacks, or no longer has, says so", inPage(async (page) => {
  const later = messages.find((m) => since(m) > Number(chosen));
  const older = messages.find((m) => since(m) && since(m) <= Number(chosen));
  await open(page, `messages/${slug(later.name)}.html`);
  assert.ok(await page.getByText("does not have this message: it came with").isVisible());
  assert.ok(await page.locator("h1").isVisible());
  await page.goto(addressOf(`messages/${slug(older.name)}.html`));
  assert.ok(await page.getByText("does not have this message").isHidden());

  const ended = messages.find((m) => m.until?.firmware);
  await open(page, `messages/${slug(ended.name)}.html`, String(numberOf(ended.until.firmware)));
  assert.ok(await page.getByText("does not have this message: it ended with").isVisible());
  await open(page, `messages/${slug(ended.name)}.html`, String(versions[0]));
  assert.equal(
    await page.getByText("does not have this message: it ended with").isVisible(),
    numberOf(ended.until.firmware) <= versions[0],
  );
}));

test("the rest is dimmed if the reader wants it, and stays legible", inPage(async (page) => {
  const later = variables.find((v) => since(v) > Number(chosen));
  await open(page, "variables.html");
  const row = page.locator(`[id="${later.name}"]`);
  assert.ok(await row.isHidden());
  await page.getByLabel("Dim the rest").check();
  assert.ok(await row.isVisible());
  assert.equal(await row.evaluate((e) => getComputedStyle(e).fontStyle), "italic");
  assert.deepEqual(await axeProblems(page), []);
  await page.reload();
  assert.ok(await row.isVisible(), "also on the next page");
}, { colorScheme: "dark" }));

test("a link to something hidden shows it", inPage(async (page) => {
  const later = variables.find((v) => since(v) > Number(chosen));
  await open(page, "index.html");
  await page.goto(`${addressOf("variables.html")}#${later.name}`);
  assert.ok(await page.locator(`[id="${later.name}"]`).isVisible());
}));

test("the choice needs only the keyboard", inPage(async (page) => {
  await page.goto(addressOf("variables.html"));
  await page.locator("#firmware").focus();
  await page.keyboard.type("2.");
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.id), "firmware-dim");
  await page.keyboard.press("Space");
  assert.ok(await page.locator("#firmware-dim").isChecked());
  assert.notEqual(await page.locator("#firmware").inputValue(), "");
  assert.ok(await page.locator("#firmware-now").isVisible());
}));

test("on a phone the choice is in the menu", inPage(async (page) => {
  await page.goto(addressOf("variables.html"));
  assert.ok(await page.locator("#firmware").isHidden());
  await page.locator(".menu-button").click();
  await page.getByLabel("Firmware of your board").selectOption(chosen);
  await page.locator("#menu .close").click();
  assert.ok(await page.locator("#firmware-now").isVisible());
  await expectVisible(page, variables, (v) => v.name);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(wide <= 0);
}, { viewport: { width: 390, height: 800 } }));

test("without JavaScript there is no choice, and nothing is hidden", inPage(async (page) => {
  await page.goto(addressOf("variables.html"));
  assert.ok(await page.locator("#firmware").isHidden());
  assert.ok(await page.locator(`[id="${variables.at(-1).name}"]`).isVisible());
  await page.locator("#menu a[href$='availability.html']").click();
  const link = page.locator("main a[href^='firmware/']").first();
  const version = (await link.textContent()).replace("Firmware ", "");
  await link.click();
  assert.ok(await page.locator(`h2[id="${version}"]`).isVisible());
}, { javaScriptEnabled: false }));

test("a broken or unknown choice hides nothing", inPage(async (page) => {
  for (const bad of ["], body", "{}", "9", "2.68"]) {
    await open(page, "variables.html", bad);
    assert.equal(await page.locator("#firmware").inputValue(), "");
    assert.ok(await page.locator(`[id="${variables[0].name}"]`).isVisible());
    assert.ok(await page.locator(`[id="${variables.at(-1).name}"]`).isVisible());
  }
}));

test("pages of firmware lead from one to the next", inPage(async (page) => {
  const all = pages().filter((name) => name.startsWith("firmware/"));
  await page.goto(addressOf(all[0]));
  const visited = [await page.locator("h1").textContent()];
  while (await page.locator("a[rel=next]").count()) {
    await page.locator("a[rel=next]").click();
    visited.push(await page.locator("h1").textContent());
  }
  assert.equal(visited.length, all.length);
  await page.locator("a[rel=prev]").click();
  assert.equal(await page.locator("h1").textContent(), visited.at(-2));
}));
