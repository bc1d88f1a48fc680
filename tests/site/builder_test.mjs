// Tests of the frame builder of message pages: its frames are those of the examples, and the lines that
// it prints make the same ones.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, test } from "node:test";
import vm from "node:vm";

import { axeProblems, testsOf, visit } from "./browsing.mjs";
import { addressOf, launch, messagesModule, model, pages, root, runPython, sbgc, site, startModule } from "./support.mjs";

const { call } = await startModule(messagesModule());
const browser = await launch();
after(() => browser.close());
const inPage = testsOf(browser);

/** The messages with a builder: their pages, and the frames of their examples. */
const examples = pages()
  .filter((name) => name.startsWith("messages/"))
  .map((page) => {
    const text = fs.readFileSync(path.join(site, page), "utf8");
    const name = /<section id="builder"[^>]* data-message="(\w+)"/.exec(text)?.[1];
    const facts = /data-facts="([^"]*)"/.exec(text)?.[1].replaceAll("&#34;", '"').replaceAll("&amp;", "&");
    return { page, name, facts, frame: /data-frame="([0-9a-f]+)"/.exec(text)[1] };
  })
  .filter(({ name }) => name !== undefined);

const exampleOf = (name) => examples.find((one) => one.name === name);
const pageOf = (name) => exampleOf(name).page;

/** What the module makes of the values of a form. */
const build = (name, frame, lines) => JSON.parse(call("build", Buffer.from([name, frame, ...lines].join("\n"))));

const settings = (lines) => lines.map(([field, text]) => `${field}=${text}`);
const leavesOf = (fields) => fields.flatMap((field) => (field.fields ? leavesOf(field.fields) : [field]));

test("every request has a builder, whose frame is that of the example, from its values as well", () => {
  const requests = model().messages.filter((m) => m.direction !== "from_board");
  assert.deepEqual(new Set(examples.map((e) => e.name)), new Set(requests.map((m) => m.name)));
  for (const { name, frame } of examples) {
    const read = build(name, frame, []);
    assert.deepEqual(read.problems, [], name);
    assert.equal(read.frame, frame, name);
    const again = build(name, "", settings(read.lines));
    assert.deepEqual(again.problems, [], name);
    assert.equal(again.frame, frame, name);
    assert.deepEqual(again.fields, read.fields, name);
    // The page sends all values of the form, not only those that differ from a new message.
    const shown = leavesOf(read.fields).filter((field) => !(field.optional && field.value === ""));
    const whole = build(name, "", shown.map((field) => `${field.path}=${field.value}`));
    assert.equal(whole.frame, frame, name);
  }
});

test("the command makes the same frames of the same values", () => {
  let compared = 0;
  for (const { name, frame } of examples) {
    const { lines } = build(name, frame, []);
    if (lines.some(([, , isSecret]) => isSecret)) continue; // the command wants a file
    const said = spawnSync(sbgc, ["send", name, ...settings(lines), "--dry-run"]);
    assert.equal(said.stdout.toString().split("\n")[0], frame, `${name}: ${said.stderr}`);
    ++compared;
  }
  assert.ok(compared > 0.9 * examples.length);
});

test("the sentences about wrong values are those of the command", () => {
  const cases = [
    ["Control", "axes.pitch.angle", "800deg"],
    ["Control", "axes.pitch.angle", "much"],
    ["Control", "control_mode", "mode:77"],
    ["RealtimeDataCustomRequest", "flags", "NO_SUCH_FLAG"],
    ["DataStreamInterval", "interval_ms", "70000"],
    ["DataStreamInterval", "interval_ms", ""],
  ];
  for (const [name, field, text] of cases) {
    const { frame, problems } = build(name, "", [`${field}=${text}`]);
    assert.equal(frame, "", `${name} ${field}=${text}`);
    assert.equal(problems[0][0], field);
    const said = spawnSync(sbgc, ["send", name, `${field}=${text}`, "--dry-run"]).stderr.toString();
    assert.ok(said.includes(problems[0][1]), `${said} / ${problems[0][1]}`);
  }
  assert.match(build("Control", "", ["nonsense=1"]).problems[0][1], /has no field 'nonsense'/);
  assert.match(build("Nonsense", "", []).problems[0][1], /no such message/);
});

test("a value without a name is a warning", () => {
  const stream = build("DataStreamInterval", "", ["cmd_id=24"]);
  assert.match(stream.warnings[0][1], /24 has no name; the nearest are CMD_REALTIME_DATA_3/);
  assert.notEqual(stream.frame, "");
  assert.deepEqual(build("DataStreamInterval", "", ["cmd_id=25"]).warnings, []);
});

test("values come before those whose unit they select", () => {
  const lines = ["axes.yaw.speed=1", "control_mode=MODE_SPEED,CONTROL_FLAG_HIGH_RES_SPEED"];
  const { frame, lines: made, fields } = build("Control", "", lines);
  const said = spawnSync(sbgc, ["send", "Control", ...lines, "--dry-run"]).stdout.toString();
  assert.equal(frame, said.split("\n")[0]);
  assert.equal(made[0][0], "control_mode");
  assert.equal(leavesOf(fields).find((f) => f.path === "axes.yaw.speed").unit, "deg/s");
});

/** The messages with the code of both languages for their examples, and for those with other values. */
function codes() {
  const context = vm.createContext({});
  vm.runInContext(fs.readFileSync(path.join(site, "assets/builder-code.js"), "utf8"), context);
  const make = vm.runInContext("sbgcBuilderCode", context);
  const more = [
    ["Control", ["control_mode=MODE_SPEED,CONTROL_FLAG_HIGH_RES_SPEED", "axes.yaw.speed=1"]],
    ["Control", ["control_mode=MODE_ANGLE,CONTROL_FLAG_AUTO_TASK|CONTROL_FLAG_TARGET_PRECISE", "axes.pitch.angle=-30.5"]],
  ];
  const all = [...examples.map(({ name, frame }) => [name, frame, []]), ...more.map(([name, lines]) => [name, "", lines])];
  return all.map(([name, from, given]) => {
    const { frame, lines } = build(name, from, given);
    const { cpp, python } = make(name, JSON.parse(exampleOf(name).facts));
    return { name, frame, cpp: cpp(lines), python: python(lines) };
  });
}

test("the code in Python makes the same frames, most of them without text", () => {
  const wanted = codes();
  const program = wanted.map(({ python }) => `${python}\nprint(frame.hex())`).join("\n");
  assert.deepEqual(runPython(program).split("\n"), wanted.map(({ frame }) => frame));
  assert.ok(wanted.filter(({ python }) => !python.includes("assign(")).length > 0.7 * wanted.length);
  assert.ok(wanted.some(({ python }) => python.includes("msg.Control(\n    control_mode=msg.ControlMode(mode=msg.ControlModeKind.MODE_ANGLE")));
});

test("the typed code in C++ makes the same frames", () => {
  const typed = codes().filter(({ cpp }) => cpp.includes("sbgc::msg::"));
  assert.ok(typed.length > 0.6 * examples.length);
  const includes = new Set();
  const functions = typed.map(({ cpp }) => {
    const statements = cpp.split("\n").filter((line) => !line.startsWith("#include") || (includes.add(line), false));
    return `{\n${statements.join("\n")}\nshow(frame, written.size); }`;
  });
  const program = [...includes, "#include <cstdio>", "static void show(const auto& frame, std::size_t size) {",
    '  for (std::size_t i = 0; i < size; ++i) std::printf("%02x", frame[i]);', '  std::puts("");', "}",
    `int main() {\n${functions.join("\n")}\n}\n`].join("\n");
  const folders = ["generated/include", "runtime/core/include"].map((folder) => `-I${path.join(root, folder)}`);
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "builder-"));
  const made = spawnSync("g++", ["-std=c++20", "-Wno-deprecated-declarations", ...folders, "-x", "c++", "-", "-o", path.join(folder, "a")], { input: program });
  assert.equal(made.stderr.toString(), "");
  const ran = spawnSync(path.join(folder, "a"));
  fs.rmSync(folder, { recursive: true });
  assert.deepEqual(ran.stdout.toString().trim().split("\n"), typed.map(({ frame }) => frame));
});

/** Opens the builder of a page. */
const withBuilder = (file, work, hash = "") =>
  visit(browser, addressOf(file) + hash, async (page) => {
    if (!hash) await page.locator("#builder summary").click();
    await page.locator("#builder .built-frame, #builder .problem:visible").first().waitFor();
    await work(page);
  });

const built = async (page, word = "frame") => page.locator(`.built-${word}`).textContent();
const frameOf = async (page) => (await built(page)).replaceAll(" ", "").toLowerCase();

/** Runs the printed lines of a page. */
async function runLines(page) {
  const command = (await built(page, "command")).replace(/^sbgc/, `'${sbgc}'`);
  const said = spawnSync("bash", ["-c", `${command} --dry-run`]);
  return {
    command: said.stdout.toString().split("\n")[0] || said.stderr.toString(),
    python: runPython(`${await built(page, "python")}\nprint(frame.hex())`),
  };
}

test("a page shows the frame of its example, and lines that make it", async () => {
  const names = ["Control", "DataStreamInterval", "SetAdjVarsVal", "MotorsOn", "WriteProfileNames", "RunScript"];
  const wanted = names.map(exampleOf).filter(Boolean);
  assert.ok(wanted.length >= 4);
  for (const { page: file, frame } of wanted) {
    await withBuilder(file, async (page) => {
      assert.equal(await frameOf(page), frame, file);
      assert.deepEqual(await runLines(page), { command: frame, python: frame }, file);
    });
  }
});

test("another value makes another frame, and a link that holds it", async () => {
  const { page: file, frame } = exampleOf("Control");
  await withBuilder(file, async (page) => {
    await page.locator("[id='build-axes.pitch.angle']").fill("-30");
    await page.getByRole("checkbox", { name: "CONTROL_FLAG_HIGH_RES_SPEED" }).check();
    await page.waitForFunction(() => document.querySelector(".built-command")?.textContent.includes("HIGH_RES_SPEED"));
    const made = await frameOf(page);
    assert.notEqual(made, frame);
    assert.deepEqual(await runLines(page), { command: made, python: made });
    const link = await page.locator(".built-link").getAttribute("href");
    await withBuilder(file, async (other) => {
      assert.equal(await frameOf(other), made);
      assert.equal(await other.locator("[id='build-axes.pitch.angle']").inputValue(), "-30");
      assert.ok(await other.getByRole("checkbox", { name: "CONTROL_FLAG_HIGH_RES_SPEED" }).isChecked());
    }, link);
  });
});

test("a wrong value has its sentence beside it, and there is no frame", () => withBuilder(pageOf("Control"), async (page) => {
  const field = page.locator("[id='build-axes.pitch.angle']");
  await field.fill("800");
  const problem = page.locator("[id='build-axes.pitch.angle-problem']");
  await problem.waitFor();
  assert.match(await problem.textContent(), /does not fit: -720 deg to 719\.978 deg/);
  assert.equal(await field.getAttribute("aria-invalid"), "true");
  assert.equal(await page.locator(".built-frame").count(), 0);
  await field.fill("80");
  await page.locator(".built-frame").waitFor();
  assert.ok(await problem.isHidden());
  assert.equal(await field.getAttribute("aria-invalid"), null);
}));

test("lists grow and shrink", () => withBuilder(pageOf("SetAdjVarsVal"), async (page) => {
  const before = await frameOf(page);
  await page.getByRole("button", { name: "Add one" }).click();
  await page.waitForFunction((text) => document.querySelector(".built-frame").textContent.length > text, before.length * 1.5);
  const longer = await frameOf(page);
  assert.ok(longer.length > before.length);
  assert.deepEqual(await runLines(page), { command: longer, python: longer });
  await page.getByRole("button", { name: "Remove the last" }).click();
  await page.waitForFunction((text) => document.querySelector(".built-frame").textContent.length < text, longer.length * 1.5 - 1);
  assert.equal(await frameOf(page), before);
}));

test("axe-core has nothing to say about an open builder, nor about one with a problem", async () => {
  for (const name of ["Control", "SetAdjVarsVal"]) {
    await withBuilder(pageOf(name), async (page) => {
      await page.locator("#builder input[type=text]").first().fill("x");
      await page.locator("#builder .problem:visible").first().waitFor();
      assert.deepEqual(await axeProblems(page, "#builder"), []);
    });
  }
});

test("nothing of the builder is loaded before it is opened", inPage(async (page) => {
  const requests = [];
  page.on("request", (request) => requests.push(request.url()));
  await page.goto(addressOf(pageOf("Control")));
  await page.locator("#builder summary").waitFor();
  assert.ok(!requests.some((url) => url.includes("-module")), requests.join());
}));

test("without JavaScript there is no builder", inPage(async (page) => {
  await page.goto(addressOf(pageOf("Control")));
  assert.ok(await page.locator("#builder").isHidden());
}, { javaScriptEnabled: false }));
