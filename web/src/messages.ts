// The messages of the protocol: encoding, decoding, and what they consist of.

import type { AllMessages, Input, Requests } from "./types.js";
import { bytesOf, type Wasm } from "./wasm.js";

export type Direction = "host" | "board";

/** A decoded frame, as `sbgc decode --format jsonl` prints it. */
export interface FrameFacts {
  offset: number;
  command: string | null;
  id: number;
  direction: string | null;
  error?: { code: string; [detail: string]: unknown };
  body?: string;
}

/** The values of a message, by its name. */
export type DecodedMessage = {
  [Name in keyof AllMessages]: { message: Name; fields: AllMessages[Name] };
}[keyof AllMessages];

/** A frame; `message` is null if none fits. */
export type Decoded = FrameFacts & (DecodedMessage | { message: null; fields?: undefined });

/** A frame with human-readable values. */
export interface DecodedRows {
  frame: Decoded;
  size: number;
  /** Path, raw value, meaning, objection, offset, size. */
  rows: [string, string, string, string, number, number][];
  note: string;
  reason?: string;
}

/** A field of a message, as a form shows it; see web/modules/message_form.hpp. */
export interface FieldForm {
  path: string;
  name: string;
  kind: string;
  value?: string;
  unit?: string;
  hint?: string;
  names?: unknown;
  optional?: boolean;
  fields?: FieldForm[];
  parts?: FieldForm[];
}

/** A problem of a value: the path of the field, or "", and a sentence. */
export type Problem = [path: string, sentence: string];

export class ProtocolError extends Error {
  override name = "ProtocolError";
  constructor(readonly problems: Problem[]) {
    super(problems.map(([path, text]) => (path === "" ? text : `${path}: ${text}`)).join("; "));
  }
}

export interface EncodeOptions {
  /** `newest` needs a board that understands it. */
  framing?: "basic" | "newest";
}

type Json = null | boolean | number | string | Json[] | { [name: string]: Json };

/** Puts values in place of defaults. Names for numbers go into `named`: PATH=NAME|NAME. */
function merged(base: Json | undefined, value: Json, path: string, named: string[]): Json {
  if (typeof base === "number" && typeof value !== "number") {
    const names = Array.isArray(value) ? value : [value];
    if (names.every((name) => typeof name === "string")) {
      named.push(`${path}=${names.join("|").replaceAll("\n", " ") || "0"}`);
      return base;
    }
  }
  if (Array.isArray(value)) {
    const from = Array.isArray(base) ? base : [];
    return value.map((one, index) => merged(from[index], one, `${path}[${index}]`, named));
  }
  if (value === null || typeof value !== "object") return value;
  const result: { [name: string]: Json } =
    base !== null && typeof base === "object" && !Array.isArray(base) ? { ...base } : {};
  for (const [name, inner] of Object.entries(value)) {
    if (inner === undefined) continue;
    result[name] = merged(result[name], inner, path === "" ? name : `${path}.${name}`, named);
  }
  return result;
}

export class Messages {
  readonly #wasm: Wasm;

  constructor(wasm: Wasm) {
    this.#wasm = wasm;
  }

  /** The names of all messages of a sender. */
  names(direction: Direction): string[] {
    const sign = direction === "host" ? ">" : "<";
    return this.#wasm
      .text("names", null)
      .split("\n")
      .filter((line) => line.startsWith(sign))
      .map((line) => line.slice(1));
  }

  /**
   * Returns the frame of a message. Numbers are raw values; enums and flags may be names. Missing
   * fields have their defaults. Throws a ProtocolError that names each wrong field.
   */
  encode<Name extends keyof Requests>(
    name: Name,
    values: Input<Requests[Name]> = {} as Input<Requests[Name]>,
    { framing = "basic" }: EncodeOptions = {},
  ): Uint8Array {
    const defaults = this.#wasm.text("defaults", name);
    if (defaults === "") throw new ProtocolError([["", `there is no message '${name}'`]]);
    const named: string[] = [];
    const all = merged(JSON.parse(defaults) as Json, values as Json, "", named);
    const input = [name, framing, ...named, "", JSON.stringify(all)].join("\n");
    const made = JSON.parse(this.#wasm.text("encode", input)) as {
      frame: string;
      problems: Problem[];
    };
    if (made.problems.length > 0) throw new ProtocolError(made.problems);
    return bytesOf(made.frame);
  }

  /** Returns the frames in bytes, and skips all other bytes. */
  decode(bytes: Uint8Array, from?: Direction): Decoded[] {
    const stream = new FrameStream(this.#wasm, from);
    return [...stream.feed(bytes), ...stream.finish()].map(({ frame }) => frame);
  }

  /** Returns the fields of a message. */
  describe(name: string): FieldForm[] {
    const built = JSON.parse(this.#wasm.text("build", `${name.replaceAll("\n", " ")}\n\n`)) as {
      fields: FieldForm[];
      problems: Problem[];
    };
    if (built.fields.length === 0 && built.problems.length > 0) {
      throw new ProtocolError(built.problems);
    }
    return built.fields;
  }
}

/** Decodes a stream of bytes. An instance of the module uses the decoder that was created last. */
export class FrameStream {
  readonly #wasm: Wasm;

  constructor(wasm: Wasm, from?: Direction) {
    this.#wasm = wasm;
    this.#wasm.call("start", from === undefined ? 0 : from === "host" ? 1 : 2, 0);
  }

  /** Returns the frames that these bytes complete. */
  feed(bytes: Uint8Array): DecodedRows[] {
    return this.#frames(new TextDecoder().decode(this.#wasm.bytes("feed", bytes)));
  }

  /** Returns the frames in the remaining bytes. */
  finish(): DecodedRows[] {
    return this.#frames(this.#wasm.text("finish", null));
  }

  #frames(lines: string): DecodedRows[] {
    return lines
      .split("\n")
      .filter((line) => line.startsWith('{"frame":'))
      .map((line) => JSON.parse(line) as DecodedRows);
  }
}
