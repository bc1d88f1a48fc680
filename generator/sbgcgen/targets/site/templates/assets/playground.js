// Loads the playground, which a browser runs only from a server.
"use strict";

(() => {
  const place = document.getElementById("playground");
  const element = (tag, text) => Object.assign(document.createElement(tag), { textContent: text });

  function say(sentence, command) {
    const note = element("div", "");
    note.className = "note warn";
    note.append(element("p", sentence));
    if (command) {
      const block = element("pre", "");
      block.tabIndex = 0;
      block.append(element("code", command));
      note.append(block);
    }
    place.replaceChildren(note);
  }

  if (!/^https?:$/.test(location.protocol)) {
    say(
      "A browser runs the playground only from a server, not from a file. In the folder of the site, run this, then open http://localhost:8000/playground.html:",
      "python3 -m http.server",
    );
    return;
  }
  const manifest = { rel: "manifest", href: "assets/playground.webmanifest" };
  document.head.append(Object.assign(element("link", ""), manifest));
  const script = Object.assign(document.createElement("script"), {
    type: "module",
    src: "assets/playground/main.js",
  });
  script.onerror = () => say("This copy of the site has no playground: it was rendered without npm, or a file is missing.");
  place.append(element("p", "The gimbal is loaded…"));
  document.head.append(script);
})();
