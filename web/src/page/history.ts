// The last half minute of views, as columns for the charts.

import type { View } from "../worker_messages.js";
import { axisNumbers } from "./axes.js";

export const seconds = 30;
const most = 2000;

export class History {
  readonly times: number[] = [];
  /** Three columns each. */
  readonly camera: number[][] = [[], [], []];
  readonly targets: number[][] = [[], [], []];
  readonly speeds: number[][] = [[], [], []];
  readonly power: number[][] = [[], [], []];

  add(view: View): void {
    const last = this.times.at(-1);
    if (last !== undefined && view.seconds < last) this.#drop(this.times.length); // a new board
    if (view.seconds === last) return;
    this.times.push(view.seconds);
    for (const n of axisNumbers) {
      this.camera[n]?.push(view.camera[n]);
      this.targets[n]?.push(view.targets[n]);
      this.speeds[n]?.push(view.speeds[n]);
      this.power[n]?.push(view.power[n] * 100);
    }
    const old = this.times.findIndex((time) => time >= view.seconds - seconds);
    this.#drop(Math.max(old, this.times.length - most));
  }

  #drop(count: number): void {
    if (count <= 0) return;
    for (const group of [[this.times], this.camera, this.targets, this.speeds, this.power]) {
      for (const column of group) column.splice(0, count);
    }
  }
}
