// Runs the decoder module on one input after the other. This function is the whole worker: the page
// passes its source to the worker, because a page opened from a file may not load a script into one.
// `scope` is the worker's global object or a substitute.
"use strict";

function decoderEngine(scope) {
  // Bytes of input for each call of the module: about 10 ms of work.
  const pieceSize = 4096;
  const batchTime = 60; // ms between two messages to the page

  let wasm = null; // the exports of the module
  let loaded = null; // a promise of them
  let job = 0; // number of the current input; a new input cancels it
  let bytes = new Uint8Array(0); // of the capture, as far as it is read
  let size = 0;
  let items = []; // JSON of each frame, null for a gap

  const read = (pointer, length) => new Uint8Array(wasm.memory.buffer, pointer, length);
  const outputText = () => new TextDecoder().decode(read(wasm.output(), wasm.output_size()));

  function give(input) {
    const pointer = wasm.input(input.length);
    read(pointer, input.length).set(input);
  }

  async function load(base64) {
    const text = atob(base64);
    const code = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) code[i] = text.charCodeAt(i);
    // The C library refers to files; there are none (8: not an open file).
    const noFile = () => 8;
    const files = { fd_close: noFile, fd_seek: noFile, fd_write: noFile };
    const { instance } = await WebAssembly.instantiate(code, { wasi_snapshot_preview1: files });
    wasm = instance.exports;
    wasm._initialize();
  }

  function keep(piece) {
    if (size + piece.length > bytes.length) {
      const larger = new Uint8Array(Math.max(65536, 2 * (size + piece.length)));
      larger.set(bytes.subarray(0, size));
      bytes = larger;
    }
    bytes.set(piece, size);
    size += piece.length;
  }

  // Content of the page's list; the page requests the rest when an item is opened.
  function summary(line) {
    const { frame, rows } = line;
    return {
      kind: "frame",
      offset: frame.offset,
      size: line.size,
      command: frame.command,
      id: frame.id,
      message: frame.message,
      direction: frame.direction,
      isGuess: line.is_guess,
      error: frame.error?.code ?? null,
      objections: rows.filter((row) => row[3] !== "").length,
    };
  }

  // Yields to incoming messages: a new input, or a request for a frame.
  const pause = () =>
    new Promise((resolve) => {
      const channel = new MessageChannel();
      channel.port1.onmessage = () => {
        channel.port1.close();
        resolve();
      };
      channel.port2.postMessage(null);
    });

  async function decode(request) {
    job = request.job;
    await loaded;
    if (job !== request.job) return;
    bytes = new Uint8Array(0);
    size = 0;
    items = [];
    const input =
      typeof request.data === "string"
        ? new TextEncoder().encode(request.data)
        : new Uint8Array(request.data);
    let found = [];
    let known = 0; // everything before is in a frame or a gap
    let sent = Date.now();
    let done = 0;

    const gap = (until) => {
      if (until === known) return;
      found.push({ kind: "gap", offset: known, size: until - known });
      items.push(null);
    };
    const send = (rest) => {
      const progress = input.length === 0 ? 1 : done / input.length;
      scope.postMessage({ type: "batch", job: request.job, items: found, progress, ...rest });
      found = [];
      sent = Date.now();
    };
    const last = {};
    const take = (output) => {
      for (const text of output.split("\n")) {
        if (text === "") continue;
        const line = JSON.parse(text);
        if (line.frame) {
          gap(line.frame.offset);
          found.push(summary(line));
          items.push(text);
          known = line.frame.offset + line.size;
        }
        if (line.text_error) last.textError = line.text_error;
        if (line.end) last.end = line.end;
      }
    };

    wasm.start(["auto", "host", "board"].indexOf(request.from), request.hex);
    while (done < input.length && !last.textError) {
      const piece = input.subarray(done, done + pieceSize);
      give(piece);
      wasm.feed();
      done += piece.length;
      keep(read(wasm.bytes(), wasm.bytes_size()));
      take(outputText());
      if (Date.now() - sent < batchTime) continue;
      send({});
      await pause();
      if (job !== request.job) return;
    }
    wasm.finish();
    keep(read(wasm.bytes(), wasm.bytes_size()));
    take(outputText());
    gap(size);
    done = input.length;
    send(last);
  }

  // Everything about one item of the list.
  function details({ job: of, index, offset, length }) {
    if (of !== job) return;
    const answer = { type: "details", job, index, bytes: bytes.slice(offset, offset + length) };
    if (items[index] !== null) {
      Object.assign(answer, JSON.parse(items[index]));
    } else {
      const limit = 5; // start bytes that are explained
      give(bytes.subarray(offset, Math.min(size, offset + length + wasm.frame_limit())));
      wasm.rejected_candidates(length, limit);
      answer.misses = JSON.parse(outputText());
    }
    scope.postMessage(answer);
  }

  scope.onmessage = async ({ data }) => {
    try {
      if (data.type === "load") {
        loaded = load(data.module);
        await loaded;
        scope.postMessage({ type: "ready" });
      }
      if (data.type === "decode") await decode(data);
      if (data.type === "details") details(data);
      if (data.type === "cancel") job = -1;
    } catch (error) {
      scope.postMessage({ type: "failed", job: data.job, reason: String(error) });
    }
  };
}

if (typeof module !== "undefined") module.exports = { decoderEngine };
