// Turns the engine's answers into elements of the page.
"use strict";

const decoderView = (() => {
  const { element } = sbgcPage;
  const root = document.body.dataset.root;
  const messagePages = JSON.parse(document.getElementById("message-pages").textContent);

  /** The place of a field in the reference, or null. */
  function referenceOf(message, path) {
    const known = messagePages[message];
    if (known === undefined || path === "tail") return null;
    // Elements that the model does not distinguish share a place.
    const shared = [path.replace(/\[\d+\]/g, "[]"), path.replace(/\[\d+\]$/, "")];
    const place = shared.find((name) => known.lists.includes(name)) ?? path;
    return `${root}${known.page}#field-${encodeURIComponent(place)}`;
  }

  const counted = (number, thing) =>
    `${number.toLocaleString("en")} ${thing}${number === 1 ? "" : "s"}`;
  const hexByte = (byte) => byte.toString(16).padStart(2, "0");

  /** The path, with optional line breaks. */
  function breakable(path) {
    const parts = path.split(/(?=[.[])/);
    return parts.flatMap((part, i) => (i === 0 ? [part] : [element("wbr"), part]));
  }

  const senders = { from_board: "board to host", to_board: "host to board" };

  /** The closed list entry: a button that opens the item. */
  function heading(item, index) {
    const button = element("button", {
      type: "button",
      class: "opener",
      id: `item-${index}`,
      "aria-expanded": "false",
      "aria-controls": `inside-${index}`,
    });
    const offset = element("span", { class: "at" }, `@${item.offset}`);
    if (item.kind === "gap") {
      const what = `${counted(item.size, "byte")} in no frame`;
      button.append(offset, element("span", { class: "what" }, what));
      return button;
    }
    const name = item.command ?? `Unknown command ${item.id}`;
    const what = element("span", { class: "what" }, element("b", {}, name));
    if (item.message !== null) what.append(" ", element("span", { class: "muted" }, item.message));
    const way = item.direction === "from_board" ? "from-board" : "to-board";
    const tags = element("span", { class: "flow tags" });
    if (item.error !== null) tags.append(element("span", { class: "tag bad" }, "not decodable"));
    if (item.objections !== 0) {
      tags.append(element("span", { class: "tag warn" }, counted(item.objections, "objection")));
    }
    tags.append(element("span", { class: `tag ${way}` }, senders[item.direction] + (item.isGuess ? " (a guess)" : "")));
    tags.append(element("span", { class: "bytes-count" }, counted(item.size, "byte")));
    button.append(offset, what, tags);
    return button;
  }

  /** The bytes, with a color for each part. `parts`: [{at, size, part, tint, name}], in order. */
  function colored(bytes, parts, describedBy) {
    const block = element("p", { class: "bytes", "aria-label": describedBy, role: "group" });
    const run = (from, until, attributes) => {
      if (from >= until) return;
      const text = Array.from(bytes.subarray(from, until), hexByte).join(" ");
      block.append(element("span", attributes, text), " ");
    };
    let at = 0;
    for (const { at: begin, size, part, tint, name } of parts) {
      run(at, begin, { class: "plain-bytes" });
      const attributes = { class: tint, title: name };
      if (part !== null) attributes["data-part"] = part;
      run(begin, begin + size, attributes);
      at = begin + size;
    }
    run(at, bytes.length, { class: "plain-bytes" });
    return block;
  }

  function partsOf(answer) {
    const { size, body, checksum, rows, frame } = answer;
    const parts = [{ at: 0, size: body, part: null, tint: "framing", name: "header" }];
    for (const [i, [path, , , , at, length]] of rows.entries()) {
      if (length !== 0) parts.push({ at, size: length, part: i, tint: `t${i % 8}`, name: path });
    }
    if (frame.error && frame.error.offset < checksum - body) {
      const at = body + frame.error.offset;
      parts.push({ at, size: 1, part: null, tint: "wrong", name: "here" });
    }
    parts.push({ at: checksum, size: size - checksum, part: null, tint: "framing", name: "checksum" });
    return parts;
  }

  function rowsTable(answer) {
    // On narrow screens its rows become blocks; the roles keep it a table for screen readers.
    const head = element("tr", { role: "row" });
    for (const title of ["Byte", "Field", "Raw", "Meaning"]) {
      head.append(element("th", { scope: "col", role: "columnheader", class: title.toLowerCase() }, title));
    }
    const body = element("tbody", { role: "rowgroup" });
    for (const [i, [path, raw, meaning, objection, at, size]] of answer.rows.entries()) {
      const place = size > 1 ? `${at}–${at + size - 1}` : size === 1 ? String(at) : "";
      const swatch = element("span", { class: `swatch t${i % 8}`, "aria-hidden": "true" });
      const reference = referenceOf(answer.frame.message, path);
      const name = breakable(path);
      const named = reference === null ? name : [element("a", { href: reference }, ...name)];
      const field = element("th", { scope: "row", role: "rowheader" }, swatch, ...named);
      const cell = element("td", { role: "cell", class: "meaning" }, meaning);
      if (objection !== "") {
        cell.append(meaning === "" ? "" : " ", element("span", { class: "objection" }, objection));
      }
      const number = element("td", { role: "cell", class: "byte" }, place);
      const value = element("td", { role: "cell", class: "raw" }, raw);
      body.append(element("tr", { role: "row", "data-part": i }, number, field, value, cell));
    }
    const table = element("table", { class: "stacks", role: "table" });
    table.append(element("thead", { role: "rowgroup" }, head), body);
    const region = { class: "table free", tabindex: "0", role: "region", "aria-label": "Fields" };
    return element("div", region, table);
  }

  /** The content of a frame. */
  function insideFrame(answer) {
    const { frame, rows } = answer;
    const result = [colored(answer.bytes, partsOf(answer), "Bytes of the frame")];
    const page = messagePages[frame.message]?.page;
    if (frame.error) {
      const where = frame.error.field === "" ? "" : ` Field: ${frame.error.field}.`;
      const note = element("p", {}, `${answer.reason}${where} Code: ${frame.error.code}, at byte `);
      note.append(`${frame.error.offset} of the body.`);
      result.push(element("div", { class: "note bad" }, note));
    } else if (rows.length === 0) {
      result.push(element("p", { class: "muted" }, "The body has no fields."));
    } else {
      result.push(rowsTable(answer));
    }
    if (answer.note && !frame.error) result.push(element("p", { class: "small" }, `${answer.note}.`));
    if (page) {
      const link = element("a", { href: root + page }, frame.message);
      result.push(element("p", { class: "small" }, "More about ", link));
    }
    return result;
  }

  /** The content of a gap. */
  function insideGap(answer, item) {
    const shown = 512; // bytes
    const list = element("ul", {});
    const parts = [];
    for (const [offset, reason, [wrong, wrongSize], message, rows] of answer.misses) {
      const entry = element("li", {}, `@${item.offset + offset}: ${reason}.`);
      if (rows.length !== 0) {
        const note = element("p", { class: "small" }, "The fields as they came; any of them may be wrong:");
        const table = rowsTable({ rows, frame: { message } });
        for (const row of table.querySelectorAll("[data-part]")) delete row.dataset.part;
        entry.append(element("div", { class: "damaged" }, note, table));
      }
      list.append(entry);
      parts.push({ at: offset, size: 1, part: null, tint: "framing", name: "begin" });
      const at = offset + wrong;
      if (wrongSize !== 0) parts.push({ at, size: wrongSize, part: null, tint: "wrong", name: "wrong" });
    }
    parts.sort((a, b) => a.at - b.at);
    // A start byte may be inside of a candidate, and at the place of its checksum.
    const apart = parts.filter(({ at }, i) => at < shown && (i === 0 || at >= parts[i - 1].at + parts[i - 1].size));
    const result = [colored(answer.bytes.subarray(0, shown), apart, "Bytes in no frame")];
    if (item.size > shown) {
      result.push(element("p", { class: "muted" }, `… and ${counted(item.size - shown, "byte")} more`));
    }
    if (answer.misses.length === 0) {
      result.push(element("p", {}, "They contain no start byte (3e)."));
    } else {
      result.push(list);
    }
    return result;
  }

  function inside(answer, item) {
    return item.kind === "gap" ? insideGap(answer, item) : insideFrame(answer);
  }

  return { counted, heading, inside, hexByte };
})();
