// The connection to a gimbal: its client on one side, a line on the other.

import { sentenceOf } from "./answers.js";
import type { Client, Handlers, LineSettings } from "./client.js";
import type { Direction } from "./messages.js";
import { now, Timer } from "./timer.js";

export const usualLine: LineSettings = { baudRate: 115200, parity: "none" };

export interface LineHandlers {
  received(bytes: Uint8Array): void;
  lost(reason: string): void;
}

/** An open line. */
export interface LineEnd {
  /** Resolves when the bytes are sent, so that a stop never waits behind others. */
  write(bytes: Uint8Array): Promise<void>;
  /** Changes the settings, and discards what has arrived. */
  set(settings: LineSettings): Promise<void>;
  close(): Promise<void>;
}

/** Callbacks of its owner. */
export interface Watcher {
  /** Bytes of the line. */
  observed?(from: Direction, bytes: Uint8Array): void;
  lost?(reason: string): void;
  noticed(text: string): void;
}

export type OpenLine = (settings: LineSettings, handlers: LineHandlers) => Promise<LineEnd>;

export class Connection<Kind extends Client = Client> {
  readonly client: Kind;
  /** Versions of the board, in words, once the line is open and the board has answered. */
  readonly identity: Promise<string>;
  readonly #watcher: Watcher;
  readonly #timer = new Timer(() => this.#advance());
  #line: LineEnd | undefined;
  #settings: LineSettings;
  #wanted: LineSettings | undefined; // that a search tries next
  #isWriting = false;
  #end: string | undefined;

  /** Opens a line, and identifies the board with a client that `connect` makes. */
  constructor(
    connect: (handlers: Handlers) => Kind,
    openLine: OpenLine,
    watcher: Watcher,
    settings = usualLine,
  ) {
    this.#settings = settings;
    this.#watcher = watcher;
    this.client = connect({
      noticed: watcher.noticed,
      lineSet: (wanted) => void (this.#wanted = wanted),
    });
    this.identity = this.#open(openLine);
  }

  async #open(openLine: OpenLine): Promise<string> {
    try {
      this.#line = await openLine(this.#settings, {
        received: (bytes) => {
          this.#watcher.observed?.("board", bytes);
          this.client.receive(bytes, now());
          this.run();
        },
        lost: (reason) => this.#fail(reason),
      });
      this.run();
      return await this.client.identified;
    } catch (error) {
      await this.close();
      throw error;
    }
  }

  get settings(): LineSettings {
    return this.#settings;
  }

  /** Starts a task of the client. */
  begin<Result>(work: (client: Kind) => Promise<Result>): Promise<Result> {
    if (this.#end !== undefined) return Promise.reject(new Error(this.#end));
    const result = work(this.client);
    this.run();
    return result;
  }

  /** Sends what is due, and waits for the rest. */
  run(): void {
    this.#timer.run();
  }

  #advance(): number {
    if (this.#end !== undefined) return Infinity;
    const bytes = this.client.advance(now());
    if (bytes.length > 0) void this.#send(bytes);
    // A client that waits for the line has news when the bytes have left.
    const { deadline } = this.client;
    return this.#isWriting ? Math.max(deadline, now() + 1000) : deadline;
  }

  async #send(bytes: Uint8Array): Promise<void> {
    this.#isWriting = true;
    try {
      const wanted = this.#wanted;
      this.#wanted = undefined;
      if (wanted) await this.#line?.set((this.#settings = wanted));
      this.#watcher.observed?.("host", bytes);
      await this.#line?.write(bytes);
    } catch (error) {
      return this.#fail(sentenceOf(error));
    } finally {
      this.#isWriting = false;
    }
    this.client.written(now());
    this.run();
  }

  #fail(reason: string): void {
    if (this.#end !== undefined) return;
    this.#finish(reason);
    this.#watcher.lost?.(reason);
  }

  #finish(reason: string): void {
    this.#end ??= reason;
    this.#timer.stop();
    this.client.close(reason);
  }

  async close(): Promise<void> {
    this.#finish("the line has been closed");
    await this.#line?.close();
  }
}
