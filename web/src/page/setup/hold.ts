// Turning as long as something is held: keys, a pointer, a gamepad with a shoulder button.

import type { Axes } from "../../worker_messages.js";
import { axisNumbers } from "../axes.js";

/** The worker brakes when nothing has come for 300 ms. */
export const period = 50;
const deadZone = 0.12;
/** The shoulder buttons of the standard layout: one of them must be held. */
const shoulders = [4, 5];

/** Beyond the dead zone, from 0 to 1. */
const past = (tilt: number): number =>
  Math.sign(tilt) * Math.max(0, (Math.abs(tilt) - deadZone) / (1 - deadZone));

/** A gamepad whose dead-man button is held, or undefined. */
const heldPad = (): Gamepad | undefined =>
  navigator
    .getGamepads?.()
    .find((one) => one && shoulders.some((button) => one.buttons[button]?.pressed)) ?? undefined;

export class Hold {
  /** The fastest turn, in degrees a second. */
  limit = 0;
  readonly #send: (speeds: Axes) => void;
  readonly #held = new Map<string, Axes>();
  #isMoving = false;
  /** After a stop, what is still held turns nothing. */
  #isBlocked = false;

  constructor(send: (speeds: Axes) => void) {
    this.#send = send;
  }

  /** `what` is held from now on; the direction has a share of the limit for each axis. */
  press(what: string, direction: Axes): void {
    this.#held.set(what, direction);
    this.tick();
  }

  release(what: string): void {
    if (this.#held.delete(what)) this.tick();
  }

  /** Nothing counts as held any more; `isStopped`: somebody else has stopped the camera. */
  releaseAll(isStopped = false): void {
    this.#held.clear();
    this.#isBlocked = true;
    if (isStopped) this.#isMoving = false;
    this.tick();
  }

  /** Sends what is held; called every period. */
  tick(): void {
    const pad = heldPad();
    if (!pad && this.#held.size === 0) this.#isBlocked = false;
    const speeds: Axes = [0, 0, 0];
    if (!this.#isBlocked) {
      const [yaw = 0, pitch = 0, roll = 0] = (pad?.axes ?? []).map(past);
      for (const direction of [[roll, pitch, yaw] as Axes, ...this.#held.values()]) {
        for (const n of axisNumbers) speeds[n] += direction[n];
      }
      for (const n of axisNumbers) speeds[n] = Math.max(-1, Math.min(1, speeds[n])) * this.limit;
    }
    const moves = speeds.some((speed) => speed !== 0);
    if (moves || this.#isMoving) this.#send(speeds);
    this.#isMoving = moves;
  }
}
