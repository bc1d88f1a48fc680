// All values of the page, with their limits; a link holds those that are not the usual ones.

import { faultTexts, motions, readFault, type ChosenFaults, type Emulation } from "./emulation.js";

export interface Limits {
  least: number;
  most: number;
  step: number;
  usual: number;
}

const limits = (usual: number, least: number, most: number, step = 1): Limits => ({
  usual,
  least,
  most,
  step,
});

const share = limits(0, 0, 1, 0.0001);

/** Angles in degrees, speeds in degrees a second, shares from 0 to 1. */
export const numbers = {
  roll: limits(0, -45, 45),
  pitch: limits(30, -90, 90),
  yaw: limits(0, -180, 180),
  speed: limits(40, 1, 200),
  "turn-roll": limits(0, -100, 100),
  "turn-pitch": limits(0, -100, 100),
  "turn-yaw": limits(20, -100, 100),
  seconds: limits(3, 0.5, 30, 0.5),
  profile: limits(2, 1, 5),
  seed: limits(1, 0, 0xffffffff),
  strength: limits(1, 0, 10, 0.1),
  bitErrors: share,
  lostBytes: share,
  duplicatedBytes: share,
  delayedBytes: share,
} satisfies Record<string, Limits>;
export type NumberName = keyof typeof numbers;

export interface Values extends Record<NumberName, number> {
  motion: Emulation["motion"];
  faults: ChosenFaults;
  /** A frame to the board, in hex; "": none. */
  send: string;
}

const longestLink = 4096;
const numberNames = Object.keys(numbers) as NumberName[];

export function usualValues(): Values {
  const usual = numberNames.map((name) => [name, numbers[name].usual]);
  return { ...Object.fromEntries(usual), motion: "rest", faults: {}, send: "" } as Values;
}

/** The values of a link, or why it is refused. Nothing of a bad link is used. */
export function readLink(hash: string): Values | string {
  if (hash.length > longestLink) return `it is longer than ${longestLink} characters`;
  const values = usualValues();
  const seen = new Set<string>();
  for (const [key, text] of new URLSearchParams(hash.replace(/^#/, ""))) {
    if (seen.has(key)) return `“${key}” occurs twice`;
    seen.add(key);
    const problem = readValue(values, key, text);
    if (problem) return `“${key}=${text.slice(0, 40)}”: ${problem}`;
  }
  return values;
}

/** Returns what is wrong, or "". */
function readValue(values: Values, key: string, text: string): string {
  if (Object.hasOwn(numbers, key)) {
    const name = key as NumberName;
    const { least, most } = numbers[name];
    const value = Number(text);
    if (!/^-?\d+(\.\d+)?$/.test(text) || value < least || value > most) {
      return `a number from ${least} to ${most} is wanted`;
    }
    values[name] = value;
    return "";
  }
  if (key === "motion") {
    const motion = motions.find(([one]) => one === text);
    if (!motion) return `the motions are ${motions.map(([one]) => one).join(", ")}`;
    [values.motion] = motion;
    return "";
  }
  if (key === "faults") {
    const chosen = text.split(",").map(readFault);
    if (chosen.includes(null)) return "there is no such fault, or it has another value";
    values.faults = Object.fromEntries(chosen as [string, string[]][]);
    return "";
  }
  if (key === "send") {
    if (!/^([0-9a-f]{2})+$/i.test(text)) return "a frame is wanted, in hex";
    values.send = text.toLowerCase();
    return "";
  }
  return "the playground has no such value";
}

export function linkOf(values: Values): string {
  const usual = usualValues();
  const link = new URLSearchParams();
  for (const name of numberNames) {
    if (values[name] !== usual[name]) link.set(name, String(values[name]));
  }
  if (values.motion !== usual.motion) link.set("motion", values.motion);
  const chosen = faultTexts(values.faults);
  if (chosen.length) link.set("faults", chosen.join(","));
  if (values.send) link.set("send", values.send);
  return `#${link}`;
}
