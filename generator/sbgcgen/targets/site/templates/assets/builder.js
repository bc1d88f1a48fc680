// The frame builder: a form with the fields of a message, and the frame that the C++ library makes of
// its values. A link that ends with #build&FIELD=VALUE&... fills it in. It sends nothing.
"use strict";

(() => {
  const section = document.getElementById("builder");
  const name = section.dataset.message;
  const facts = JSON.parse(section.dataset.facts);
  const typed = sbgcBuilderCode(name, facts);
  const root = document.body.dataset.root;
  const typingPause = 120; // ms
  const { element, loadScript, addCopyButton } = sbgcPage;

  // The module, which is loaded when a reader opens the form.

  async function load() {
    await loadScript("messages-module.js");
    const code = Uint8Array.from(atob(globalThis.sbgcMessagesModule), (c) => c.charCodeAt(0));
    // The C library refers to files; there are none (8: not an open file).
    const noFile = () => 8;
    const files = { fd_close: noFile, fd_seek: noFile, fd_write: noFile };
    const { instance } = await WebAssembly.instantiate(code, { wasi_snapshot_preview1: files });
    instance.exports._initialize();
    return instance.exports;
  }
  let loaded = null; // a promise of the functions of the module

  /** What C++ makes of these values; see web/modules/builder.cpp. */
  async function build(frame, lines) {
    loaded ??= load();
    const wasm = await loaded;
    const input = new TextEncoder().encode([name, frame, ...lines].join("\n"));
    const pointer = wasm.input(input.length);
    new Uint8Array(wasm.memory.buffer, pointer, input.length).set(input);
    wasm.build();
    const output = new Uint8Array(wasm.memory.buffer, wasm.output(), wasm.output_size());
    return JSON.parse(new TextDecoder().decode(output));
  }

  // The form. Each entry has the path of a field, and how to read the text of its value.

  let entries = [];
  let shape = "";

  const idOf = (path) => `build-${path}`;

  /** A control with its label, unit, limits, and a place for what is wrong. */
  function entryOf(field, control, read, write) {
    const id = idOf(field.path);
    const problem = element("p", { class: "problem", id: `${id}-problem`, hidden: true });
    const unit = element("span", { class: "unit" }, field.unit ?? "");
    const positive = facts.positive[field.path];
    const hints = [field.hint, positive && `positive: ${positive}`].filter(Boolean).join("; ");
    const hint = element("small", { class: "muted", id: `${id}-hint` }, hints);
    control.setAttribute("aria-describedby", `${id}-hint ${id}-problem`);
    entries.push({ path: field.path, optional: field.optional ?? false, control, problem, unit, hint, read, write });
    return [unit, hint, problem];
  }

  function labeled(field, control, read, write) {
    const id = idOf(field.path);
    control.id = id;
    const label = element("label", { for: id }, element("code", {}, field.name));
    return element("div", { class: "entry" }, label, control, ...entryOf(field, control, read, write));
  }

  function textOf(field) {
    const isNumber = field.kind === "number";
    const input = element("input", {
      type: "text",
      inputmode: isNumber ? "decimal" : null,
      autocomplete: "off",
      spellcheck: "false",
      placeholder: field.optional ? "none" : null,
    });
    input.value = field.value;
    return labeled(field, input, () => input.value, (value) => (input.value = value));
  }

  /** Names to choose from. A value without a name is one more. */
  function selectOf(names, value, isOptional) {
    const known = names.includes(value) || value === "" ? names : [...names, value];
    const all = isOptional ? ["", ...known] : known;
    const select = element("select", {}, ...all.map((one) => element("option", { value: one }, one || "none")));
    select.value = value;
    return select;
  }

  function enumOf(field) {
    const select = selectOf(field.names, field.value, field.optional);
    return labeled(field, select, () => select.value, (value) => (select.value = value));
  }

  /** Check boxes. Bits without a name stay as they are. */
  function boxesOf(names, value) {
    const set = value.split("|");
    const boxes = names.map((one) => element("input", { type: "checkbox", value: one }));
    for (const box of boxes) box.checked = set.includes(box.value);
    const rest = set.filter((one) => one !== "0" && one !== "" && !names.includes(one));
    const read = () => [...boxes.filter((box) => box.checked).map((box) => box.value), ...rest].join("|") || "0";
    const labels = boxes.map((box) => element("label", { class: "check" }, box, element("span", {}, box.value)));
    return { labels, read };
  }

  /** A group of controls that is one value. If it may be missing, a check box says whether it is there. */
  function valueGroup(field, controls, read) {
    const box = element("fieldset", { class: "flow value", id: idOf(field.path) });
    const legend = element("legend", {}, element("code", {}, field.name));
    const present = element("input", { type: "checkbox" });
    present.checked = field.value !== "";
    const switches = field.optional ? [element("label", { class: "check" }, present, " in the body")] : [];
    const readAll = () => (field.optional && !present.checked ? "" : read());
    const write = () => (present.checked = true);
    box.append(legend, ...switches, ...controls, ...entryOf(field, box, readAll, write));
    return box;
  }

  function flagsOf(field) {
    const { labels, read } = boxesOf(field.names, field.value);
    return valueGroup(field, labels, read);
  }

  function packedOf(field) {
    const parts = field.parts.map((part) => {
      const label = `${part.name}${part.unit ? ` (${part.unit})` : ""}`;
      if (part.kind === "flags") {
        const { labels, read } = boxesOf(part.names, part.value);
        const one = element("fieldset", { class: "flow value" }, element("legend", {}, label), ...labels);
        return { control: one, read: () => (read() === "0" ? `${part.name}:0` : read().replaceAll("|", ",")) };
      }
      const input = part.kind === "enum" ? selectOf(part.names, part.value, false) : element("input", { type: "text", autocomplete: "off" });
      input.value = part.value;
      const control = element("label", { class: "part" }, element("span", {}, label), " ", input);
      return { control, read: () => `${part.name}:${input.value}` };
    });
    const read = () => parts.map((part) => part.read()).join(",");
    return valueGroup(field, parts.map((part) => part.control), read);
  }

  function groupOf(field) {
    const box = element("fieldset", {}, element("legend", {}, element("code", {}, field.name)));
    box.append(...field.fields.map(controlOf));
    if (field.grows === undefined) return box;
    const change = (text, isPossible, lines) => {
      const button = element("button", { type: "button", class: "plain quiet small" }, text);
      button.disabled = !isPossible;
      button.addEventListener("click", () => show(lines(), true));
      return button;
    };
    const count = field.fields.length;
    const last = `${field.path}[${count - 1}]`;
    box.append(
      change(`Add one to ${field.name}`, count < field.grows, () => [...valuesOf(), `${field.path}[${count}]`]),
      " ",
      change("Remove the last", count > 0, () => valuesOf().filter((line) => !line.startsWith(last))),
    );
    return box;
  }

  const controls = { group: groupOf, axes: groupOf, list: groupOf, enum: enumOf, flags: flagsOf, packed: packedOf };
  const controlOf = (field) => (controls[field.kind] ?? textOf)(field);

  /** The values of the form, as C++ reads them. */
  const valuesOf = () =>
    entries
      .map(({ path, optional, read }) => ({ path, optional, text: read() }))
      .filter(({ optional, text }) => !(optional && text === ""))
      .map(({ path, text }) => `${path}=${text}`);

  // The bytes and code for the values

  const quoted = (text) => (/^[\w.,:=@%+/-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);

  const languages = [
    {
      word: "command",
      title: "Command line",
      code: (lines) =>
        ["sbgc send", name, ...lines.map(([path, text, secret]) => quoted(`${path}=${secret && text ? "@FILE" : text}`))].join(" "),
    },
    { word: "cpp", title: "C++", code: typed.cpp },
    { word: "python", title: "Python", code: typed.python },
  ];

  const form = element("form", { autocomplete: "off" });
  const result = element("div", { class: "built" });
  const status = element("p", { role: "status" });
  const others = element("ul", { class: "problem", hidden: true });

  function codeBlock(about, text, word) {
    const code = element("code", { class: word }, text);
    const block = element("div", { class: "code", "data-copy": about }, element("pre", { class: "wrap", tabindex: "0" }, code));
    addCopyButton(block);
    return block;
  }

  function showFrame(frame, lines) {
    result.replaceChildren();
    if (frame === "") return;
    const hex = frame.match(/../g).join(" ").toUpperCase();
    const shared = lines.filter(([, , secret]) => !secret);
    const values = shared.map(([path, text]) => `&${encodeURIComponent(path)}=${encodeURIComponent(text)}`);
    const links = element("p", { class: "flow" });
    const add = (word, href, text) => links.append(element("a", { class: `button quiet small ${word}`, href }, text));
    add("built-bytes", `${root}decoder.html#hex=${frame}&from=host`, "Open in the decoder");
    add("built-link", `#build${values.join("")}`, "Link to these values");
    // A link holds no secret.
    if (shared.length === lines.length) add("built-trial", `${root}playground.html#send=${frame}`, "Try it in the playground");
    result.append(codeBlock("the frame", hex, "built-frame"), links);
    for (const { word, title, code } of languages) {
      result.append(element("h3", {}, title), codeBlock(`the lines of ${title}`, code(lines), `built-${word}`));
    }
  }

  function showProblems(problems) {
    others.replaceChildren();
    for (const entry of entries) {
      entry.problem.hidden = true;
      entry.control.removeAttribute("aria-invalid");
    }
    for (const [path, sentence] of problems) {
      const entry = entries.find((one) => one.path === path || path.startsWith(`${one.path}[`));
      if (!entry) {
        others.append(element("li", {}, path ? `${path}: ${sentence}` : sentence));
        continue;
      }
      entry.problem.textContent = sentence;
      entry.problem.hidden = false;
      if (entry.control.tagName !== "FIELDSET") entry.control.setAttribute("aria-invalid", "true");
    }
    others.hidden = others.childElementCount === 0;
  }

  /** The fields with a value of their own, in the order of the form. */
  const leavesOf = (fields) => fields.flatMap((field) => (field.fields ? leavesOf(field.fields) : [field]));
  const shapeOf = (fields) => leavesOf(fields).map((field) => field.path).join();

  let latest = 0;

  /** Shows what the lines make; the form as well, if they come from elsewhere. */
  async function show(lines, isNew, frame = "") {
    const number = ++latest;
    let built;
    try {
      built = await build(frame, lines);
    } catch (error) {
      status.textContent = `This copy of the site has no frame builder: ${error.message} is missing.`;
      return;
    }
    if (number !== latest) return;
    if (isNew || shapeOf(built.fields) !== shape) {
      entries = [];
      shape = shapeOf(built.fields);
      form.replaceChildren(...built.fields.map(controlOf));
      if (built.fields.length === 0) form.append(element("p", { class: "muted" }, "The message has no fields."));
    }
    for (const field of leavesOf(built.fields)) {
      const entry = entries.find((one) => one.path === field.path);
      entry.unit.textContent = field.unit ?? "";
      // The values of others demand it.
      if (entry.optional && entry.read() === "" && field.value !== "") entry.write(field.value);
    }
    showProblems([...built.problems, ...built.warnings]);
    showFrame(built.frame, built.lines);
    const size = built.frame.length / 2;
    status.textContent = size ? `A frame of ${size} bytes:` : "No frame: the values above are not all possible.";
  }

  // Opening

  const details = element("details", {}, element("summary", {}, "Build a frame with other values"));
  const example = document.querySelector("#example [data-frame]")?.dataset.frame ?? "";
  let isFilled = false;

  function fillFromAddress() {
    const given = new URLSearchParams(location.hash.slice(1));
    if (!given.has("build")) return;
    given.delete("build");
    isFilled = true;
    details.open = true;
    show([...given].map(([path, text]) => `${path}=${text.replaceAll("\n", " ")}`), true);
    section.scrollIntoView();
  }

  let pause = 0;
  form.addEventListener("input", () => {
    clearTimeout(pause);
    pause = setTimeout(() => show(valuesOf(), false), typingPause);
  });
  form.addEventListener("submit", (event) => event.preventDefault());
  details.addEventListener("toggle", () => {
    if (!details.open || isFilled) return;
    isFilled = true;
    show([], true, example);
  });

  section.append(
    element("h2", { id: "builder-title" }, "Frame builder"),
    element("p", {}, "Values in their units, and the frame that the C++ library makes of them in this page. Nothing is sent."),
    details,
  );
  details.append(form, others, status, result);
  const link = element("li", {}, element("a", { href: "#builder" }, "Frame builder"));
  document.querySelector('.outline a[href="#example"]').closest("li").after(link);
  section.setAttribute("aria-labelledby", "builder-title");
  section.hidden = false;
  addEventListener("hashchange", fillFromAddress);
  fillFromAddress();
})();
