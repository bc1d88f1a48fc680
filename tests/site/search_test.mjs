// What the search of the site finds, without a browser.

import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";

import { searchOfSite } from "./support.mjs";

const find = await searchOfSite();
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

test("both spellings of a word find the same", () => {
  assert.deepEqual(pagesOf("stabilise").slice(0, 3).sort(), pagesOf("stabilize").slice(0, 3).sort());
});
