// The three axes: how the page writes their values, and directions in space as a camera sees them.

import type { Axes } from "../worker_messages.js";

export const axisNames = ["roll", "pitch", "yaw"] as const;
export type AxisName = (typeof axisNames)[number];

/** For loops over Axes, whose elements exist. */
export const axisNumbers = [0, 1, 2] as const;

/** The sides to which an axis turns if it is positive and negative. */
export const sides = { roll: ["right", "left"], pitch: ["down", "up"], yaw: ["right", "left"] } as const;

/** Rounded, and never -0. */
export function fixed(value: number, digits = 1): string {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace("-", "") : text;
}

/** "30.0° down"; the side is left out at 0. */
export function angleWords(axis: AxisName, degrees: number): string {
  const size = fixed(Math.abs(degrees));
  return Number(size) === 0 ? `${size}°` : `${size}° ${sides[axis][degrees > 0 ? 0 : 1]}`;
}

/** For the labels of pictures: "roll 0.0°, pitch 30.0° down, yaw 12.0° left". */
export const anglesWords = (angles: Axes): string =>
  axisNumbers.map((n) => `${axisNames[n]} ${angleWords(axisNames[n], angles[n])}`).join(", ");

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
