// Pages in a browser: opens them, and looks at them as people and axe-core do.

import assert from "node:assert/strict";
import { createRequire } from "node:module";

/** Makes a function that makes tests: of `work(page)` with a page in a context of its own. */
export const testsOf = (browser) => (work, look = {}) => async () => {
  const context = await browser.newContext({ reducedMotion: "reduce", ...look });
  try {
    await work(await context.newPage());
  } finally {
    await context.close();
  }
};

/** Draws ten times a second, enough for tests that are not about pictures: drawing takes much processor time. */
export const drawSeldom = () => {
  globalThis.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 100);
  globalThis.cancelAnimationFrame = clearTimeout;
};

/** Opens an address in a context of its own, runs `work(page)`, and fails if the browser has complained. */
export async function visit(browser, address, work, { prepare = [], ...look } = {}) {
  const context = await browser.newContext({ reducedMotion: "reduce", ...look });
  const page = await context.newPage();
  const problems = [];
  // Software WebGL reports that reading pixels is slow.
  const isOurs = (message) => ["error", "warning"].includes(message.type()) && !message.text().includes("GL Driver");
  page.on("console", (message) => isOurs(message) && problems.push(message.text()));
  page.on("pageerror", (error) => problems.push(String(error)));
  for (const script of [drawSeldom, ...prepare]) await page.addInitScript(script);
  try {
    await page.goto(address);
    await work(page);
    assert.deepEqual(problems, []);
  } finally {
    await context.close();
  }
}

/** Records what the page tells its worker. */
export const spy = () => {
  globalThis.told = [];
  const post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (message) {
    globalThis.told.push(message);
    return post.call(this, message);
  };
};
export const told = (page, ...kinds) =>
  page.evaluate((some) => globalThis.told.filter(({ kind, name }) => some.includes(name ?? kind)), kinds);

export const toldAtLeast = (page, kind, count) =>
  page.waitForFunction(([wanted, most]) => globalThis.told.filter((one) => one.kind === wanted).length >= most, [kind, count]);

export const button = (page, name) => page.getByRole("button", { name, exact: true });
export const outcome = (page, text) => page.locator(".outcome", { hasText: text }).waitFor();

/** Goes to what has this name, as a keyboard does; fails if one does not see that it has the focus. */
export async function tabTo(page, name) {
  for (let n = 0; n < 200; ++n) {
    await page.keyboard.press("Tab");
    const [found, outline] = await page.evaluate(() => {
      const one = document.activeElement;
      const label = one.closest("label");
      const seen = one.type === "radio" ? label.querySelector("span") : one;
      return [(one.ariaLabel ?? label?.textContent ?? one.textContent).trim(), getComputedStyle(seen).outlineStyle];
    });
    if (found === name) return assert.notEqual(outline, "none", `${name}: the focus is visible`);
  }
  assert.fail(`${name} cannot be reached`);
}

/** What axe-core finds in a part of the page. A page with a policy must bypass it. */
export async function axeProblems(page, part = "html", rules = undefined) {
  const isThere = await page.evaluate(() => "axe" in globalThis);
  if (!isThere) await page.addScriptTag({ path: createRequire(import.meta.url).resolve("axe-core/axe.min.js") });
  // Preloading would load the style sheets again, which is not allowed for file URLs.
  const run = ([where, runOnly]) => globalThis.axe.run(where, { preload: false, ...(runOnly && { runOnly }) });
  const { violations } = await page.evaluate(run, [part, rules]);
  return violations.map(({ id, help, nodes }) => `${id}: ${help}: ${nodes.map(({ html }) => html).slice(0, 3)}`);
}

/** In which a page is checked. */
export const looks = ["light", "dark"].flatMap((colorScheme) =>
  [390, 768, 1280].map((width) => ({ colorScheme, viewport: { width, height: 900 } })),
);

/** Fails if, in one of the looks, axe-core finds something, or the page is wider than its window. */
export async function checkLook(page, what = "", some = looks) {
  for (const { colorScheme, viewport } of some) {
    await page.setViewportSize(viewport);
    await page.emulateMedia({ colorScheme });
    // Only colors differ between the two.
    const rules = colorScheme === "dark" ? ["color-contrast"] : undefined;
    const look = `${what}, ${colorScheme}, ${viewport.width} pixels`;
    assert.deepEqual(await axeProblems(page, "html", rules), [], look);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), viewport.width, look);
  }
}
