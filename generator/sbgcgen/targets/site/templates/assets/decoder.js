// The decoder page: passes the input to the engine and shows the result page by page.
"use strict";

(() => {
  const { element, copyButton, connectParts } = sbgcPage;
  const { counted, heading, inside, hexByte } = decoderView;
  const get = (id) => document.getElementById(id);
  const form = get("decoder");
  const text = get("hex");

  const pageSize = 100; // items of the list
  const largestText = 20000; // characters that a text area handles well
  const typingPause = 150; // ms

  // The engine, in a worker if possible.

  function startWorker(receive) {
    try {
      const source = `(${decoderEngine})(self);`;
      const url = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
      const worker = new Worker(url);
      worker.onmessage = (event) => receive(event.data);
      return (message) => worker.postMessage(message);
    } catch {
      const scope = { postMessage: (message) => setTimeout(receive, 0, message) };
      decoderEngine(scope);
      return (message) => scope.onmessage({ data: message });
    }
  }

  let send = null;
  function engine() {
    if (send === null) {
      send = startWorker(receive);
      send({ type: "load", module: globalThis.sbgcMessagesModule });
    }
    return send;
  }

  // The input: the text area, or data held outside it.

  let held = null; // {name, data: string or ArrayBuffer, hex}
  let job = 0;
  let items = [];
  let shown = []; // indices of the items that pass the filter
  let page = 0;
  let finished = false;
  let textError = null;
  let restart = 0;

  const from = () => form.elements.from.value;

  function decode() {
    clearTimeout(restart);
    ++job;
    items = [];
    shown = [];
    page = 0;
    finished = false;
    textError = null;
    showProblem(null);
    const data = held ? held.data : text.value;
    const empty = held === null && text.value.trim() === "";
    get("clear").hidden = held !== null || text.value === "";
    get("result").hidden = empty;
    get("summary").textContent = "";
    showPage();
    if (empty) {
      if (send !== null) send({ type: "cancel" });
      return;
    }
    if (globalThis.sbgcMessagesModule === undefined) {
      showProblem("This copy of the site has no decoder: it was built without ./dev docs.");
      return;
    }
    engine()({ type: "decode", job, data, hex: held ? held.hex : true, from: from() });
  }

  function decodeSoon() {
    clearTimeout(restart);
    restart = setTimeout(decode, typingPause);
  }

  function receive(message) {
    if (message.job !== undefined && message.job !== job) return;
    if (message.type === "batch") receiveBatch(message);
    if (message.type === "details") receiveDetails(message);
    if (message.type === "failed") {
      showProblem(`The decoder failed: ${message.reason}`);
    }
  }

  const isProblem = (item) => item.kind === "gap" || item.error !== null || item.objections !== 0;

  function receiveBatch(batch) {
    const filter = get("only-problems").checked;
    for (const item of batch.items) {
      if (!filter || isProblem(item)) shown.push(items.length);
      items.push(item);
    }
    get("progress").hidden = batch.end !== undefined;
    get("progress").value = batch.progress;
    if (batch.end) {
      finished = true;
      textError = batch.textError ?? null;
      get("summary").textContent = summaryOf(batch.end);
      if (textError) showTextError();
    }
    fillPage();
    if (finished && items.length <= 3) {
      for (const opener of get("frames").querySelectorAll(".opener")) open(opener, true);
    }
  }

  function summaryOf(end) {
    if (end.bytes === 0) return "No bytes.";
    const errors = items.filter((item) => item.kind === "frame" && item.error !== null).length;
    const objections = items.reduce((sum, item) => sum + (item.objections ?? 0), 0);
    const parts = [counted(end.frames, "frame")];
    if (errors) parts.push(`${errors.toLocaleString("en")} of them not decodable`);
    if (objections) parts.push(counted(objections, "value") + " outside the specification");
    if (end.skipped_bytes) {
      const why = [
        [end.header_errors, "bad header"],
        [end.body_errors, "bad body"],
        [end.incomplete, "frame cut off", "frames cut off"],
      ]
        .filter(([number]) => number !== 0)
        .map(([number, one, many]) =>
          many && number !== 1 ? `${number.toLocaleString("en")} ${many}` : many ? `1 ${one}` : counted(number, one),
        );
      const reasons = why.length ? ` (${why.join(", ")})` : "";
      parts.push(`${counted(end.skipped_bytes, "byte")} in no frame${reasons}`);
    }
    const reading = ["hex text", "raw bytes"].includes(end.reading) ? "" : ` Read as ${end.reading}.`;
    return `${counted(end.bytes, "byte")}: ${parts.join("; ")}.${reading}`;
  }

  // The list

  const itemOf = (opener) => Number(opener.id.slice("item-".length));

  function showPage() {
    get("frames").replaceChildren();
    fillPage();
  }

  /** Appends missing items to the current page. */
  function fillPage() {
    const list = get("frames");
    const first = page * pageSize;
    const end = Math.min(shown.length, first + pageSize);
    const fresh = [];
    for (let i = first + list.children.length; i < end; ++i) fresh.push(listItem(shown[i]));
    list.append(...fresh);
    list.start = first + 1;
    const pages = Math.ceil(shown.length / pageSize);
    get("pages").hidden = pages <= 1;
    get("earlier").disabled = page === 0;
    get("later").disabled = page >= pages - 1;
    if (pages > 1) {
      const range = `${(first + 1).toLocaleString("en")} to ${end.toLocaleString("en")}`;
      get("page-of").textContent = `${range} of ${shown.length.toLocaleString("en")}`;
    }
    get("nothing").hidden = !(finished && shown.length === 0 && items.length !== 0);
  }

  function listItem(index) {
    const item = items[index];
    const opener = heading(item, index);
    const bad = item.kind === "gap" || item.error !== null;
    const content = element("div", { class: "inside", id: `inside-${index}`, hidden: true });
    const head = element("h3", {}, opener);
    const kind = item.kind === "gap" ? "gap" : bad ? "item bad" : "item";
    return element("li", { class: kind }, head, content);
  }

  function open(opener, on) {
    const index = itemOf(opener);
    const content = get(`inside-${index}`);
    opener.setAttribute("aria-expanded", String(on));
    content.hidden = !on;
    if (!on || content.childElementCount !== 0) return;
    const { offset, size } = items[index];
    engine()({ type: "details", job, index, offset, length: size });
  }

  function receiveDetails(answer) {
    const content = get(`inside-${answer.index}`);
    if (content === null || content.childElementCount !== 0) return;
    const item = items[answer.index];
    content.append(...inside(answer, item));
    if (item.kind === "frame") content.append(actions(answer));
    connectParts(content);
  }

  function actions(answer) {
    const bar = element("p", { class: "flow actions" });
    const copy = (label, what) => bar.append(copyButton(label, what, { class: "plain quiet small" }));
    const hex = () => Array.from(answer.bytes, hexByte).join("");
    const way = answer.frame.direction === "from_board" ? "board" : "host";
    copy("Copy as JSON", () => JSON.stringify(answer.frame));
    copy("Copy the bytes", hex);
    copy("Copy a link", () => `${location.href.split("#")[0]}#hex=${hex()}&from=${way}`);
    return bar;
  }

  get("frames").addEventListener("click", (event) => {
    const opener = event.target.closest(".opener");
    if (opener) open(opener, opener.getAttribute("aria-expanded") !== "true");
  });

  function turn(to) {
    page = to;
    showPage();
    get("result-title").scrollIntoView();
    get("frames").querySelector(".opener")?.focus({ preventScroll: true });
  }
  get("earlier").addEventListener("click", () => turn(page - 1));
  get("later").addEventListener("click", () => turn(page + 1));

  get("only-problems").addEventListener("change", ({ target }) => {
    shown = [];
    for (const [i, item] of items.entries()) if (!target.checked || isProblem(item)) shown.push(i);
    page = 0;
    showPage();
  });

  // Problems of the input

  function showProblem(reason) {
    get("problem").hidden = reason === null;
    get("problem-text").textContent = reason ?? "";
    get("problem-show").hidden = true;
    text.removeAttribute("aria-invalid");
  }

  function showTextError() {
    const { reading, line, column, reason } = textError;
    const before = items.length === 0 ? "" : " The bytes before it are decoded below.";
    showProblem(`Read as ${reading}. Line ${line}, column ${column}: ${reason}.${before}`);
    if (held) return;
    text.setAttribute("aria-invalid", "true");
    get("problem-show").hidden = false;
  }

  get("problem-show").addEventListener("click", () => {
    const lines = text.value.split("\n");
    const start = lines.slice(0, textError.line - 1).reduce((sum, line) => sum + line.length + 1, 0);
    // The engine counts bytes; only comments can hold multi-byte characters before the place.
    const at = start + textError.column - 1;
    text.focus();
    text.setSelectionRange(at, at + 1);
  });

  // Sources of input

  function hold(input) {
    held = input;
    get("held").hidden = held === null;
    text.hidden = held !== null;
    if (held === null) return;
    get("held-name").textContent = held.name;
    const size = typeof held.data === "string" ? held.data.length : held.data.byteLength;
    const unit = typeof held.data === "string" ? "character" : "byte";
    const how = held.hex ? "read as text" : "read as raw bytes";
    get("held-about").textContent = `${counted(size, unit)}, ${how}`;
    get("held-kind").hidden = typeof held.data === "string";
    get("held-kind").textContent = held.hex ? "Read as raw bytes" : "Read as text";
  }

  function setText(value, sender) {
    hold(null);
    if (sender) form.elements.from.value = sender;
    if (value.length > largestText) {
      hold({ name: "Pasted text", data: value, hex: true });
    } else {
      text.value = value;
    }
    decode();
  }

  /** True if bytes are text rather than a capture. */
  function isText(bytes) {
    const start = new TextDecoder("latin1").decode(bytes.subarray(0, 4096));
    return !/[\0-\x08\x0e-\x1f\x7f]/.test(start);
  }

  async function openFile(file) {
    try {
      const data = await file.arrayBuffer();
      hold({ name: file.name, data, hex: isText(new Uint8Array(data)) });
      decode();
    } catch (error) {
      showProblem(`The file cannot be read: ${error.message}`);
    }
  }

  text.addEventListener("input", decodeSoon);
  text.addEventListener("paste", (event) => {
    const pasted = event.clipboardData.getData("text");
    if (text.value.length + pasted.length <= largestText) return;
    // A text area takes seconds for input that decodes in one.
    event.preventDefault();
    setText(text.value.slice(0, text.selectionStart) + pasted + text.value.slice(text.selectionEnd));
  });
  for (const radio of form.elements.from) radio.addEventListener("change", decode);
  form.addEventListener("submit", (event) => event.preventDefault());
  for (const id of ["clear", "held-drop"]) {
    get(id).addEventListener("click", () => {
      setText("");
      text.focus();
    });
  }
  get("held-kind").addEventListener("click", () => {
    hold({ ...held, hex: !held.hex });
    decode();
  });
  get("file").addEventListener("change", ({ target }) => {
    if (target.files.length) openFile(target.files[0]);
    target.value = "";
  });
  for (const button of form.querySelectorAll("[data-example]")) {
    button.addEventListener("click", () => setText(button.dataset.example, "auto"));
  }

  const main = document.querySelector("main");
  main.addEventListener("dragover", (event) => {
    if (![...event.dataTransfer.types].includes("Files")) return;
    event.preventDefault();
    form.classList.add("drop");
  });
  main.addEventListener("dragleave", () => form.classList.remove("drop"));
  main.addEventListener("drop", (event) => {
    form.classList.remove("drop");
    if (event.dataTransfer.files.length === 0) return;
    event.preventDefault();
    openFile(event.dataTransfer.files[0]);
  });

  /** decoder.html#hex=3e5600...&from=board */
  function openHash() {
    const given = new URLSearchParams(location.hash.slice(1));
    if (!given.has("hex")) return false;
    const sender = given.get("from");
    setText(given.get("hex"), ["host", "board"].includes(sender) ? sender : "auto");
    return true;
  }
  addEventListener("hashchange", openHash);
  // A browser may restore the previous content of the text area.
  if (!openHash() && text.value !== "") decode();
})();
