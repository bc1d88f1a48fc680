// Runs before the page is drawn, so the wrong colors never flash.
"use strict";

/** What the reader has chosen, also on other pages; "": nothing. Without storage it lasts for this page. */
const sbgcChoices = {
  get(name) {
    try {
      return localStorage.getItem(name) ?? "";
    } catch {
      return "";
    }
  },
  set(name, value) {
    try {
      if (value) localStorage.setItem(name, value);
      else localStorage.removeItem(name);
    } catch {
      // There is no storage.
    }
  },
};

(() => {
  const root = document.documentElement;
  root.classList.add("js");
  const chosen = sbgcChoices.get("theme");
  if (chosen === "light" || chosen === "dark") root.dataset.theme = chosen;
})();
