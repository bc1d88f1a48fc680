// Loads the playground, which a browser runs only from a server.
"use strict";

(() => {
  const notes = ["server", "missing", "loading"];
  const show = (shown) => {
    for (const note of notes) document.getElementById(`playground-${note}`).hidden = note !== shown;
  };
  const add = (tag, attributes) => document.head.append(Object.assign(document.createElement(tag), attributes));

  if (!/^https?:$/.test(location.protocol)) return show("server");
  show("loading");
  add("link", { rel: "manifest", href: "assets/playground.webmanifest" });
  add("script", {
    type: "module",
    src: "assets/playground/main.js",
    onload: () => show(""),
    onerror: () => show("missing"),
  });
})();
