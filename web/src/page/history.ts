// The last half minute of views, as columns for the charts.

import type { View } from "../worker_messages.js";

export const seconds = 30;
const most = 2000;

export class History {
  readonly times: number[] = [];
  /** Of the camera, its targets, its speeds, and the powers of the motors in percent: three columns each. */
  readonly columns: number[][] = Array.from({ length: 12 }, () => []);

  add({ seconds: time, camera, targets, speeds, power }: View): void {
    const last = this.times.at(-1);
    if (last !== undefined && time < last) this.#drop(this.times.length); // a new board
    if (time === last) return;
    this.times.push(time);
    const values = [...camera, ...targets, ...speeds, ...power.map((one) => one * 100)];
    for (const [n, value] of values.entries()) this.columns[n]?.push(value);
    const old = this.times.findIndex((one) => one >= time - seconds);
    this.#drop(Math.max(old, this.times.length - most));
  }

  #drop(count: number): void {
    if (count <= 0) return;
    for (const column of [this.times, ...this.columns]) column.splice(0, count);
  }
}
