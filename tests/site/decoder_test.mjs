// Tests of the decoder page in Chromium, opened from a file.

import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";

import { checkLook, visit } from "./browsing.mjs";
import { addressOf, frame, launch, root, vectors } from "./support.mjs";

const browser = await launch();
after(() => browser.close());

const withDecoder = (work, { hash = "", ...options } = {}) =>
  visit(browser, addressOf("decoder.html") + hash, work, options);

const summary = (page) => page.locator("#summary");

/** Waits until the summary of the input matches `expected`. */
async function expectSummary(page, expected) {
  const matches = (pattern) =>
    new RegExp(pattern).test(document.querySelector("#summary").textContent);
  await page.waitForFunction(matches, expected.source).catch(() => {});
  assert.match(await summary(page).textContent(), expected);
}

/** Replaces the contents of the text area, after clearing the previous summary. */
async function type(page, text) {
  await page.evaluate((value) => {
    document.querySelector("#summary").textContent = "";
    const area = document.querySelector("#hex");
    area.value = value;
    area.dispatchEvent(new Event("input"));
  }, text);
}

/** Returns the contents of the item with this index: rows as lists of cells, and notes. */
async function inside(page, index) {
  const opener = page.locator(`#item-${index}`);
  if ((await opener.getAttribute("aria-expanded")) === "false") await opener.click();
  const content = page.locator(`#inside-${index}`);
  await content.locator(":scope > *").first().waitFor();
  const cells = (rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent));
  return {
    rows: await content.locator("tbody tr").evaluateAll(cells),
    text: await content.textContent(),
    bytes: (await content.locator(".bytes").textContent()).replace(/\s/g, ""),
  };
}

test("the examples of the page", () => withDecoder(async (page) => {
  const expected = {
    "Who are you": /^28 bytes: 2 frames\.$/,
    Angles: /^59 bytes: 1 frame\.$/,
    Control: /^18 bytes: 1 frame\.$/,
    Broken: /1 frame; .* in no frame \(.*1 bad body, 1 frame cut off\)\.$/,
    "Wrong baud rate": /0 frames; 30 bytes in no frame/,
  };
  const labels = await page.locator("[data-example]").allTextContents();
  assert.deepEqual(labels, Object.keys(expected));
  for (const [label, text] of Object.entries(expected)) {
    await page.getByRole("button", { name: label, exact: true }).click();
    await expectSummary(page, text);
    assert.ok(await page.locator("#problem").isHidden());
  }
}));

test("values have units and names, and bytes their fields", () => withDecoder(async (page) => {
  await page.getByRole("button", { name: "Control", exact: true }).click();
  await expectSummary(page, /1 frame/);
  const { rows, bytes } = await inside(page, 0);
  const angle = rows.find(([, field]) => field === "axes.yaw.angle");
  assert.deepEqual(angle, ["15–16", "axes.yaw.angle", "2048", "45 deg"]);
  assert.match(rows[0].join(" "), /control_mode .*MODE_ANGLE/);
  assert.match(bytes, /^3e430d50/);
  const parts = page.locator("#inside-0 .bytes [data-part]");
  assert.equal(await parts.count(), rows.length);
  assert.equal((await parts.last().textContent()).trim(), "00 08");
  await parts.last().hover();
  assert.match(await page.locator("#inside-0 tr.lit").textContent(), /axes\.yaw\.angle/);
}));

/** The link targets on a page; undefined is the page itself. */
const idsOf = (() => {
  const known = new Map();
  return (url) => {
    if (!known.has(url)) {
      const text = fs.readFileSync(fileURLToPath(url), "utf8");
      known.set(url, new Set([undefined, ...[...text.matchAll(/ id="([^"]*)"/g)].map((m) => m[1])]));
    }
    return known.get(url);
  };
})();

test("a typical frame of every message decodes to its message, with links to the reference", async () => {
  const typical = vectors().filter((vector) => vector.why === "typical values" && !vector.after);
  assert.ok(typical.length > 50);
  const missing = new Set();
  let linked = 0;
  for (const direction of ["to_board", "from_board"]) {
    const chosen = typical.filter((vector) => vector.direction === direction);
    const bytes = Buffer.concat(chosen.map(({ id, hex }) => frame(id, Buffer.from(hex, "hex"))));
    const from = direction === "to_board" ? "host" : "board";
    await withDecoder(
      async (page) => {
        await expectSummary(page, new RegExp(`: ${chosen.length} frames`));
        const names = await page.locator(".opener .what .muted").allTextContents();
        assert.deepEqual(names, chosen.map((vector) => vector.message).slice(0, 100));
        assert.equal(await page.locator(".tag.bad").count(), 0);
        await page.evaluate(() => document.querySelectorAll(".opener").forEach((o) => o.click()));
        await page.waitForFunction(() => document.querySelector(".inside:empty") === null);
        const links = page.locator(".inside a");
        for (const link of await links.evaluateAll((all) => all.map((a) => a.href))) {
          linked += 1;
          const [file, id] = link.split("#");
          if (!idsOf(file).has(id && decodeURIComponent(id))) missing.add(link);
        }
      },
      { hash: `#hex=${bytes.toString("hex").toUpperCase()}&from=${from}` },
    );
  }
  assert.deepEqual([...missing], []);
  assert.ok(linked > 1000, `only ${linked} links to the reference`);
});

test("a broken frame is explained", () => withDecoder(async (page) => {
  const broken = frame(86, []);
  broken[4] = 1;
  await type(page, broken.toString("hex"));
  await expectSummary(page, /0 frames; 5 bytes in no frame \(1 bad body\)/);
  const { text } = await inside(page, 0);
  assert.match(text, /CMD_BOARD_INFO \(86\) .* 0 bytes, but the checksum of its body is 0x01, not 0x00/);
  assert.deepEqual(await page.locator("#inside-0 .bytes .wrong").allTextContents(), ["01"]);

  // The fields of a damaged frame are gray, the byte that contradicts them is marked.
  const damaged = frame(67, [5, ...Array(12).fill(0)]);
  damaged[17] ^= 0xff;
  await type(page, damaged.toString("hex"));
  await expectSummary(page, /0 frames; 18 bytes in no frame/);
  const fields = await inside(page, 0);
  assert.match(fields.text, /any of them may be wrong/);
  assert.match(fields.text, /control_mode/);
  const marked = await page.locator("#inside-0 .bytes .wrong").allTextContents();
  assert.deepEqual(marked, [damaged.subarray(17).toString("hex")]);
  const color = (selector) => page.locator(selector).first().evaluate((cell) => getComputedStyle(cell).color);
  assert.equal(await color("#inside-0 .damaged td"), await color("#inside-0 .damaged a"), "gray");

  await type(page, frame(65, [0, 0, 0, 0, 0]).toString("hex"));
  await expectSummary(page, /1 frame; 1 of them not decodable/);
  assert.match((await inside(page, 0)).text, /unknown_form/);
}));

test("what the specification does not allow is pointed out", () => withDecoder(async (page) => {
  await page.locator("#hex").fill(frame(43, [0xff, 0xff, 0xff]).toString("hex"));
  await expectSummary(page, /1 frame/);
  await page.getByLabel("problems only").check();
  await type(page, frame(82, [99]).toString("hex"));
  await expectSummary(page, /1 value outside the specification/);
  assert.match((await inside(page, 0)).text, /is above 4/);
  await type(page, frame(82, [1]).toString("hex"));
  await expectSummary(page, /1 frame\.$/);
  await page.locator("#nothing").waitFor();
}));

test("bad hex is reported with its place, which can be shown", () => withDecoder(async (page) => {
  await type(page, "# Größe\n3e 56 00 56 00\n3e 56 0o");
  await page.locator("#problem").waitFor();
  const text = await page.locator("#problem-text").textContent();
  assert.match(text, /Line 3, column 8: half a byte: a second digit is missing before 'o'\./);
  await expectSummary(page, /1 frame/);
  assert.equal(await page.locator("#hex").getAttribute("aria-invalid"), "true");
  await page.getByRole("button", { name: "Show the place" }).click();
  const selected = await page
    .locator("#hex")
    .evaluate((area) => area.value.slice(area.selectionStart, area.selectionEnd));
  assert.equal(selected, "o");
  await type(page, "3e 56 00 56 00");
  await page.locator("#problem").waitFor({ state: "hidden" });
}));

test("what people post is read, and the page says how", () => withDecoder(async (page) => {
  await type(page, "12:34:56.789 TX: b'>V\\x00V\\x00'");
  await expectSummary(page, /5 bytes: 1 frame\. Read as strings after times or names\./);
  await type(page, "00000000: 3e56 0056 00  >V.V.\n00000020: 3e56");
  await page.locator("#problem").waitFor();
  const text = await page.locator("#problem-text").textContent();
  assert.match(text, /^Read as a hex dump\. Line 2, column 1: the offset of this line should be 0x5\./);
  await expectSummary(page, /1 frame/);
}));

test("a capture can be opened as a file, raw or hex", () => withDecoder(async (page) => {
  const file = (name) => path.join(root, "examples/captures", name);
  await page.locator("#file").setInputFiles(file("noisy_stream.bin"));
  await expectSummary(page, /frames; .* in no frame/);
  assert.match(await page.locator("#held-about").textContent(), /read as raw bytes/);
  await page.locator("#hex").waitFor({ state: "hidden" });
  await page.locator("#file").setInputFiles(file("board_info.hex"));
  await page.locator("#held-about", { hasText: "read as text" }).waitFor();
  await expectSummary(page, /^28 bytes: 2 frames\.$/);
  await page.getByRole("button", { name: "Remove" }).click();
  await page.locator("#hex").waitFor();
  await page.locator("#result").waitFor({ state: "hidden" });
}));

test("a file can be dropped", () => withDecoder(async (page) => {
  const transfer = await page.evaluateHandle(() => {
    const result = new DataTransfer();
    const bytes = new Uint8Array([0x3e, 0x56, 0x00, 0x56, 0x00]);
    result.items.add(new File([bytes], "capture.bin"));
    return result;
  });
  await page.dispatchEvent("#hex", "drop", { dataTransfer: transfer });
  await expectSummary(page, /^5 bytes: 1 frame\.$/);
}));

/** Returns 1 MB of hex text with all kinds of frames. */
function megabyte() {
  const frames = vectors()
    .filter((vector) => vector.hex !== undefined && vector.id)
    .map(({ id, hex }) => frame(id, Buffer.from(hex, "hex")).toString("hex"));
  let text = "";
  for (let i = 0; text.length < 1 << 20; i = (i + 7) % frames.length) text += `${frames[i]}\n`;
  return text.slice(0, 1 << 20);
}

/**
 * Pastes a text and waits for its summary. Returns the duration of the longest task of the page
 * meanwhile, in ms of processor time, which excludes other programs on the machine. A few tasks have
 * no processor time in a trace; their duration is what they took at most.
 */
async function paste(page, text) {
  const categories = ["disabled-by-default-devtools.timeline", "blink.user_timing"];
  await browser.startTracing(page, { categories });
  await page.evaluate((pasted) => {
    const data = new DataTransfer();
    data.setData("text", pasted);
    const init = { clipboardData: data, bubbles: true, cancelable: true };
    const event = new ClipboardEvent("paste", init);
    const summary = document.getElementById("summary");
    return new Promise((resolve) => {
      // In separate tasks, so that preparing the event does not count and the page's own task can
      // end.
      setTimeout(() => {
        performance.mark("pasted");
        new MutationObserver(() => {
          if (summary.textContent === "") return;
          performance.mark("told");
          setTimeout(resolve);
        }).observe(summary, { childList: true });
        document.getElementById("hex").dispatchEvent(event);
      });
    });
  }, text);
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  const [pasted, told] = ["pasted", "told"].map((name) => traceEvents.find((e) => e.name === name));
  const { pid, tid } = pasted;
  const tasks = traceEvents
    .filter((e) => e.name === "RunTask" && e.pid === pid && e.tid === tid)
    .filter((e) => e.ts + e.dur >= pasted.ts && e.ts <= told.ts);
  assert.ok(tasks.length > 1);
  return Math.max(...tasks.map((task) => task.tdur ?? task.dur)) / 1000;
}

const longestTask = 100; // ms; a task usually takes a quarter of that

test("a paste of 1 MB leaves the page responsive", async () => {
  const text = megabyte();
  const attempts = [];
  // Long tasks of the page itself occur in every attempt; a stall of the machine does not.
  while (attempts.length < 5 && !attempts.some((longest) => longest < longestTask)) {
    await withDecoder(async (page) => {
      attempts.push(await paste(page, text));
      assert.match(await summary(page).textContent(), /^[0-9,]+ bytes: [0-9,]+ frames/);
      // The page still accepts input.
      await page.getByRole("button", { name: "Remove" }).click();
      await type(page, "3e 56 00 56 00");
      await expectSummary(page, /^5 bytes: 1 frame\.$/);
    });
  }
  console.log(`# 1 MB: longest task ${attempts.join(", ")} ms`);
  assert.ok(attempts.some((longest) => longest < longestTask), `${attempts} ms`);
});

test("a busy page would have been noticed", () => withDecoder(async (page) => {
  await page.evaluate(() => {
    const area = document.getElementById("hex");
    area.addEventListener("paste", () => {
      let work = 1;
      for (let i = 0; i < 500_000_000; ++i) work = (work * 1103515245 + 12345) | 0;
      area.dataset.work = work;
    });
  });
  const longest = await paste(page, "3e 56 00 56 00 ".repeat(5000));
  assert.ok(longest >= longestTask, `${longest} ms`);
}));

test("long lists are shown page by page", () => withDecoder(async (page) => {
  await page.locator("#hex").fill(frame(77, []).toString("hex").repeat(250));
  await expectSummary(page, /250 frames/);
  assert.equal(await page.locator("#frames > li").count(), 100);
  await page.getByRole("button", { name: "Later" }).click();
  await page.locator("#page-of").getByText("101 to 200 of 250", { exact: true }).waitFor();
  await page.getByRole("button", { name: "Later" }).click();
  await page.locator("#page-of").getByText("201 to 250 of 250", { exact: true }).waitFor();
  assert.equal(await page.locator("#frames > li").count(), 50);
  assert.ok(await page.getByRole("button", { name: "Later" }).isDisabled());
  assert.equal(await page.evaluate(() => document.activeElement.id), "item-200");
}));

test("without workers the page decodes all the same", async () => {
  const prepare = () => {
    globalThis.Worker = class {
      constructor() {
        throw new DOMException("not here", "SecurityError");
      }
    };
  };
  const work = (page) => expectSummary(page, /^5 bytes: 1 frame\.$/);
  await withDecoder(work, { hash: "#hex=3E56005600", prepare: [prepare] });
});

test("it can be used with the keyboard", () => withDecoder(async (page) => {
  await page.locator("#hex").focus();
  await page.keyboard.type(frame(77, []).toString("hex").repeat(5));
  await expectSummary(page, /5 frames/);
  await page.locator("#item-0").focus();
  await page.keyboard.press("Enter");
  await page.locator("#inside-0 .bytes").waitFor();
  await page.keyboard.press("Space");
  await page.locator("#inside-0").waitFor({ state: "hidden" });
}));

test("axe-core has nothing to say about results", async () => {
  const stream = Buffer.concat([Buffer.from([1, 2]), frame(82, [99]), frame(65, [0, 0, 0, 0, 0])]);
  const hash = `#hex=${stream.toString("hex")}&from=host`;
  const work = async (page) => {
    await expectSummary(page, /2 frames/);
    await page.locator("#hex").evaluate((area) => (area.value += " zz"));
    await page.locator("#hex").dispatchEvent("input");
    await page.locator("#problem").waitFor();
    for (const i of [0, 1, 2]) await inside(page, i);
    const look = (colorScheme, width) => ({ colorScheme, viewport: { width, height: 900 } });
    await checkLook(page, "", [look("light", 320), look("light", 1280), look("dark", 390)]);
  };
  await withDecoder(work, { hash });
});
