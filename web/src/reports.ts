// The reports that the workers of both pages send by themselves: the state of the gimbal, and decoded frames.

import { sentenceOf } from "./answers.js";
import { Log } from "./log.js";
import type { Direction } from "./messages.js";
import { Wasm } from "./wasm.js";
import type { LoggedFrame, Report, View } from "./worker_messages.js";

/** More frames than a page shows at once; those that do not fit are counted. */
const mostFrames = 200;
const leastMs = 16;

type Say = (report: Extract<Report, { kind: "view" | "log" | "failed" }>) => void;

export class Reports {
  readonly #say: Say;
  #log: Log | null = null;
  #logs = false;
  #frames: LoggedFrame[] = [];
  #lost = 0;
  #lastView = -1;
  #lastTime = 0;
  #messages: Promise<Wasm> | undefined;

  constructor(say: Say) {
    this.#say = say;
  }

  /** Takes bytes of the line, for the log. */
  observe(from: Direction, bytes: Uint8Array, seconds: number): void {
    if (this.#log === null) return;
    this.#frames.push(...this.#log.feed(from, bytes, seconds));
    const excess = this.#frames.length - mostFrames;
    if (excess <= 0) return;
    this.#frames.splice(0, excess);
    this.#lost += excess;
  }

  /** Whether frames are decoded, which loads the module of messages. */
  async setLog(on: boolean): Promise<void> {
    this.#logs = on;
    this.#log = null;
    if (!on) return;
    try {
      const log = await Log.make(await this.#loadMessages());
      if (this.#logs) this.#log = log;
    } catch (error) {
      this.#say({ kind: "failed", message: sentenceOf(error) });
    }
  }

  async decoded(from: Direction, bytes: Uint8Array, seconds: number): Promise<{ frames: LoggedFrame[] }> {
    const log = await Log.make(await this.#loadMessages());
    return { frames: log.feed(from, bytes, seconds) };
  }

  /** Says what is new, as often as a screen shows it. */
  send(view: View | null, atMs: number): void {
    if (atMs - this.#lastTime < leastMs) return;
    this.#lastTime = atMs;
    if (view !== null && view.seconds !== this.#lastView) {
      this.#lastView = view.seconds;
      this.#say({ kind: "view", view });
    }
    if (this.#frames.length === 0) return;
    this.#say({ kind: "log", frames: this.#frames, lost: this.#lost });
    this.#frames = [];
    this.#lost = 0;
  }

  /** Forgets the state, for a new gimbal. */
  reset(): void {
    this.#lastView = -1;
  }

  #loadMessages(): Promise<Wasm> {
    return (this.#messages ??= Wasm.load(new URL("./messages.wasm", import.meta.url)));
  }
}
