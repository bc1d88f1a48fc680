// Conveniences, and what other scripts use; every page works without them.
"use strict";

const sbgcPage = (() => {
  const root = document.documentElement;

  /** element("td", {class: "raw"}, "text", child, ...) */
  function element(name, attributes = {}, ...children) {
    const result = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
      if (value !== null && value !== false) result.setAttribute(key, value === true ? "" : value);
    }
    result.append(...children);
    return result;
  }

  /** Loads a script of the site; rejects with an Error that names it. */
  const loadScript = (file) =>
    new Promise((resolve, reject) => {
      const script = element("script", { src: `${document.body.dataset.root}assets/${file}` });
      script.onload = resolve;
      script.onerror = () => reject(new Error(file));
      document.head.append(script);
    });


  // Light or dark
  const theme = document.querySelector(".theme");
  const system = matchMedia("(prefers-color-scheme: dark)");
  const isDark = () => (root.dataset.theme ?? (system.matches ? "dark" : "light")) === "dark";
  const showTheme = () => theme.setAttribute("aria-pressed", String(isDark()));
  theme.addEventListener("click", () => {
    root.dataset.theme = isDark() ? "light" : "dark";
    sbgcChoices.set("theme", root.dataset.theme);
    showTheme();
  });
  system.addEventListener("change", showTheme);
  showTheme();

  // The menu on a narrow page. Without this script it opens by its address, #menu.
  const menu = document.getElementById("menu");
  const opener = document.querySelector(".menu-button");
  const showMenu = (open) => {
    menu.classList.toggle("open", open);
    opener.setAttribute("aria-expanded", String(open));
    if (open) menu.querySelector("[aria-current], a").focus();
    else if (menu.contains(document.activeElement)) opener.focus();
  };
  opener.setAttribute("role", "button");
  opener.setAttribute("aria-controls", "menu");
  opener.setAttribute("aria-expanded", "false");
  opener.addEventListener("click", (event) => {
    event.preventDefault();
    showMenu(!menu.classList.contains("open"));
  });
  opener.addEventListener("keydown", (event) => {
    if (event.key !== " ") return;
    event.preventDefault();
    opener.click();
  });
  menu.querySelector(".close").addEventListener("click", (event) => {
    event.preventDefault();
    showMenu(false);
  });
  menu.addEventListener("keydown", (event) => {
    if (event.key === "Escape") showMenu(false);
  });

  /** A button that copies the text that `what()` returns. */
  function copyButton(label, what, attributes) {
    const button = element("button", { type: "button", ...attributes }, label);
    button.addEventListener("click", async () => {
      try {
        await navigator.clipboard.writeText(what());
        button.textContent = "Copied";
      } catch {
        button.textContent = "Not allowed";
      }
      setTimeout(() => (button.textContent = label), 1500);
    });
    return button;
  }
  function addCopyButton(block) {
    if (!navigator.clipboard) return;
    const what = () => block.querySelector("code").textContent.trim();
    block.prepend(copyButton("Copy", what, { class: "copy", "aria-label": `Copy ${block.dataset.copy}` }));
  }
  for (const block of document.querySelectorAll("[data-copy]")) addCopyButton(block);

  // An address unfolds what it leads to, such as an erratum.
  const unfold = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    target?.querySelector(":scope > details")?.setAttribute("open", "");
  };
  addEventListener("hashchange", unfold);
  unfold();

  // Tabs. The choice holds for all pages, and an address with the id of a heading chooses its tab.
  for (const box of document.querySelectorAll(".tabs")) {
    const panels = [...box.querySelectorAll(":scope > .tab")];
    const tabs = panels.map((panel, index) => {
      panel.id = `tab-${panel.querySelector("h3").id}`;
      panel.setAttribute("role", "tabpanel");
      const controls = { type: "button", role: "tab", "aria-controls": panel.id };
      const tab = element("button", controls, panel.dataset.tab);
      tab.addEventListener("click", () => open(index));
      return tab;
    });
    const about = { class: "tab-list", role: "tablist", "aria-label": "Language of the example" };
    const list = element("div", about, ...tabs);
    const open = (chosen, isKept = true) => {
      for (const [index, panel] of panels.entries()) {
        panel.classList.toggle("closed", index !== chosen);
        tabs[index].setAttribute("aria-selected", String(index === chosen));
        tabs[index].tabIndex = index === chosen ? 0 : -1;
      }
      if (isKept) sbgcChoices.set("tab", panels[chosen].id);
    };
    const named = (id) => panels.findIndex((panel) => panel.id === id);
    const openAddress = () => {
      const index = named(`tab-${location.hash.slice(1)}`);
      if (index < 0) return;
      open(index);
      box.scrollIntoView();
    };
    list.addEventListener("keydown", (event) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!step) return;
      event.preventDefault();
      const next = (tabs.indexOf(document.activeElement) + step + tabs.length) % tabs.length;
      open(next);
      tabs[next].focus();
    });
    box.prepend(list);
    open(Math.max(0, named(sbgcChoices.get("tab"))), false);
    openAddress();
    addEventListener("hashchange", openAddress);
  }

  /** Highlights bytes of a frame and their rows together. */
  function connectParts(scope) {
    const mark = (event, on) => {
      const part = event.target.closest?.("[data-part]")?.dataset.part;
      if (part === undefined) return;
      for (const same of scope.querySelectorAll(`[data-part="${CSS.escape(part)}"]`)) {
        same.classList.toggle("lit", on);
      }
    };
    scope.addEventListener("pointerover", (event) => mark(event, true));
    scope.addEventListener("pointerout", (event) => mark(event, false));
  }
  for (const article of document.querySelectorAll("article")) connectParts(article);
  for (const cell of document.querySelectorAll("[data-row]")) {
    cell.addEventListener("click", () => {
      location.hash = encodeURIComponent(cell.dataset.row);
    });
  }

  return { element, loadScript, copyButton, addCopyButton, connectParts };
})();
