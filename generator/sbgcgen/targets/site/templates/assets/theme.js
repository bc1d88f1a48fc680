// Runs before the page is drawn, so that it never shows the wrong colours for a moment.
"use strict";

(() => {
  const root = document.documentElement;
  root.classList.add("js");
  try {
    const chosen = localStorage.getItem("theme");
    if (chosen === "light" || chosen === "dark") root.dataset.theme = chosen;
  } catch {
    // No storage, no memory: the system's choice holds.
  }
})();
