// The line between a client and an emulated board, in the time of its owner.

import { Board } from "./board.js";
import type { Client } from "./client.js";
import type { EmulatorOptions } from "./modules.js";
import type { Wasm } from "./wasm.js";

/** Called with the bytes of each direction, and their time in microseconds. */
export type Observer = (from: "host" | "board", bytes: Uint8Array, now: number) => void;

const stepUs = 50_000;

/** A client and a board, connected. */
export class EmulatedGimbal {
  readonly board: Board;
  #now = 0;

  constructor(
    gimbal: Wasm,
    options: EmulatorOptions,
    readonly client: Client,
    readonly observe?: Observer,
  ) {
    this.board = new Board(gimbal, options, 0);
  }

  /** The time that it has reached, in microseconds since the board was turned on. */
  get now(): number {
    return this.#now;
  }

  /**
   * Runs everything that is due until `until`, or `goesOn` returns false. Returns false in that case.
   */
  run(until: number, goesOn: () => boolean = () => true): boolean {
    for (;;) {
      this.#step();
      // Within one microsecond, the bytes of each may make the other continue.
      const next = Math.max(Math.min(this.client.deadline, this.board.next), this.#now + 1);
      if (next > until) break;
      if (!goesOn()) return false;
      this.#now = next;
    }
    this.#now = Math.max(this.#now, Math.floor(until));
    return true;
  }

  /** Waits for work while virtual time passes; its owner does other work between two steps. */
  async during<Result>(work: Promise<Result>): Promise<Result> {
    let isOver = false;
    const end = (): void => void (isOver = true);
    work.then(end, end);
    while (!isOver) {
      this.run(this.#now + stepUs);
      await new Promise((resolve) => setTimeout(resolve));
    }
    return work;
  }

  #step(): void {
    const sent = this.client.advance(this.#now);
    if (sent.length > 0) {
      this.observe?.("host", sent, this.#now);
      this.board.receive(sent, this.#now);
      this.client.written(this.#now);
    }
    const arrived = this.board.advance(this.#now);
    if (arrived.length === 0) return;
    this.observe?.("board", arrived, this.#now);
    this.client.receive(arrived, this.#now);
  }
}
