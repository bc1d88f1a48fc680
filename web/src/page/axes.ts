// The three axes, and how the page writes their values.

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
