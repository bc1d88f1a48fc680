// The worker of the playground: the emulated gimbal, its client, and the clock.

import { EmulatedGimbal } from "./line.js";
import { Reports, sentenceOf } from "./reports.js";
import { bytesOf, Wasm } from "./wasm.js";
import type { LoggedFrame, Report, Request } from "./worker_messages.js";

const tickMs = 8;
/** The longest piece of work between two messages of the page. */
const longestMs = 12;

const say = (report: Report): void => postMessage(report);

class Playground {
  #pace = 1;
  #gimbal: EmulatedGimbal | null = null;
  readonly #reports = new Reports(say);
  #startedAt = 0; // virtual time and real time that belong together
  #startedReal = 0;

  constructor(readonly wasm: Wasm) {
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
          (from, bytes, now) => this.#reports.observe(from, bytes, now / 1e6),
        );
        this.#reports.reset();
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
      case "decode": {
        const seconds = (gimbal?.now ?? 0) / 1e6;
        this.#answer(request.id, this.#reports.decoded("host", bytesOf(request.frame), seconds));
        return;
      }
      case "doctor":
        if (gimbal) {
          const findings = gimbal.client.diagnose();
          this.#answer(request.id, findings.then((found) => ({ findings: found })));
        }
        return;
      case "log":
        void this.#reports.setLog(request.on);
    }
  }

  async #send(gimbal: EmulatedGimbal, hex: string): Promise<{ frames: LoggedFrame[] }> {
    const reply = await gimbal.client.send(bytesOf(hex));
    return this.#reports.decoded("board", reply.frame, gimbal.now / 1e6);
  }

  /** Answers a request of the page when its work has ended. */
  #answer(id: number, work: Promise<object | void>): void {
    work.then(
      (result) => say({ kind: "done", id, ...result }),
      (error: unknown) =>
        say({ kind: "done", id, error: sentenceOf(error) }),
    );
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
    this.#reports.send(gimbal.client.view, begin);
  }
}

const playground = Wasm.load(new URL("./gimbal.wasm", import.meta.url)).then(
  (wasm) => new Playground(wasm),
);

// At once: what a worker does not listen to when it arrives is lost.
addEventListener("message", ({ data }: MessageEvent<Request>) => {
  playground
    .then((ready) => ready.take(data))
    .catch((error: unknown) => {
      const message = sentenceOf(error);
      say("id" in data ? { kind: "done", id: data.id, error: message } : { kind: "failed", message });
    });
});

playground.then(
  () => say({ kind: "ready" }),
  (error: unknown) => say({ kind: "failed", message: String(error) }),
);
