// Search without a server: the index is a script, loaded when the box first gets the focus.
"use strict";

(() => {
  const form = document.querySelector(".search");
  const input = document.getElementById("search");
  const list = document.getElementById("search-results");
  const status = document.getElementById("search-status");
  const { element, loadScript } = sbgcPage;
  const root = document.body.dataset.root;
  const limit = 30;

  let find; // once the index is loaded
  let loading;
  let active = -1;

  const load = () => {
    loading ??= Promise.all(["minisearch.js", "finder.js", "search-index.js"].map(loadScript)).then(async () => {
      find = await sbgcFinder(MiniSearch, sbgcSearchIndex);
    });
    return loading;
  };

  const option = (entry, index) => {
    const href = root + entry.page.replace(/#.*/, (part) => `#${encodeURIComponent(part.slice(1))}`);
    const link = element("a", { id: `search-${index}`, href, tabindex: -1, role: "option", "aria-selected": "false" });
    const twins = entry.others.length ? `with ${entry.others.join(", ")}` : "";
    const about = [twins, entry.about].filter(Boolean).join(" · ");
    for (const [name, text] of [["name", entry.name], ["kind", entry.kind], ["about", about]]) {
      if (text) link.append(element("span", { class: name }, text), " ");
    }
    link.addEventListener("pointermove", () => choose(index));
    link.addEventListener("click", close);
    return link;
  };

  // A line among the results without a link.
  const note = (text) =>
    element("div", { class: "nothing", role: "option", "aria-disabled": "true", "aria-selected": "false" }, text);

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
    } catch ({ message }) {
      const isMissing = message === "minisearch.js";
      const reason = isMissing ? "The search is missing: this site was made without npm." : `${message} could not be loaded.`;
      status.textContent = reason;
      list.replaceChildren(note(reason));
      open();
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
