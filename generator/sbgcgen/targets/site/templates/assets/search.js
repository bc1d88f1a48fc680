// Search without a server: the index is a script, loaded when the box first gets the focus.
"use strict";

(() => {
  const form = document.querySelector(".search");
  const input = document.getElementById("search");
  const list = document.getElementById("search-results");
  const status = document.getElementById("search-status");
  const root = document.body.dataset.root;
  const limit = 30;
  // Stop words.
  const empty = new Set("a an are can do does for how i in is it my of on the to what why with".split(" "));
  // A synonym scores less than the word itself, and less the later it is listed.
  const [synonymWorth, laterWorth, singularWorth] = [0.5, 0.02, 0.95];
  // The order of kinds among equals.
  const kinds = ["message", "command", "page", "guide", "unit", "section", "family", "enum", "flags", "packed", "variable", "field", "value", "erratum"];

  let entries; // [{kind, name, about, page, parts, words, text, twins}], once loaded
  let synonyms; // groups of words
  let vocabulary; // all known words, set by the first misspelled word
  let loading;
  let active = -1;

  const load = () => {
    loading ??= new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = `${root}assets/search-index.js`;
      script.onload = resolve;
      script.onerror = reject;
      document.head.append(script);
    }).then(() => {
      synonyms = sbgcSearchIndex.synonyms;
      entries = sbgcSearchIndex.entries.map(([kind, name, about, page, more, twins = []], order) => ({
        ...findable(name, about, page, more),
        kind,
        order,
        // Names of code are only for who types them.
        behind: kind === "name" ? 40 : kinds.indexOf(kind) * 1.5,
        isProse: ["guide", "section", "name"].includes(kind),
        twins: twins.map(([n, a, p, m]) => findable(n, a, p, m)),
      }));
    });
    return loading;
  };

  const findable = (name, about, page, more) => ({
    name,
    about,
    page,
    names: plain(name),
    parts: plain(name.replace(/([a-z0-9])(?=[A-Z])/g, "$1 ")).split(/[_.\s]+/),
    words: plain(more).split(" ").filter((word) => !isLines.test(word) && !/^[~!]/.test(word)),
    asked: plain(more).split(" ").filter((word) => word.startsWith("!")),
    topics: plain(more).split(" ").filter((word) => word.startsWith("~")),
    inner: plain(more).split(" ").filter((word) => word.includes(".")).flatMap((path) => path.split(/[._]/)),
    lines: plain(more).split(" ").map((word) => isLines.exec(word)).filter(Boolean)
      .map(([, first, last]) => [Number(first), Number(last ?? first)]),
    text: plain(about),
    textWords: plain(about).split(/[^\p{L}\p{N}_/°.]+|\.(?= |$)/u),
  });

  // Lines of the specification, as in "L1148" or "L1148-L1160".
  const isLines = /^l(\d+)(?:-l(\d+))?$/;

  // How well the source lines of an entry match: a short range counts more than a long one.
  const fitLines = (entry, first, last) => {
    const sizes = entry.lines.filter(([from, to]) => from <= last && first <= to).map(([from, to]) => to - from);
    return sizes.length ? 95 - Math.min(10, Math.min(...sizes) / 10) : 0;
  };

  const plain = (text) => text.toLowerCase();
  // Makes "Axes.roll" and "axes_roll" equal.
  const squeeze = (text) => text.replace(/[\s_.·-]+/g, "");

  // How well one word matches; 0 means not at all.
  const fit = (entry, word, isProse) => {
    const lines = isLines.exec(word);
    if (lines) return fitLines(entry, Number(lines[1]), Number(lines[2] ?? lines[1]));
    const tight = squeeze(word);
    const isInText = !isProse && entry.textWords.includes(word);
    const inName = fitName(entry, word, tight, isProse);
    if (inName >= 50) return isInText ? inName + 6 : inName;
    if (isInText) return 52;
    if (!isProse && word.length > 2 && entry.textWords.some((w) => w.startsWith(word))) return 46;
    if (inName > 0) return inName;
    return word.length > 2 && !/^\d+$/.test(word) && entry.text.includes(word) ? 10 : 0;
  };

  // How well a word matches the name and the other words of an entry.
  const fitName = (entry, word, tight, isProse) => {
    if (word.includes(" ") && !isProse && ` ${entry.words.join(" ")} `.includes(` ${word} `)) return 90;
    // A value such as STOP says less than a page of this name.
    if (entry.names === word || squeeze(entry.names) === tight) return entry.kind === "value" ? 78 : 100;
    // What people call it.
    if (entry.asked.includes(`!${word}`)) return 92;
    // Most words of a guide are incidental.
    if (!isProse && entry.words.includes(word)) return entry.kind === "value" ? 75 : 90;
    const last = entry.names.slice(entry.names.lastIndexOf(".") + 1);
    if (last === word) return 85;
    if (isProse && entry.names.startsWith(word) && !entry.names.includes(" ")) return 85; // Stopping
    if (entry.inner.includes(word)) return 80; // an axis of a field
    if (word.length === 1) return entry.parts.includes(word) ? 55 : 0;
    if (entry.names.startsWith(word) || entry.names.startsWith(`cmd_${word}`)) return 70;
    if (last.startsWith(word) || (!isProse && entry.words.some((w) => w.startsWith(word)))) return 60;
    if (/^\d+$/.test(word)) return 0; // a number matches only as a whole
    if (entry.parts.at(-1) === word) return 70; // "ControlSpeed" is a speed
    if (entry.parts.includes(word)) return 55;
    if (entry.parts.some((part) => part.startsWith(word))) return 50;
    if (tight.length > 2 && squeeze(entry.names).includes(tight)) return 40;
    if (entry.topics.includes(`~${word}`)) return 48;
    if (isProse && entry.words.includes(word)) return 38;
    if (isProse && word.length > 2 && entry.words.some((w) => w.startsWith(word))) return 34;
    if (!isProse && tight.length > 2 && squeeze(entry.words.join(" ")).includes(tight)) return 30;
    return 0;
  };

  // Alternatives to a word, with their scores.
  const meanings = (word) => {
    const found = new Map([[word, 1]]);
    if (/^[a-z]{3,}s$/.test(word) && !word.endsWith("ss")) found.set(word.slice(0, -1), singularWorth);
    for (const group of synonyms) {
      const isMeant = group.includes(word) || (word.length > 3 && group.some((w) => w.startsWith(word)));
      for (const [index, other] of isMeant ? group.entries() : []) {
        if (!found.has(other)) found.set(other, synonymWorth - laterWorth * index);
      }
    }
    return found;
  };

  // The words of a query. Those of a synonym such as "factory reset" stay together.
  const wordsOf = (query) => {
    let text = ` ${plain(query).split(/\s+/).filter(Boolean).join(" ")} `;
    const words = [];
    for (const phrase of synonyms.flat().filter((w) => w.includes(" "))) {
      if (!text.includes(` ${phrase} `)) continue;
      words.push(phrase);
      text = text.replace(` ${phrase} `, " ");
    }
    words.push(...text.split(" ").filter(Boolean));
    const telling = words.filter((word) => !empty.has(word));
    return telling.length ? telling : words;
  };

  const best = (entry, words, isProse) => {
    let score = 0;
    for (const alternatives of words) {
      let most = 0;
      for (const [word, worth] of alternatives) most = Math.max(most, worth * fit(entry, word, isProse));
      if (most === 0) return 0;
      score += most;
    }
    return score / words.length;
  };

  // The edit distance with swaps, if it is at most `most`.
  const distance = (a, b, most) => {
    if (Math.abs(a.length - b.length) > most) return most + 1;
    let [before, row] = [[], Array.from({ length: b.length + 1 }, (_, j) => j)];
    for (let i = 1; i <= a.length; ++i) {
      const next = [i];
      for (let j = 1; j <= b.length; ++j) {
        const change = a[i - 1] === b[j - 1] ? 0 : 1;
        next[j] = Math.min(row[j] + 1, next[j - 1] + 1, row[j - 1] + change);
        const isSwapped = i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1];
        if (isSwapped) next[j] = Math.min(next[j], before[j - 2] + 1);
      }
      if (Math.min(...next) > most) return most + 1;
      [before, row] = [row, next];
    }
    return row[b.length];
  };

  // The words, or prefixes of words, nearest to a misspelled one.
  const nearest = (word) => {
    const most = word.length < 4 ? 0 : word.length < 8 ? 1 : 2;
    vocabulary ??= new Set(
      [...entries, ...entries.flatMap((entry) => entry.twins)]
        .flatMap((entry) => [...entry.parts, ...entry.words, ...entry.text.split(/[^a-z0-9]+/)])
        .concat(synonyms.flat())
        .filter((w) => w.length > 2),
    );
    let [least, found] = [most, []];
    for (const known of most ? vocabulary : []) {
      const whole = distance(word, known, least);
      const far = known.length > word.length ? Math.min(whole, distance(word, known.slice(0, word.length), least)) : whole;
      if (far < least) [least, found] = [far, []];
      if (far === least) found.push([known, whole]);
    }
    return found.sort((a, b) => a[1] - b[1]).slice(0, 4).map(([known]) => known);
  };

  // The results, and the corrections of misspelled words.
  const find = (query) => {
    const words = wordsOf(query);
    const taken = [];
    const alternatives = words.map((word) => {
      const meant = meanings(word);
      const fits = (entry) =>
        [entry, ...entry.twins].some((e) => [...meant.keys()].some((w) => fit(e, w, entry.isProse)));
      if (isLines.test(word) || entries.some(fits)) return meant;
      const near = nearest(word);
      if (near.length) taken.push([word, near[0]]);
      return new Map(near.flatMap((w) => [...meanings(w)].map(([other, worth]) => [other, worth * 0.9])));
    });
    const found = [];
    for (const entry of words.length ? entries : []) {
      // The best match of several twins is shown, and links to its own page.
      let [most, shown] = [best(entry, alternatives, entry.isProse), entry];
      for (const twin of entry.twins) {
        const score = best(twin, alternatives, false);
        if (score > most) [most, shown] = [score, twin];
      }
      const others = [entry, ...entry.twins].filter((twin) => twin !== shown).map((twin) => twin.name);
      if (most > 0) found.push([most - entry.behind, { ...shown, kind: entry.kind, order: entry.order, others }]);
    }
    found.sort((a, b) => b[0] - a[0] || a[1].name.length - b[1].name.length || a[1].order - b[1].order);
    return { found: found.map(([, entry]) => entry), taken };
  };

  const option = (entry, index) => {
    const link = document.createElement("a");
    link.id = `search-${index}`;
    link.href = root + entry.page.replace(/#.*/, (part) => `#${encodeURIComponent(part.slice(1))}`);
    link.tabIndex = -1;
    link.setAttribute("role", "option");
    link.setAttribute("aria-selected", "false");
    const twins = entry.others.length ? `with ${entry.others.join(", ")}` : "";
    const about = [twins, entry.about].filter(Boolean).join(" · ");
    for (const [name, text] of [["name", entry.name], ["kind", entry.kind], ["about", about]]) {
      if (!text) continue;
      const part = document.createElement("span");
      part.className = name;
      part.textContent = text;
      link.append(part, " ");
    }
    link.addEventListener("pointermove", () => choose(index));
    link.addEventListener("click", close);
    return link;
  };

  // A line among the results without a link.
  const note = (text) => {
    const line = document.createElement("div");
    line.className = "nothing";
    line.setAttribute("role", "option");
    line.setAttribute("aria-disabled", "true");
    line.setAttribute("aria-selected", "false");
    line.textContent = text;
    return line;
  };

  const choose = (index) => {
    const options = list.querySelectorAll("a[role=option]");
    options[active]?.setAttribute("aria-selected", "false");
    active = options.length ? (index + options.length) % options.length : -1;
    const chosen = options[active];
    chosen?.setAttribute("aria-selected", "true");
    chosen?.scrollIntoView({ block: "nearest" });
    if (chosen) input.setAttribute("aria-activedescendant", chosen.id);
    else input.removeAttribute("aria-activedescendant");
  };

  const open = () => {
    list.hidden = false;
    input.setAttribute("aria-expanded", "true");
  };

  const close = () => {
    list.hidden = true;
    input.setAttribute("aria-expanded", "false");
    input.removeAttribute("aria-activedescendant");
    active = -1;
  };

  const show = async () => {
    const query = input.value;
    if (!query.trim()) {
      status.textContent = "";
      list.replaceChildren();
      close();
      return;
    }
    try {
      await load();
    } catch {
      status.textContent = "The search index could not be loaded.";
      return;
    }
    if (query !== input.value) return; // the query has changed
    const { found, taken } = find(query);
    active = -1;
    list.replaceChildren(...found.slice(0, limit).map(option));
    const read = taken.map(([word, known]) => `Showing “${known}” for “${word}”.`).join(" ");
    const count = found.length === 1 ? "1 result" : `${found.length} results`;
    status.textContent = `${read} ${count}`.trim();
    if (found.length === 0) list.prepend(note("Nothing found."));
    else if (read) list.prepend(note(read));
    list.dataset.query = query;
    open();
    if (found.length) choose(0);
  };

  input.addEventListener("focus", () => load().catch(() => {}), { once: true });
  input.addEventListener("input", show);
  input.addEventListener("focus", () => input.value.trim() && show());
  input.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      event.preventDefault();
      if (list.hidden) show();
      else choose(active + (event.key === "ArrowDown" ? 1 : -1));
    } else if (event.key === "Escape") {
      if (list.hidden) input.value = "";
      close();
      event.preventDefault();
    }
  });
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const chosen = list.querySelector('a[aria-selected="true"]');
    if (chosen && !list.hidden) chosen.click();
  });
  form.addEventListener("focusout", (event) => {
    if (!form.contains(event.relatedTarget)) close();
  });
  list.addEventListener("pointerdown", (event) => event.preventDefault()); // keeps the focus
  document.addEventListener("keydown", (event) => {
    const typing = event.target.closest("input, textarea, select, [contenteditable]");
    if (event.key !== "/" || typing || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    input.focus();
    input.select();
  });
})();
