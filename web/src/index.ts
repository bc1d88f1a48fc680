// The npm package: the messages of the protocol, an emulated board, and a client for any line.

import { Board } from "./board.js";
import { Client, type Reply } from "./client.js";
import { Messages, ProtocolError, type Decoded, type Direction, type EncodeOptions } from "./messages.js";
import type { FieldForm } from "./messages.js";
import type { EmulatorOptions, Finding } from "./modules.js";
import type { Answers, Input, Requests } from "./types.js";
import { Wasm } from "./wasm.js";
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

/** Returns the frames in bytes; what is no frame is skipped. */
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

const now = (): number => Math.floor(performance.now() * 1000);

/** Calls `advance` whenever it is due. */
class Timer {
  #handle: ReturnType<typeof setTimeout> | undefined;

  constructor(readonly advance: () => number) {}

  /** Calls it at once; it returns when it is due again. */
  run(): void {
    clearTimeout(this.#handle);
    const due = this.advance();
    if (due === Infinity) return;
    const ms = Math.min(Math.max(0, (due - now()) / 1000), 60_000);
    this.#handle = setTimeout(() => this.run(), ms);
  }

  stop(): void {
    clearTimeout(this.#handle);
  }
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
    this.#board.change(options, now());
    this.#timer.run();
  }

  /** Turns the board off. */
  close(): void {
    this.#timer.stop();
    this.#arrived = undefined;
  }
}

/** Turns an emulated board on. Throws an Error that says what is wrong with the options. */
export async function emulator(options: EmulatorOptions = {}): Promise<Emulator> {
  return new Emulator(await instance("gimbal"), options);
}

/** Angles in degrees, speeds in degrees a second; an axis that is missing is left alone. */
export interface AxisValues {
  roll?: number;
  pitch?: number;
  yaw?: number;
}

const settings = (values: object): string =>
  Object.entries(values)
    .filter(([, value]) => value !== undefined)
    .map(([name, value]) => ` ${name}=${Number(value)}`)
    .join("");

/**
 * A gimbal. Motions resolve when they have ended: a later one, or a stop, ends an earlier one, which then
 * rejects. The camera turns; read the guide to safety first.
 */
export class Gimbal {
  /** Called with what the board says unasked, such as a restart. */
  onnotice: ((text: string) => void) | undefined;
  /** The board and its firmware. */
  identity = "";
  readonly #client: Client;
  readonly #messages: Messages;
  readonly #reader: ReadableStreamDefaultReader<Uint8Array>;
  readonly #writer: WritableStreamDefaultWriter<Uint8Array>;
  readonly #timer: Timer;
  #end: string | undefined;
  readonly #ended: (reason: string) => void;

  private constructor(
    wasm: Wasm,
    codec: Messages,
    streams: Streams,
    ready: () => void,
    failed: (message: string) => void,
  ) {
    this.#messages = codec;
    this.#reader = streams.readable.getReader();
    this.#writer = streams.writable.getWriter();
    this.#ended = failed;
    this.#client = new Client(wasm, {
      identified: (text) => {
        this.identity = text;
        ready();
      },
      failed,
      noticed: (text) => this.onnotice?.(text),
    });
    this.#timer = new Timer(() => this.#advance());
    void this.#listen();
    this.#timer.run();
  }

  /** Connects, and rejects if no board answers. */
  static async open(streams: Streams): Promise<Gimbal> {
    const [wasm, codec] = [await instance("gimbal"), await messages()];
    let gimbal: Gimbal | undefined;
    try {
      await new Promise<void>((resolve, reject) => {
        gimbal = new Gimbal(wasm, codec, streams, resolve, (text) => reject(new Error(text)));
      });
    } catch (error) {
      await gimbal?.close();
      throw error;
    }
    return gimbal as unknown as Gimbal;
  }

  /** The last state that the board has reported; null before. */
  get view(): View | null {
    return this.#client.view;
  }

  /** Sends a request; returns its answer, null for a confirmation or if there is none. */
  async call<Name extends keyof Answers & keyof Requests>(
    name: Name,
    values?: Input<Requests[Name]>,
  ): Promise<Answers[Name]> {
    const reply = await this.send(this.#messages.encode(name, values));
    if (reply.kind !== "answered") return null as Answers[Name];
    const [answer] = this.#messages.decode(reply.frame, "board");
    return { message: answer?.message, fields: answer?.fields } as unknown as Answers[Name];
  }

  /** Sends the request in a frame. */
  send(frame: Uint8Array): Promise<Reply> {
    return this.#run(() => this.#client.send(frame));
  }

  /** Moves the camera to these angles. `speed` in degrees a second: that of the parameters by default. */
  move(target: AxisValues & { speed?: number }): Promise<void> {
    return this.#act(`move${settings(target)}`);
  }

  /**
   * Turns for `seconds`, 0.5 by default; then the camera brakes. Resolves when the motion has begun:
   * repeat it to go on.
   */
  turn(speeds: AxisValues & { seconds?: number }): Promise<void> {
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
    return this.#run(() => this.#client.diagnose());
  }

  /** Ends all calls, and gives the streams back. What moves goes on: stop it before. */
  async close(): Promise<void> {
    this.#fail("the client is closed");
    await this.#reader.cancel().catch(() => {});
    this.#reader.releaseLock();
    await this.#writer.ready.catch(() => {});
    this.#writer.releaseLock();
  }

  #act(action: string): Promise<void> {
    return this.#run(() => this.#client.act(action, now()));
  }

  #run<Result>(begin: () => Promise<Result>): Promise<Result> {
    if (this.#end !== undefined) return Promise.reject(new Error(this.#end));
    const result = begin();
    this.#timer.run();
    return result;
  }

  #fail(reason: string): void {
    this.#end ??= reason;
    this.#timer.stop();
    this.#client.close(reason);
    this.#ended(reason);
  }

  #advance(): number {
    if (this.#end !== undefined) return Infinity;
    const bytes = this.#client.advance(now());
    if (bytes.length > 0) {
      this.#writer.write(bytes).then(
        () => {
          this.#client.written(now());
          this.#timer.run();
        },
        (error: unknown) => this.#fail(`the line is lost: ${String(error)}`),
      );
    }
    return this.#client.deadline;
  }

  async #listen(): Promise<void> {
    try {
      for (;;) {
        const { value, done } = await this.#reader.read();
        if (done) break;
        this.#client.receive(value, now());
        this.#timer.run();
      }
      this.#fail("the line is closed");
    } catch (error) {
      this.#fail(`the line is lost: ${String(error)}`);
    }
  }
}

/** Connects to the board at the other end of a line. Rejects if none answers. */
export const connect = (streams: Streams): Promise<Gimbal> => Gimbal.open(streams);
