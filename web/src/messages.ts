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
}

/** The values of a message, by its name. */
export type DecodedMessage = {
  [Name in keyof AllMessages]: { message: Name; fields: AllMessages[Name] };
}[keyof AllMessages];

/** A frame that does not decode: the message that it would be, or null, and the problem. */
export interface Undecoded {
  message: keyof AllMessages | null;
  fields?: undefined;
  error: { code: string; field: string; offset: number };
  /** The bytes in hex digits. */
  body: string;
}

/** A frame, with `fields` or with an `error`. */
export type Decoded = FrameFacts & ((DecodedMessage & { error?: undefined }) | Undecoded);

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

/** The path of a member or an element. */
const pathOf = (path: string, key: string, isElement: boolean): string =>
  isElement ? `${path}[${key}]` : path === "" ? key : `${path}.${key}`;

/** The paths of a value and all its parts, one a line. */
function pathsIn(value: Json | undefined, path = ""): string {
  if (value === undefined) return "";
  const parts = value !== null && typeof value === "object" ? Object.entries(value) : [];
  const isList = Array.isArray(value);
  const inner = parts.map(([key, part]) => pathsIn(part, pathOf(path, key, isList)));
  return `${path.replaceAll("\n", " ")}\n${inner.join("")}`;
}

/** Puts values in place of defaults. Names for numbers go into `named`: PATH=NAME|NAME. */
function merged(base: Json | undefined, value: Json, path: string, named: string[]): Json {
  if (typeof base === "number" && typeof value !== "number") {
    const names = Array.isArray(value) ? value : [value];
    // Not "30", which would be in the unit of the field.
    if (names.every((name) => typeof name === "string" && /^[a-z]/i.test(name))) {
      named.push(`${path}=${names.join("|").replaceAll("\n", " ") || "0"}`);
      return base;
    }
  }
  if (Array.isArray(value)) {
    const from = Array.isArray(base) ? base : [];
    return value.map((one, index) => merged(from[index], one, pathOf(path, `${index}`, true), named));
  }
  if (value === null || typeof value !== "object") return value;
  const result: { [name: string]: Json } =
    base !== null && typeof base === "object" && !Array.isArray(base) ? { ...base } : {};
  for (const [name, inner] of Object.entries(value)) {
    if (inner === undefined) continue;
    result[name] = merged(result[name], inner, pathOf(path, name, false), named);
  }
  return result;
}

/** Programs without types pass anything. */
function requireOneOf(argument: string, value: unknown, ...allowed: string[]): void {
  if (allowed.some((one) => one === value)) return;
  throw new TypeError(`${argument} is ${allowed.map((one) => `"${one}"`).join(" or ")}`);
}

export class Messages {
  readonly #wasm: Wasm;

  constructor(wasm: Wasm) {
    this.#wasm = wasm;
  }

  /** The names of all messages of a sender. */
  names(direction: Direction): string[] {
    requireOneOf("the direction", direction, "host", "board");
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
    requireOneOf("framing", framing, "basic", "newest");
    const defaults = this.#wasm.text("defaults", `${name}\n${pathsIn(values as Json)}`);
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

  /** Returns the frames in bytes, and skips all other bytes. `from` is the sender. */
  decode(bytes: Uint8Array, from?: Direction): Decoded[] {
    const stream = new FrameStream(this.#wasm, from);
    return [...stream.feed(bytes), ...stream.finish()].map(({ frame }) => frame);
  }

  /** Returns the fields of a message. */
  describe(name: string): FieldForm[] {
    const built = JSON.parse(this.#wasm.text("build", `${String(name).replaceAll("\n", " ")}\n\n`)) as {
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
    if (from !== undefined) requireOneOf("the sender", from, "host", "board");
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
