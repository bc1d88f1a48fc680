// Calls what is due, in real time.

/** Microseconds of a clock that does not decrease. */
export const now = (): number => Math.floor(performance.now() * 1000);

/** Calls `advance` whenever it is due. */
export class Timer {
  #handle: ReturnType<typeof setTimeout> | undefined;

  constructor(readonly advance: () => number) {}

  /** Calls it at once; it returns when it is due again. */
  run(): void {
    clearTimeout(this.#handle);
    const due = this.advance();
    if (due === Infinity) return;
    const ms = Math.min(Math.max(0, (due - now()) / 1000), 60_000);
    this.#handle = setTimeout(() => this.run(), ms);
  }

  stop(): void {
    clearTimeout(this.#handle);
  }
}
