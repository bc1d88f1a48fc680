// The worker of the playground: the emulated gimbal, its client, and the clock.

import { answer, sentenceOf } from "./answers.js";
import { Client } from "./client.js";
import { EmulatedGimbal } from "./line.js";
import type { EmulatorOptions } from "./modules.js";
import { Reports } from "./reports.js";
import { bytesOf, Wasm } from "./wasm.js";
import type { Report, Request } from "./worker_messages.js";

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
    const work = this.#begin(request);
    if ("id" in request) answer(say, request.id, work);
    else work.catch((error: unknown) => say({ kind: "failed", message: sentenceOf(error) }));
  }

  async #begin(request: Request): Promise<object | void> {
    const gimbal = this.#gimbal;
    switch (request.kind) {
      case "start":
        return this.#start(request.options);
      case "change":
        return gimbal?.board.change(request.options, gimbal.now);
      case "pace":
        this.#tick();
        this.#pace = request.factor;
        return this.#mark();
      case "act":
        return gimbal?.client.act(request.action, gimbal.now);
      case "send": {
        const reply = await gimbal?.client.send(bytesOf(request.frame));
        return reply && this.#reports.decoded("board", reply.frame, this.#seconds);
      }
      case "decode":
        return this.#reports.decoded("host", bytesOf(request.frame), this.#seconds);
      case "doctor":
        return { findings: await gimbal?.client.diagnose() };
      case "log":
        return this.#reports.setLog(request.on);
    }
  }

  get #seconds(): number {
    return (this.#gimbal?.now ?? 0) / 1e6;
  }

  #start(options: EmulatorOptions): void {
    this.#gimbal?.client.close("the board has been replaced");
    const client = new Client(this.wasm, { noticed: (text) => say({ kind: "notice", text }) });
    const gimbal = new EmulatedGimbal(this.wasm, options, client, (from, bytes, now) =>
      this.#reports.observe(from, bytes, now / 1e6),
    );
    this.#gimbal = gimbal;
    client.identified.then(
      (text) => say({ kind: "identity", text }),
      (error: unknown) => {
        if (gimbal === this.#gimbal) say({ kind: "failed", message: sentenceOf(error) });
      },
    );
    this.#reports.reset();
    this.#mark();
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
  playground.then((ready) => ready.take(data), () => {});
});

playground.then(
  () => say({ kind: "ready" }),
  (error: unknown) => say({ kind: "failed", message: sentenceOf(error) }),
);
