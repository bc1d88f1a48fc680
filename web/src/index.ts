// The npm package: the messages of the protocol, an emulated board, and a client for any line.

import { Board } from "./board.js";
import { Client, type Reply } from "./client.js";
import { Connection, type LineEnd, type LineHandlers } from "./connection.js";
import { Messages, ProtocolError, type Decoded, type Direction, type EncodeOptions } from "./messages.js";
import type { FieldForm } from "./messages.js";
import type { EmulatorOptions, Finding } from "./modules.js";
import { now, Timer } from "./timer.js";
import type { Answers, Input, Requests } from "./types.js";
import { membersOf, Wasm } from "./wasm.js";
import type { View } from "./worker_messages.js";

export { Messages, ProtocolError };
export type * from "./types.js";
export type { Decoded, Direction, EmulatorOptions, EncodeOptions, FieldForm, Finding, Reply, View };

async function read(url: URL): Promise<URL | Uint8Array<ArrayBuffer>> {
  if (url.protocol !== "file:") return url;
  const { readFile } = await import("node:fs/promises");
  return new Uint8Array(await readFile(url));
}

const modules: { gimbal?: Promise<Wasm>; messages?: Promise<Wasm> } = {};

/** A new instance of a module, which is compiled once. */
async function instance(name: "gimbal" | "messages"): Promise<Wasm> {
  const url = new URL(name === "gimbal" ? "./gimbal.wasm" : "./messages.wasm", import.meta.url);
  const first = await (modules[name] ??= read(url).then((source) => Wasm.load(source)));
  return Wasm.load(first.module);
}

let shared: Promise<Messages> | undefined;

/** The messages, for many calls: its functions return at once. */
export function messages(): Promise<Messages> {
  return (shared ??= instance("messages").then((wasm) => new Messages(wasm)));
}

/** Returns the frame of a message; see Messages.encode(). */
export async function encode<Name extends keyof Requests>(
  name: Name,
  values?: Input<Requests[Name]>,
  options?: EncodeOptions,
): Promise<Uint8Array> {
  return (await messages()).encode(name, values, options);
}

/** Returns the frames in bytes, and skips all other bytes. `from` is the sender. */
export async function decode(bytes: Uint8Array, from?: Direction): Promise<Decoded[]> {
  return (await messages()).decode(bytes, from);
}

/** Returns the fields of a message, with units, limits and names. */
export async function describe(name: string): Promise<FieldForm[]> {
  return (await messages()).describe(name);
}

/** A line to a board: a port of Web Serial, or any pair of streams. */
export interface Streams {
  readable: ReadableStream<Uint8Array>;
  writable: WritableStream<Uint8Array>;
}

/** An emulated board in real time, as a line to it. */
export class Emulator implements Streams {
  readonly readable: ReadableStream<Uint8Array>;
  readonly writable: WritableStream<Uint8Array>;
  readonly #board: Board;
  readonly #timer: Timer;
  #arrived: ReadableStreamDefaultController<Uint8Array> | undefined;

  constructor(wasm: Wasm, options: EmulatorOptions) {
    this.#board = new Board(wasm, options, now());
    this.#timer = new Timer(() => this.#advance());
    this.readable = new ReadableStream({
      start: (controller) => void (this.#arrived = controller),
      cancel: () => this.close(),
    });
    this.writable = new WritableStream({
      write: (bytes) => {
        this.#requireOn();
        this.#board.receive(bytes, now());
        this.#timer.run();
      },
    });
    this.#timer.run();
  }

  #advance(): number {
    const bytes = this.#board.advance(now());
    if (bytes.length > 0) this.#arrived?.enqueue(bytes);
    return this.#board.next;
  }

  /** Replaces the motion of the frame, and the faults of board and line. */
  change(options: EmulatorOptions): void {
    this.#requireOn();
    this.#board.change(options, now());
    this.#timer.run();
  }

  /** Turns the board off. */
  close(): void {
    this.#timer.stop();
    this.#arrived = undefined;
  }

  #requireOn(): void {
    if (this.#arrived === undefined) throw new Error("the emulated board is off");
  }
}

/** Turns an emulated board on. Throws an Error that explains invalid options. */
export async function emulator(options: EmulatorOptions = {}): Promise<Emulator> {
  return new Emulator(await instance("gimbal"), options);
}

/** Angles in degrees or speeds in degrees per second; an omitted axis is not controlled. */
export interface AxisValues {
  roll?: number;
  pitch?: number;
  yaw?: number;
}

const settings = (values: object): string =>
  membersOf(values)
    .map(([name, value]) => {
      if (typeof value !== "number") throw new TypeError(`${name}: a number is needed`);
      return ` ${name}=${value}`;
    })
    .join("");

class StreamLine implements LineEnd {
  readonly #reader: ReadableStreamDefaultReader<Uint8Array>;
  readonly #writer: WritableStreamDefaultWriter<Uint8Array>;

  constructor(streams: Streams, handlers: LineHandlers) {
    // A port of Web Serial has none before it is open.
    if (!streams?.readable || !streams.writable) {
      throw new TypeError("the line has no streams; open the port first");
    }
    this.#reader = streams.readable.getReader();
    this.#writer = streams.writable.getWriter();
    void this.#read(handlers);
  }

  async #read({ received, lost }: LineHandlers): Promise<void> {
    try {
      for (;;) {
        const { value, done } = await this.#reader.read();
        if (done) break;
        received(value);
      }
      lost("the line is closed");
    } catch (error) {
      lost(`the line is lost: ${String(error)}`);
    }
  }

  write(bytes: Uint8Array): Promise<void> {
    return this.#writer.write(bytes);
  }

  async set(): Promise<void> {}

  async close(): Promise<void> {
    await this.#reader.cancel().catch(() => {});
    this.#reader.releaseLock();
    // A line that takes no bytes must not keep its owner waiting.
    const wait = new Promise((resolve) => setTimeout(resolve, 500));
    await Promise.race([this.#writer.ready.catch(() => {}), wait]);
    this.#writer.releaseLock();
  }
}

/**
 * A gimbal. Motions resolve when they end. A later motion or a stop ends an earlier one, which then rejects.
 * The camera turns: read the safety guide first.
 */
export class Gimbal {
  /** Called for unsolicited events of the board, such as a restart. */
  onnotice: ((text: string) => void) | undefined;
  /** The board and its firmware. */
  readonly identity: string;
  readonly #connection: Connection;
  readonly #messages: Messages;

  private constructor(connection: Connection, codec: Messages, identity: string) {
    this.identity = identity;
    this.#connection = connection;
    this.#messages = codec;
  }

  /** Connects, and rejects if no board answers. */
  static async open(streams: Streams): Promise<Gimbal> {
    const [wasm, codec] = [await instance("gimbal"), await messages()];
    let gimbal: Gimbal | undefined;
    const connection = new Connection(
      (handlers) => new Client(wasm, handlers),
      async (_, handlers) => new StreamLine(streams, handlers),
      { noticed: (text) => gimbal?.onnotice?.(text) },
    );
    return (gimbal = new Gimbal(connection, codec, await connection.identity));
  }

  /** The last state that the board has reported, or null. */
  get view(): View | null {
    return this.#connection.client.view;
  }

  /** Sends a request, and returns its response; null if there is none except a confirmation. */
  async call<Name extends keyof Answers & keyof Requests>(
    name: Name,
    values?: Input<Requests[Name]>,
  ): Promise<Answers[Name]> {
    const request = this.#messages.encode(name, values);
    const reply = await this.send(request);
    if (reply.kind !== "answered") return null as Answers[Name];
    // The request may select what its response contains.
    const both = this.#messages.decode(new Uint8Array([...request, ...reply.frame])).at(-1);
    const alone = this.#messages.decode(reply.frame, "board")[0];
    const answer = both?.direction === alone?.direction ? both : alone;
    if (!answer?.fields || answer.error) {
      throw new Error(`the response cannot be decoded: ${answer?.error?.code ?? "unknown"}`);
    }
    return { message: answer.message, fields: answer.fields } as unknown as Answers[Name];
  }

  /** Sends the request in a frame. */
  send(frame: Uint8Array): Promise<Reply> {
    return this.#connection.begin((client) => client.send(frame));
  }

  /** Moves the camera to these angles. `speed` is in degrees per second; the parameters have the default. */
  async move(target: AxisValues & { speed?: number }): Promise<void> {
    return this.#act(`move${settings(target)}`);
  }

  /**
   * Turns for `seconds`, 0.5 by default; then the camera brakes. Resolves at once, and does not report
   * whether the camera turns: see `view`. Repeat the call to continue.
   */
  async turn(speeds: AxisValues & { seconds?: number }): Promise<void> {
    return this.#act(`turn${settings(speeds)}`);
  }

  /** Stops the camera. */
  stop(): Promise<void> {
    return this.#act("stop");
  }

  /** Ends serial control: remote control takes over. */
  release(): Promise<void> {
    return this.#act("release");
  }

  motorsOn(): Promise<void> {
    return this.#act("motors on");
  }

  motorsOff(): Promise<void> {
    return this.#act("motors off");
  }

  /** Performs an action of the menu button, such as "PROFILE2". */
  menu(action: string): Promise<void> {
    return this.#act(`menu ${action}`);
  }

  /** Measures the gimbal for five seconds, as `sbgc doctor`. */
  diagnose(): Promise<Finding[]> {
    return this.#connection.begin((client) => client.diagnose());
  }

  /** Ends all calls, and releases the streams. A motion continues: stop it first. */
  close(): Promise<void> {
    return this.#connection.close();
  }

  #act(action: string): Promise<void> {
    return this.#connection.begin((client) => client.act(action, now()));
  }
}

/** Connects to the board at the other end of a line. Rejects if none answers. */
export const connect = (streams: Streams): Promise<Gimbal> => Gimbal.open(streams);
