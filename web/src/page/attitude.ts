// Directions in space as a camera sees them. Yaw turns about the vertical, then roll, then pitch.
// Positive pitch lowers the front, positive yaw turns it right, positive roll lowers the right.

import type { Axes } from "../worker_messages.js";

/** Right, up, forward. */
export type Direction = [number, number, number];

export const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** Returns a function that turns directions of the world into those of the camera. */
export function seenFrom([roll, pitch, yaw]: Axes): (direction: Direction) => Direction {
  const [sinRoll, cosRoll] = [Math.sin(radians(roll)), Math.cos(radians(roll))];
  const [sinPitch, cosPitch] = [Math.sin(radians(pitch)), Math.cos(radians(pitch))];
  const [sinYaw, cosYaw] = [Math.sin(radians(yaw)), Math.cos(radians(yaw))];
  return ([right, up, forward]) => {
    const r1 = right * cosYaw - forward * sinYaw;
    const f1 = right * sinYaw + forward * cosYaw;
    const r2 = r1 * cosRoll - up * sinRoll;
    const u2 = r1 * sinRoll + up * cosRoll;
    return [r2, u2 * cosPitch + f1 * sinPitch, f1 * cosPitch - u2 * sinPitch];
  };
}
