// The connection to a real gimbal: its client on one side, a port on the other.

import { sentenceOf } from "./answers.js";
import type { LineSettings } from "./client.js";
import * as lines from "./line_ends.js";
import type { Direction } from "./messages.js";
import { SetupClient } from "./setup_client.js";
import type { Place } from "./setup_messages.js";
import type { Wasm } from "./wasm.js";

const usualLine: LineSettings = { baudRate: 115200, parity: "none" };

/** Microseconds of a clock that does not decrease. */
export const now = (): number => Math.floor(performance.now() * 1000);

/** What its owner is told. */
export interface Watcher {
  /** Bytes of the line. */
  observed(from: Direction, bytes: Uint8Array): void;
  lost(reason: string): void;
  noticed(text: string): void;
  /** Called before the board is identified, with what can be closed. */
  begun(made: Connection): void;
}

export class Connection {
  readonly client: SetupClient;
  /** Versions of the board, in words. */
  identity = "";
  readonly #watcher: Watcher;
  readonly #identified: Promise<void>;
  #failed = (_: Error): void => {};
  #end: lines.LineEnd | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #settings: LineSettings;
  #wanted: LineSettings | undefined; // that a search tries next
  #isWriting = false;
  #isOver = false;

  private constructor(setup: Wasm, line: LineSettings | null, watcher: Watcher) {
    this.#settings = line ?? usualLine;
    this.#watcher = watcher;
    let identified = (_: string): void => {};
    this.#identified = new Promise<void>((resolve, reject) => {
      identified = (text) => resolve(void (this.identity = text));
      this.#failed = reject;
    });
    this.#identified.catch(() => {}); // it may fail before it is waited for
    const handlers = {
      identified,
      failed: (text: string) => this.#failed(new Error(text)),
      noticed: watcher.noticed,
      lineSet: (settings: LineSettings) => void (this.#wanted = settings),
    };
    this.client = new SetupClient(setup, handlers, line === null);
  }

  /** Opens a line and identifies the board. Searches for its settings if `line` is null. */
  static async open(
    setup: Wasm,
    place: Place,
    line: LineSettings | null,
    watcher: Watcher,
  ): Promise<Connection> {
    const known = place.kind === "serial" ? line : usualLine; // a bridge knows the settings
    const made = new Connection(setup, known, watcher);
    watcher.begun(made);
    try {
      made.#end = await lines.open(place, made.#settings, {
        received: (bytes) => {
          watcher.observed("board", bytes);
          made.client.receive(bytes, now());
          made.run();
        },
        lost: (reason) => made.#fail(reason),
      });
      made.run();
      await made.#identified;
      return made;
    } catch (error) {
      await made.close();
      throw error;
    }
  }

  get settings(): LineSettings {
    return this.#settings;
  }

  /** Sends what is due, and waits for the rest. */
  run(): void {
    clearTimeout(this.#timer);
    if (this.#isOver) return;
    const bytes = this.client.advance(now());
    if (bytes.length > 0) void this.#send(bytes);
    const due = this.client.deadline;
    if (due === Infinity || this.#isOver) return;
    const ms = Math.min(Math.max(0, (due - now()) / 1000), 60_000);
    // A client that waits for the line has news when the bytes have left.
    this.#timer = setTimeout(() => this.run(), this.#isWriting ? Math.max(ms, 1) : ms);
  }

  async #send(bytes: Uint8Array): Promise<void> {
    this.#isWriting = true;
    try {
      const wanted = this.#wanted;
      this.#wanted = undefined;
      if (wanted) await this.#end?.set((this.#settings = wanted));
      this.#watcher.observed("host", bytes);
      await this.#end?.write(bytes);
    } catch (error) {
      return this.#fail(sentenceOf(error));
    } finally {
      this.#isWriting = false;
    }
    this.client.written(now());
    this.run();
  }

  #fail(reason: string): void {
    if (this.#isOver) return;
    this.#finish(reason);
    this.#watcher.lost(reason);
  }

  #finish(reason: string): void {
    this.#isOver = true;
    clearTimeout(this.#timer);
    this.client.close(reason);
    this.#failed(new Error(reason));
  }

  async close(): Promise<void> {
    this.#finish("the line has been closed");
    await this.#end?.close();
  }
}
