// Finds entries in the index of the site, with MiniSearch; search.js shows them.
"use strict";

const sbgcFinder = async (MiniSearch, { synonyms, entries, links }) => {
  const stop = new Set(
    ("a about basecam board gimbal sbgc simplebgc not work works working help need problem an and any are as at be by can cannot do does for from get give has have how i if in into is it its make me my of " +
      "on or our please should so that the their there this to use using via want was we what when where which while why will with you your").split(" "),
  );
  // Words that say only what kind of thing is meant: they add a little, and need not be there.
  const vague = new Set(["cmd", "command", "message"]);
  // How a command travels, not what it does: "switch profile over serial".
  const carriers = / (?:(?:by|from|over|through|via) (?:the )?(?:serial|uart)(?: port)?|(?:serial|uart) commands?)(?= )/g;
  // The weight of a word in each field. `asked` are the words that people ask with, `prose` those of a guide.
  const boost = { whole: 12, asked: 16, name: 6, words: 3, about: 2.5, topics: 5, prose: 1 };
  // The weights of kinds: people want some more often than others.
  const kinds = {
    page: 1.5, guide: 1.5, section: 1.4, message: 1.4, version: 0.9, unit: 1, command: 1, family: 1, enum: 0.9, flags: 0.9, packed: 0.7,
    field: 0.7, variable: 0.7, value: 0.5, name: 0.3, erratum: 0.3,
  };
  // The usual values but for b: a long list of words that people ask with is no worse than a short one.
  const bm25 = { k: 1.2, b: 0.3, d: 0.5 };
  // Parts of one page that come before those of others.
  const mostOfPage = 2;

  // Lines of the specification, as in "L1148" or "L1148-L1160".
  const isLines = /^l(\d+)(?:-l(\d+))?$/;
  const plain = (text) => text.toLowerCase();
  const stem = (word) => (/^[a-z]{3,}[^su]s$/.test(word) ? word.slice(0, -1) : word);
  // Makes "Axes.roll" and "axes_roll" equal.
  const squeeze = (text) => plain(text).replace(/[\s_.·-]+/g, "");
  // "2.67" is one word.
  const partsOf = (text) => text.replace(/([a-z0-9])(?=[A-Z])/g, "$1 ").match(/[\p{L}\p{N}°/+#]+(?:\.\d[\p{L}\p{N}]*)*/gu) ?? [];
  const termsOf = (text) => partsOf(text).map(plain).map(stem);

  const fileOf = (page) => page.replace(/#.*/, "");

  const documentOf = (id, kind, name, about, page, more) => {
    const words = more.split(" ").filter(Boolean);
    const isProse = ["guide", "section"].includes(kind);
    const marked = (mark) => words.filter((w) => w.startsWith(mark)).map((w) => w.slice(1));
    const others = words.filter((w) => !isLines.test(plain(w)) && !/^[~!]/.test(w));
    return {
      id, kind, page,
      whole: [name, ...name.split(".").slice(1), ...(isProse ? [] : others)].map(squeeze),
      asked: marked("!").map((w) => stem(plain(w))),
      name: termsOf(name),
      words: isProse ? [] : others.flatMap(termsOf),
      about: kind === "section" ? [] : termsOf(about),
      topics: marked("~").flatMap(termsOf),
      prose: isProse ? others.flatMap(termsOf) : [],
      lines: words.map((w) => isLines.exec(plain(w))).filter(Boolean)
        .map(([, first, last]) => [Number(first), Number(last ?? first)]),
    };
  };

  // Twins are documents of their own, but one result.
  const all = entries.flatMap(([kind, name, about, page, words, twins = []], entry) =>
    [[name, about, page, words], ...twins].map(([n, a, p, w], twin) => ({ entry, twin, kind, name: n, about: a, page: p, words: w })),
  );
  const documents = all.map((one, id) => documentOf(id, one.kind, one.name, one.about, one.page, one.words));
  const options = {
    fields: Object.keys(boost),
    stringifyField: (terms) => terms, // each field is a list of terms
    tokenize: (terms) => terms,
    processTerm: (term) => term,
  };
  const index = new MiniSearch({ ...options, extractField: (document, field) => document[field] });
  await index.addAllAsync(documents, { chunkSize: 300 });

  // Alternatives to a word, with their worth: itself, then its synonyms, worth less the later they are listed.
  const meanings = (word) => {
    const found = new Map([[word, 1]]);
    for (const group of synonyms) {
      const same = group.map(stem);
      if (!same.includes(word)) continue;
      same.forEach((other, place) => {
        const isSpelling = other.replaceAll("z", "s") === word.replaceAll("z", "s"); // "stabilize"
        if (!found.has(other)) found.set(other, isSpelling ? 0.95 : Math.max(0.2, 0.6 - 0.1 * place));
      });
    }
    // "inverted", "overheating" and "vibrating" begin like "invert", "overheat" and "vibration".
    const root = /^([a-z]{4,})(?:ed|ing|er|es)$/.exec(word)?.[1];
    if (root && !found.has(root)) found.set(root, 0.7);
    for (const [other, worth] of [...found]) {
      const parts = termsOf(other);
      if (parts.length > 1) found.set(parts, 0.8 * worth);
      if (squeeze(other) !== other) found.set(squeeze(other), worth);
    }
    return found;
  };

  const search = (query, more) =>
    index.search(query, { ...options, boost, bm25, tokenize: (text) => [text], combineWith: "AND", ...more });

  const add = (scores, results, worth) => {
    for (const { id, score } of results) scores.set(id, Math.max(scores.get(id) ?? 0, worth * score));
  };

  // The score of each document that has a word, or one that means the same.
  const scoresOf = (word) => {
    const scores = new Map();
    const prefix = (term) => term.length > 2 && !/^\d+$/.test(term);
    for (const [term, worth] of meanings(word)) {
      const mayGoOn = term.slice(0, 4) === word.slice(0, 4) ? prefix : false; // not "accelerate" for "accelerometer", by "acc"
      add(scores, search(Array.isArray(term) ? { queries: term } : term, { prefix: mayGoOn }), worth);
    }
    return scores;
  };

  // The results of one word, and for a misspelled word what it is taken for.
  const matches = (word) => {
    const scores = scoresOf(word);
    if (scores.size || word.length < 4) return { scores };
    const near = search(word, { fuzzy: word.length < 5 ? 1 : 2 /* as for swapped letters */, prefix: true });
    add(scores, near, 0.9);
    return { scores, taken: near[0]?.terms[0] };
  };

  // The words of a query. Those of a synonym such as "factory reset" stay together; those of an unknown name do not.
  const wordsOf = (query) => {
    const isLoud = query === query.toUpperCase();
    const told = (isLoud ? query : query.replace(/\bCAN\b(?! bus)/g, "can bus")).replace(/\b(?:sbgc|simplebgc)_(?=\w)/gi, "");
    let text = ` ${plain(told).replace(/[?!,;"'’()]+/g, " ").split(/\s+/).filter(Boolean).join(" ")} `;
    const short = text.replace(carriers, "");
    if (short.trim()) text = short;
    const words = [];
    for (const phrase of synonyms.flat().filter((w) => w.includes(" "))) {
      if (!text.includes(` ${phrase} `)) continue;
      words.push(phrase);
      text = text.replace(` ${phrase} `, " ");
    }
    words.push(...text.split(" ").filter(Boolean));
    const isTelling = (word) => !stop.has(word);
    const telling = words.filter(isTelling);
    return (telling.length ? telling : words).map(stem).flatMap((word) => {
      const parts = /[_.]/.test(word) && !scoresOf(word).size ? termsOf(word).filter(isTelling) : [];
      return parts.length ? parts : [word];
    });
  };

  const fitLines = (first, last) => {
    const scores = new Map();
    for (const { id, lines } of documents) {
      const sizes = lines.filter(([from, to]) => from <= last && first <= to).map(([from, to]) => to - from);
      // A short range says more than a long one.
      if (sizes.length) scores.set(id, 1000 / (10 + Math.min(...sizes)));
    }
    return { scores };
  };

  // The results, and the corrections of misspelled words.
  return (query) => {
    const typed = wordsOf(query);
    const certain = typed.filter((word) => !vague.has(word));
    const words = certain.length ? certain : typed;
    const exact = [squeeze(query), squeeze(plain(query).split(/\s+/).filter((word) => !vague.has(stem(word))).join(""))];
    const taken = [];
    const total = new Map();
    for (const word of words) {
      const lines = isLines.exec(word);
      const found = lines ? fitLines(Number(lines[1]), Number(lines[2] ?? lines[1])) : matches(word);
      if (found.taken) taken.push([word, found.taken]);
      for (const [id, score] of found.scores) {
        const { sum = 0, count = 0 } = total.get(id) ?? {};
        total.set(id, { sum: sum + score, count: count + 1 });
      }
    }
    for (const word of typed.filter((one) => !words.includes(one))) { // vague ones
      for (const [id, score] of scoresOf(word)) {
        if (total.has(id)) total.get(id).sum += 0.3 * score;
      }
    }
    // Neighbors may be one word: "auto pid", "motor power".
    for (const [place, word] of words.slice(1).entries()) {
      for (const { id, score } of search(squeeze(words[place] + word), { fields: ["whole"] })) {
        if (total.has(id)) total.get(id).sum += score;
      }
    }
    const best = new Map(); // of each entry, the twin that fits best
    for (const [id, { sum, count }] of total) {
      const { kind, name, entry } = all[id];
      // Names of values and code are only for who types them: "MAX_SPEED", not "max speed".
      const isCode = ["value", "name"].includes(kind);
      const last = name.slice(name.lastIndexOf(".") + 1);
      const isExact = isCode ? /[_A-Z]/.test(query) && exact.includes(squeeze(last)) && !/\s/.test(query.trim()) : exact.includes(squeeze(name));
      const worth = isExact ? 2.5 * Math.max(0.8, kinds[kind]) : kinds[kind];
      const wanted = 1 + 0.12 * Math.log2(1 + (links[fileOf(all[id].page)] ?? 0));
      const score = sum * (count / words.length) ** 2 * worth * wanted;
      if (score > (best.get(entry)?.score ?? 0)) best.set(entry, { id, score });
    }
    const ranked = [...best.values()].sort((a, b) => b.score - a.score || a.id - b.id);
    const ofPage = new Map();
    const [first, later] = [[], []];
    for (const one of ranked) {
      const { page, entry } = all[one.id];
      const file = fileOf(page);
      const count = ofPage.get(file) ?? 0;
      ofPage.set(file, count + 1);
      (count < mostOfPage ? first : later).push({ ...all[one.id], score: one.score, others: all.filter((o) => o.entry === entry && o !== all[one.id]).map((o) => o.name) });
    }
    return { found: [...first, ...later], taken };
  };
};
