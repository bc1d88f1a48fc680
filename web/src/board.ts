// An emulated board like that of `sbgc emulate`, whose time its owner sets.

import type { EmulatorOptions } from "./modules.js";
import { settingLines, type Wasm } from "./wasm.js";

/** A board with a line. Times are microseconds, and do not decrease. */
export class Board {
  readonly #wasm: Wasm;

  /** Turns the board on. Throws an Error that explains invalid options. */
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

  /** Takes bytes from the host. */
  receive(bytes: Uint8Array, now: number): void {
    this.#wasm.bytes("board_receive", bytes, now);
  }

  /** Runs until `now`, and returns the bytes that have arrived at the host. */
  advance(now: number): Uint8Array {
    return this.#wasm.bytes("board_advance", null, now).slice();
  }

  /** The latest time for the next advance(). */
  get next(): number {
    return this.#wasm.call("board_next");
  }
}
