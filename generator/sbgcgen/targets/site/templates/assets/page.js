// Conveniences; every page works without them.
"use strict";

(() => {
  const root = document.documentElement;

  // Light or dark
  const theme = document.querySelector(".theme");
  const system = matchMedia("(prefers-color-scheme: dark)");
  const isDark = () => (root.dataset.theme ?? (system.matches ? "dark" : "light")) === "dark";
  const showTheme = () => theme.setAttribute("aria-pressed", String(isDark()));
  theme.addEventListener("click", () => {
    root.dataset.theme = isDark() ? "light" : "dark";
    try {
      localStorage.setItem("theme", root.dataset.theme);
    } catch {
      // The choice lasts for this page only.
    }
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

  // Copy buttons
  function addCopyButton(block) {
    if (!navigator.clipboard) return;
    const button = document.createElement("button");
    button.type = "button";
    button.className = "copy";
    button.textContent = "Copy";
    button.setAttribute("aria-label", `Copy ${block.dataset.copy}`);
    button.addEventListener("click", async () => {
      const code = block.querySelector("code");
      try {
        await navigator.clipboard.writeText(code.textContent.trim());
        button.textContent = "Copied";
      } catch {
        button.textContent = "Not allowed";
      }
      setTimeout(() => (button.textContent = "Copy"), 1500);
    });
    block.prepend(button);
  }
  for (const block of document.querySelectorAll("[data-copy]")) addCopyButton(block);
  globalThis.sbgcAddCopyButton = addCopyButton; // for what other scripts add

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
    const list = document.createElement("div");
    list.className = "tab-list";
    list.setAttribute("role", "tablist");
    const tabs = panels.map((panel, index) => {
      const tab = document.createElement("button");
      const heading = panel.querySelector("h3");
      panel.id = `tab-${heading.id}`;
      panel.setAttribute("role", "tabpanel");
      tab.type = "button";
      tab.textContent = panel.dataset.tab;
      tab.setAttribute("role", "tab");
      tab.setAttribute("aria-controls", panel.id);
      tab.addEventListener("click", () => open(index));
      return tab;
    });
    const open = (chosen, isKept = true) => {
      for (const [index, panel] of panels.entries()) {
        panel.classList.toggle("closed", index !== chosen);
        tabs[index].setAttribute("aria-selected", String(index === chosen));
        tabs[index].tabIndex = index === chosen ? 0 : -1;
      }
      if (!isKept) return;
      try {
        localStorage.setItem("tab", panels[chosen].id);
      } catch {
        // The choice lasts for this page only.
      }
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
    list.setAttribute("aria-label", "Language of the example");
    list.append(...tabs);
    box.prepend(list);
    let kept = null;
    try {
      kept = localStorage.getItem("tab");
    } catch {
      // The first one, then.
    }
    open(Math.max(0, named(kept)), false);
    openAddress();
    addEventListener("hashchange", openAddress);
  }

  // Highlights bytes of a frame and their rows together.
  for (const part of document.querySelectorAll("[data-part]")) {
    const scope = part.closest("article") ?? document;
    const mark = (on) => {
      for (const same of scope.querySelectorAll(`[data-part="${CSS.escape(part.dataset.part)}"]`)) {
        same.classList.toggle("lit", on);
      }
    };
    part.addEventListener("pointerenter", () => mark(true));
    part.addEventListener("pointerleave", () => mark(false));
  }
  for (const cell of document.querySelectorAll("[data-row]")) {
    cell.addEventListener("click", () => {
      location.hash = encodeURIComponent(cell.dataset.row);
    });
  }
})();
