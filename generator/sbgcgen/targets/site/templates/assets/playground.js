// Loads the script of a page that a browser runs only from a server; data-script names it.
"use strict";

(() => {
  const { script } = document.currentScript.dataset;
  const notes = ["server", "missing", "loading"];
  const show = (shown) => {
    for (const note of notes) document.getElementById(`application-${note}`).hidden = note !== shown;
  };
  const add = (tag, attributes) => document.head.append(Object.assign(document.createElement(tag), attributes));

  if (!/^https?:$/.test(location.protocol)) return show("server");
  show("loading");
  add("link", { rel: "manifest", href: "assets/playground.webmanifest" });
  add("script", {
    type: "module",
    src: `assets/playground/${script}`,
    onload: () => show(""),
    onerror: () => show("missing"),
  });
})();
