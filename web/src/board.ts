// An emulated board, as `sbgc emulate` makes it, in the time of its owner.

import type { EmulatorOptions } from "./modules.js";
import { settingLines, type Wasm } from "./wasm.js";

/** A board with a line. Times are microseconds, and do not decrease. */
export class Board {
  readonly #wasm: Wasm;

  /** Turns the board on. Throws an Error that says what is wrong with the options. */
  constructor(gimbal: Wasm, options: EmulatorOptions, now: number) {
    this.#wasm = gimbal;
    this.#set("board_start", options, now);
  }

  #set(name: string, options: EmulatorOptions, now: number): void {
    const problem = this.#wasm.text(name, settingLines(options), now);
    if (problem !== "") throw new Error(problem);
  }

  /** Replaces the motion of the frame, and the faults of board and line. */
  change(options: EmulatorOptions, now: number): void {
    this.#set("board_change", options, now);
  }

  /** Takes bytes of the host. */
  receive(bytes: Uint8Array, now: number): void {
    this.#wasm.bytes("board_receive", bytes, now);
  }

  /** Runs until `now`; returns what has arrived at the host. */
  advance(now: number): Uint8Array {
    return this.#wasm.bytes("board_advance", null, now).slice();
  }

  /** When to call advance() at the latest. */
  get next(): number {
    return this.#wasm.call("board_next");
  }
}
