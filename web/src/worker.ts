// The worker of the playground: the emulated gimbal, its client, and the clock.

import { EmulatedGimbal } from "./line.js";
import { Log } from "./log.js";
import type { Direction } from "./messages.js";
import { bytesOf, Wasm } from "./wasm.js";
import type { LoggedFrame, Report, Request } from "./worker_messages.js";

const tickMs = 8;
/** The longest piece of work between two messages of the page. */
const longestMs = 12;
/** More frames than a page shows at once; those that do not fit are counted. */
const mostFrames = 200;
const reportMs = 16;

const say = (report: Report): void => postMessage(report);

class Playground {
  #pace = 1;
  #gimbal: EmulatedGimbal | null = null;
  #log: Log | null = null;
  #logs = false;
  #frames: LoggedFrame[] = [];
  #lost = 0;
  #startedAt = 0; // virtual time and real time that belong together
  #startedReal = 0;
  #lastView = -1;
  #lastReport = 0;
  #messages: Promise<Wasm> | null = null;

  constructor(
    readonly wasm: Wasm,
    readonly messagesUrl: URL,
  ) {
    setInterval(() => this.#tick(), tickMs);
  }

  take(request: Request): void {
    const gimbal = this.#gimbal;
    switch (request.kind) {
      case "start":
        gimbal?.client.close("the board has been replaced");
        this.#gimbal = new EmulatedGimbal(
          this.wasm,
          request.options,
          {
            identified: (text) => say({ kind: "identity", text }),
            failed: (message) => say({ kind: "failed", message }),
            noticed: (text) => say({ kind: "notice", text }),
          },
          (from, bytes, now) => this.#observe(from, bytes, now),
        );
        this.#lastView = -1;
        this.#mark();
        return;
      case "change":
        gimbal?.board.change(request.options, gimbal.now);
        return;
      case "pace":
        this.#tick();
        this.#pace = request.factor;
        this.#mark();
        return;
      case "act":
        if (gimbal) this.#answer(request.id, gimbal.client.act(request.action, gimbal.now));
        return;
      case "send":
        if (gimbal) this.#answer(request.id, this.#send(gimbal, request.frame));
        return;
      case "decode":
        this.#answer(request.id, this.#decoded("host", bytesOf(request.frame), gimbal?.now ?? 0));
        return;
      case "doctor":
        if (gimbal) {
          const findings = gimbal.client.diagnose();
          this.#answer(request.id, findings.then((found) => ({ findings: found })));
        }
        return;
      case "log":
        this.#logs = request.on;
        if (!this.#logs) return void (this.#log = null);
        void this.#loadMessages()
          .then((messages) => Log.make(messages))
          .then((log) => this.#logs && (this.#log = log))
          .catch((error: unknown) => say({ kind: "failed", message: String(error) }));
    }
  }

  #loadMessages(): Promise<Wasm> {
    return (this.#messages ??= Wasm.load(this.messagesUrl));
  }

  async #send(gimbal: EmulatedGimbal, hex: string): Promise<{ frames: LoggedFrame[] }> {
    const reply = await gimbal.client.send(bytesOf(hex));
    return this.#decoded("board", reply.frame, gimbal.now);
  }

  async #decoded(from: Direction, bytes: Uint8Array, now: number): Promise<{ frames: LoggedFrame[] }> {
    const log = await Log.make(await this.#loadMessages());
    return { frames: log.feed(from, bytes, now / 1e6) };
  }

  /** Answers a request of the page when its work has ended. */
  #answer(id: number, work: Promise<object | void>): void {
    work.then(
      (result) => say({ kind: "done", id, ...result }),
      (error: unknown) =>
        say({ kind: "done", id, error: error instanceof Error ? error.message : String(error) }),
    );
  }

  #observe(from: "host" | "board", bytes: Uint8Array, now: number): void {
    if (this.#log === null) return;
    this.#frames.push(...this.#log.feed(from, bytes, now / 1e6));
    const excess = this.#frames.length - mostFrames;
    if (excess <= 0) return;
    this.#frames.splice(0, excess);
    this.#lost += excess;
  }

  #mark(): void {
    this.#startedReal = performance.now();
    this.#startedAt = this.#gimbal?.now ?? 0;
  }

  #tick(): void {
    const gimbal = this.#gimbal;
    if (gimbal === null || this.#pace === 0) return;
    const begin = performance.now();
    const until = this.#startedAt + (begin - this.#startedReal) * 1000 * this.#pace;
    // A slow machine, or a page that slept, does not catch up.
    if (!gimbal.run(until, () => performance.now() - begin < longestMs)) this.#mark();
    this.#report(gimbal, begin);
  }

  #report(gimbal: EmulatedGimbal, at: number): void {
    if (at - this.#lastReport < reportMs) return;
    this.#lastReport = at;
    const view = gimbal.client.view;
    if (view !== null && view.seconds !== this.#lastView) {
      this.#lastView = view.seconds;
      say({ kind: "view", view });
    }
    if (this.#frames.length === 0) return;
    say({ kind: "log", frames: this.#frames, lost: this.#lost });
    this.#frames = [];
    this.#lost = 0;
  }
}

const playground = Wasm.load(new URL("./gimbal.wasm", import.meta.url)).then(
  (wasm) => new Playground(wasm, new URL("./messages.wasm", import.meta.url)),
);

// At once: what a worker does not listen to when it arrives is lost.
addEventListener("message", ({ data }: MessageEvent<Request>) => {
  playground
    .then((ready) => ready.take(data))
    .catch((error: unknown) => {
      const message = error instanceof Error ? error.message : String(error);
      say("id" in data ? { kind: "done", id: data.id, error: message } : { kind: "failed", message });
    });
});

playground.then(
  () => say({ kind: "ready" }),
  (error: unknown) => say({ kind: "failed", message: String(error) }),
);
