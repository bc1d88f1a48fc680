// Tests the results of the site's search, without a browser.

import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";

import { model, searchOfSite } from "./support.mjs";

const search = await searchOfSite();
const find = (query) => structuredClone(search(query)); // lists of this program, to compare them
const pagesOf = (query) => find(query).found.map((entry) => entry.page.replace(".html", ""));

/** Returns the queries of a file with their pages. */
const queriesOf = (name) =>
  fs.readFileSync(new URL(name, import.meta.url), "utf8").split("\n")
    .filter((line) => line && !line.startsWith("#"))
    .map((line) => line.split(/ {2,}/));

/** Returns the queries for which `fits(result, page)` holds for none of the first three results. */
const missed = (queries, fits) =>
  queries.filter(([query, pages]) =>
    !pagesOf(query).slice(0, 3).some((found) => pages.split(" ").some((page) => fits(found, page))),
  ).map(([query]) => `${query}: ${pagesOf(query).slice(0, 3).join(" ")}`);

test("search finds the page or section that a query means", () => {
  const queries = queriesOf("queries.txt");
  assert.ok(queries.length >= 100);
  assert.deepEqual(missed(queries, (found, page) => found === page), []);
  for (const query of ["°", "dps", "°/s", "degrees per second"]) {
    assert.match(pagesOf(query)[0], /units/, query);
  }
});

test("search answers what people on forums ask: 90 % in the first three results", () => {
  const queries = queriesOf("forum_queries.txt");
  assert.ok(queries.length >= 120);
  const wrong = missed(queries, (found, page) => found === page || (!page.includes("#") && found.startsWith(`${page}#`)));
  assert.ok(wrong.length <= 0.1 * queries.length, wrong.join("\n"));
});

const namesOf = (query) => find(query).found.map((entry) => entry.name);

test("search finds guides and their sections, units, fields and synonyms", () => {
  assert.equal(pagesOf("safety")[0], "guides/safety");
  assert.match(pagesOf("lost line")[0], /guides\/(streams|safety)#.*lost/);
  assert.match(pagesOf("pinch")[0], /guides\/safety/, "a word in the text of a guide");
  const { quantities } = model();
  const volts = namesOf("volt").slice(0, 3);
  assert.ok(quantities.some((q) => q.unit === "V" && volts.includes(q.name)), volts.join());
  assert.ok(pagesOf("volt").slice(0, 30).some((page) => page.includes("#field-")), "fields in volts, too");
  assert.ok(pagesOf("deg/s").slice(0, 30).some((page) => page.includes("units/")));
  assert.ok(namesOf("tuning").slice(0, 30).includes("ReadParams3.axes.*.p"));
  assert.ok(namesOf("velocity").slice(0, 30).some((name) => /speed/i.test(name)));
  assert.deepEqual([find("velocity").taken, find("qqqqzzzz").found], [[], []]);
});

test("search takes a misspelled word for the nearest one", () => {
  for (const [query, meant, name] of [
    ["accelerometr", "accelerometer", /./],
    ["contorl", "control", /^Control$/],
    ["gyroscpoe", "gyroscope", /./],
  ]) {
    assert.deepEqual(find(query).taken, [[query, meant]]);
    assert.match(namesOf(query)[0], name);
  }
});

test("a message that reads and its twin that writes are one entry", () => {
  const write = model().messages.find((m) => m.stores && m.command.includes("WRITE"));
  for (const [query, other] of [[write.stores, write.name], [write.name, write.stores]]) {
    const [first, ...rest] = find(query).found;
    assert.equal(first.name, query);
    assert.ok(first.others.includes(other), first.others.join());
    assert.ok(!rest.some(({ name }) => name === other));
  }
  assert.equal(namesOf(`${write.name} gyro_trust`)[0], `${write.stores}.gyro_trust`);
});

test("search finds what comes from a line of the specification", () => {
  for (const { name, source } of model().messages.filter((m) => /L\d+-L\d+/.test(m.source)).slice(0, 12)) {
    const [, first, last] = /L(\d+)-L(\d+)/.exec(source).map(Number);
    const { found } = find(`L${(first + last) >> 1}`);
    assert.ok(found.slice(0, 30).some((one) => [one.name, ...one.others].includes(name)), name);
  }
  assert.deepEqual(namesOf("L99999"), []);
});

test("both spellings of a word find the same", () => {
  assert.deepEqual(pagesOf("stabilise").slice(0, 3).sort(), pagesOf("stabilize").slice(0, 3).sort());
});
