// The frames of a line, decoded as they pass.

import { FrameStream, type DecodedRows, type Direction } from "./messages.js";
import { hexOf, Wasm } from "./wasm.js";
import type { LoggedFrame } from "./worker_messages.js";

/** More bytes than a frame has. */
const kept = 1024;

/** One direction. Each has its own instance of the module, because it decodes one stream. */
class Way {
  readonly #frames: FrameStream;
  readonly #from: Direction;
  #bytes = new Uint8Array(0);
  #offset = 0; // of these bytes in the stream

  constructor(messages: Wasm, from: Direction) {
    this.#from = from;
    this.#frames = new FrameStream(messages, from);
  }

  feed(bytes: Uint8Array, seconds: number): LoggedFrame[] {
    const all = new Uint8Array(this.#bytes.length + bytes.length);
    all.set(this.#bytes);
    all.set(bytes, this.#bytes.length);
    const frames = this.#frames.feed(bytes).map((one) => this.#logged(one, all, seconds));
    this.#bytes = all.slice(-kept);
    this.#offset += all.length - this.#bytes.length;
    return frames;
  }

  #logged(decoded: DecodedRows, bytes: Uint8Array, seconds: number): LoggedFrame {
    const { frame, rows, size } = decoded;
    const start = frame.offset - this.#offset;
    return {
      seconds,
      from: this.#from,
      command: frame.command ?? String(frame.id),
      message: frame.message ?? "",
      hex: hexOf(bytes.subarray(start, start + size)),
      fields: rows.map(([path, raw, meaning]) => [path, meaning === "" ? raw : meaning]),
      problem: decoded.reason ?? "",
    };
  }
}

export class Log {
  readonly #ways: Record<Direction, Way>;

  private constructor(host: Wasm, board: Wasm) {
    this.#ways = { host: new Way(host, "host"), board: new Way(board, "board") };
  }

  static async make(messages: Wasm): Promise<Log> {
    return new Log(await Wasm.load(messages.module), await Wasm.load(messages.module));
  }

  /** Returns the frames that these bytes complete. */
  feed(from: Direction, bytes: Uint8Array, seconds: number): LoggedFrame[] {
    return this.#ways[from].feed(bytes, seconds);
  }
}
