// Search without a server: the index is a script, loaded when the box first gets the focus.
"use strict";

(() => {
  const form = document.querySelector(".search");
  const input = document.getElementById("search");
  const list = document.getElementById("search-results");
  const status = document.getElementById("search-status");
  const root = document.body.dataset.root;
  const limit = 30;
  // The order of kinds among equals.
  const kinds = ["message", "command", "guide", "family", "enum", "flags", "packed", "unit", "variable", "field", "value", "erratum"];

  let entries; // [{kind, name, about, page, words, text}], once loaded
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
      entries = sbgcSearchIndex.map(([kind, name, about, page, more], order) => ({
        kind, name, about, page, order,
        names: plain(name),
        words: plain(more),
        text: plain(about),
        rank: kinds.indexOf(kind),
      }));
    });
    return loading;
  };

  // "Axes.roll" and "axes_roll" are one; CamelCase is taken apart by its own words, too.
  const plain = (text) => text.toLowerCase();
  const squeeze = (text) => text.replace(/[\s_.·-]+/g, "");

  // How well one word fits: 0 not at all.
  const fit = (entry, word) => {
    const tight = squeeze(word);
    if (entry.names === word || squeeze(entry.names) === tight) return 100;
    const words = entry.words.split(" ");
    if (words.includes(word)) return 90;
    const last = entry.names.slice(entry.names.lastIndexOf(".") + 1);
    if (last === word) return 85;
    if (entry.names.startsWith(word) || entry.names.startsWith(`cmd_${word}`)) return 70;
    if (last.startsWith(word) || words.some((other) => other.startsWith(word))) return 60;
    if (/^\d+$/.test(word)) return 0; // a number is meant as a whole
    if (entry.names.split(/[_.\s]+/).some((part) => part.startsWith(word))) return 50;
    if (tight.length > 1 && squeeze(entry.names).includes(tight)) return 40;
    if (tight.length > 2 && squeeze(entry.words).includes(tight)) return 30;
    if (word.length > 2 && entry.text.includes(word)) return 10;
    return 0;
  };

  const find = (query) => {
    const words = plain(query).trim().split(/\s+/).filter(Boolean);
    if (words.length === 0) return [];
    const found = [];
    for (const entry of entries) {
      let score = 0;
      for (const word of words) {
        const one = fit(entry, word);
        if (one === 0) {
          score = 0;
          break;
        }
        score += one;
      }
      if (score > 0) found.push([score / words.length - entry.rank * 1.5, entry]);
    }
    found.sort((a, b) => b[0] - a[0] || a[1].name.length - b[1].name.length || a[1].order - b[1].order);
    return found.map(([, entry]) => entry);
  };

  const option = (entry, index) => {
    const link = document.createElement("a");
    link.id = `search-${index}`;
    link.href = root + entry.page.replace(/#.*/, (part) => `#${encodeURIComponent(part.slice(1))}`);
    link.tabIndex = -1;
    link.setAttribute("role", "option");
    link.setAttribute("aria-selected", "false");
    for (const [name, text] of [["name", entry.name], ["kind", entry.kind], ["about", entry.about]]) {
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

  const choose = (index) => {
    const options = list.querySelectorAll("[role=option]");
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
    if (query !== input.value) return; // more has been typed
    const found = find(query);
    active = -1;
    list.replaceChildren(...found.slice(0, limit).map(option));
    status.textContent = found.length === 1 ? "1 result" : `${found.length} results`;
    if (found.length === 0) {
      const nothing = document.createElement("div");
      nothing.className = "nothing";
      nothing.setAttribute("role", "option");
      nothing.setAttribute("aria-disabled", "true");
      nothing.setAttribute("aria-selected", "false");
      nothing.textContent = "Nothing found.";
      list.replaceChildren(nothing);
    }
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
  list.addEventListener("pointerdown", (event) => event.preventDefault()); // the focus stays
  document.addEventListener("keydown", (event) => {
    const typing = event.target.closest("input, textarea, select, [contenteditable]");
    if (event.key !== "/" || typing || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    input.focus();
    input.select();
  });
})();
