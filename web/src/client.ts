// The client of a gimbal, without a line or clock: its owner passes received bytes to it, and sends the bytes
// that it returns.

import type { Finding } from "./modules.js";
import type { Axes, View } from "./worker_messages.js";
import { bytesOf, hexOf, type Wasm } from "./wasm.js";

/** The result of a request. */
export interface Reply {
  /** `unconfirmed`: a confirmation was possible. `sent`: the protocol has none. */
  kind: "answered" | "confirmed" | "unconfirmed" | "sent";
  /** The frame of the answer or confirmation. */
  frame: Uint8Array;
}

/** An event of the client. */
export interface Handlers {
  noticed?(text: string): void;
  /** A search tries these settings; the bytes that advance() returns are for a line that has them. */
  lineSet?(settings: LineSettings): void;
}

export interface LineSettings {
  baudRate: number;
  parity: "none" | "even";
}

/** The progress of a task. `share` is 0 to 1; it is absent if it is not known. */
export interface Progress {
  share?: number;
  text: string;
}

export type OnProgress = (progress: Progress) => void;

/** One line of client_reports(). */
export interface ReportLine {
  notice?: string;
  errors?: string;
  done?: number;
  error?: string;
  identity?: string;
  kind?: Reply["kind"];
  frame?: string;
  findings?: Finding[];
  result?: unknown;
  baud?: number;
  even?: boolean;
  progress?: number;
  of?: Progress;
}

interface Waiting {
  resolve(line: ReportLine): void;
  reject(error: Error): void;
  progressed: OnProgress | undefined;
}

/** Numbers of the view in web/modules/client.hpp: a time, six axes, and five. */
const viewNumbers = 1 + 6 * 3 + 5;

/** Times are microseconds, and do not decrease. */
export class Client {
  /** The versions of the board, in words. */
  readonly identified: Promise<string>;
  protected readonly wasm: Wasm;
  readonly #handlers: Handlers;
  readonly #waiting = new Map<number, Waiting>();
  #lastId = 0;
  #errors: string[] = [];

  /** Asks the board for its identity, and then watches it. `searches`: for the settings of the line first. */
  constructor(gimbal: Wasm, handlers: Handlers = {}, searches = false) {
    this.wasm = gimbal;
    this.#handlers = handlers;
    const started = this.begin((id) => {
      this.wasm.call("client_start", id, Number(searches));
      return "";
    });
    this.identified = started.then(({ identity }) => identity ?? "");
    this.identified.catch(() => {}); // it may fail before somebody waits for it
  }

  /** Takes bytes of the line. */
  receive(bytes: Uint8Array, now: number): void {
    this.wasm.bytes("client_receive", bytes, now);
  }

  /** Returns bytes to send; there are no others until written(). */
  advance(now: number): Uint8Array {
    const bytes = this.wasm.bytes("client_advance", null, now).slice();
    this.#report();
    return bytes;
  }

  written(now: number): void {
    this.wasm.call("client_written", now);
  }

  /** The latest time for the next advance(). */
  get deadline(): number {
    return this.wasm.call("client_deadline");
  }

  /** Carries out an action of web/modules/actions.hpp, such as "move pitch=-30". */
  async act(action: string, now: number): Promise<void> {
    await this.begin((id) => this.wasm.text("client_act", action, id, now));
  }

  /** Sends the request in a frame. */
  async send(frame: Uint8Array): Promise<Reply> {
    const line = await this.begin((id) =>
      new TextDecoder().decode(this.wasm.bytes("client_send", frame, id)),
    );
    return { kind: line.kind ?? "sent", frame: bytesOf(line.frame ?? "") };
  }

  /** Measures the gimbal for five seconds, and judges it. */
  async diagnose(): Promise<Finding[]> {
    const line = await this.begin((id) => {
      this.wasm.call("client_diagnose", id);
      return "";
    });
    return line.findings ?? [];
  }

  /** The last state that the board has reported, or null. */
  get view(): View | null {
    const numbers = this.wasm.numbers(this.wasm.call("client_view"), viewNumbers);
    const at = (index: number) => numbers[index] ?? NaN;
    const axes = (index: number): Axes => [at(index), at(index + 1), at(index + 2)];
    if (at(viewNumbers - 1) === 0) return null;
    return {
      seconds: at(0),
      camera: axes(1),
      targets: axes(4),
      frame: axes(7),
      joints: axes(10),
      speeds: axes(13),
      power: axes(16),
      volts: at(19),
      amperes: at(20),
      motorsOn: at(21) !== 0,
      profile: at(22),
      errors: this.#errors,
    };
  }

  /** Starts a task that reports its end under a number; `start` returns an error text. */
  protected begin(start: (id: number) => string, progressed?: OnProgress): Promise<ReportLine> {
    const id = ++this.#lastId;
    const problem = start(id);
    if (problem !== "") return Promise.reject(new Error(problem));
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject, progressed }));
  }

  /** Ends all pending tasks. */
  close(reason: string): void {
    for (const { reject } of this.#waiting.values()) reject(new Error(reason));
    this.#waiting.clear();
  }

  #report(): void {
    const lines = this.wasm.text("client_reports", null);
    if (lines === "") return;
    for (const text of lines.trimEnd().split("\n")) this.#take(JSON.parse(text) as ReportLine);
  }

  #take(line: ReportLine): void {
    if (line.notice !== undefined) this.#handlers.noticed?.(line.notice);
    if (line.errors !== undefined) this.#errors = line.errors.split("\n").filter((name) => name);
    if (line.baud !== undefined) {
      this.#handlers.lineSet?.({ baudRate: line.baud, parity: line.even ? "even" : "none" });
    }
    if (line.progress !== undefined && line.of) this.#waiting.get(line.progress)?.progressed?.(line.of);
    if (line.done === undefined) return;
    const waiting = this.#waiting.get(line.done);
    this.#waiting.delete(line.done);
    if (line.error === undefined) waiting?.resolve(line);
    else waiting?.reject(new Error(line.error));
  }
}
