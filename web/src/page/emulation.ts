// Settings of the emulated gimbal: the motions of its frame, and its faults, in the forms of
// `sbgc emulate`.

import type { EmulatorOptions } from "../modules.js";
import { axisNames } from "./axes.js";

export const motions = [
  ["rest", "At rest"],
  ["handheld", "Hand-held"],
  ["drone", "Drone"],
  ["vehicle", "Vehicle"],
] as const;

/** A part of the value of a fault. */
export interface Part {
  usual: string;
  /** For a number; otherwise the part is the name of an axis. */
  limits?: { least: number; most: number; step: number; unit: string };
  /** The suffix of the number in the text of the fault. */
  suffix?: string;
}

export interface Fault {
  name: string;
  label: string;
  parts: Part[];
}

const number = (usual: number, least: number, most: number, unit: string, suffix = ""): Part => ({
  usual: String(usual),
  limits: { least, most, step: usual < 1 ? 0.1 : usual < 100 ? 1 : 100, unit },
  suffix,
});
const axis = (usual: string): Part => ({ usual });

export const faults: readonly Fault[] = [
  { name: "low-battery", label: "Low battery", parts: [number(13.8, 0, 100, "V", "V")] },
  {
    name: "imbalance",
    label: "Imbalance",
    parts: [number(30, -100, 100, "%", "%"), axis("pitch")],
  },
  { name: "overload", label: "Blocked motor", parts: [axis("yaw")] },
  {
    name: "resonance",
    label: "Resonance",
    parts: [number(37, 1, 1000, "Hz", "Hz"), number(2, 0, 1000, "°/s"), axis("pitch")],
  },
  { name: "drift", label: "Gyroscope drifts", parts: [number(2, -100, 100, "°/s")] },
  { name: "i2c-errors", label: "Errors of the I2C bus", parts: [number(20, 0, 10000, "/s")] },
  { name: "line", label: "Errors the board counts", parts: [number(20, 0, 10000, "/s")] },
  { name: "slow-cycle", label: "Slow controller", parts: [number(2000, 1, 60000, "µs", "us")] },
  { name: "imu", label: "No motion sensor", parts: [] },
  { name: "missed-steps", label: "Missed steps", parts: [] },
  { name: "emergency-stop", label: "Emergency stop", parts: [] },
];

/** Shares of the bytes or bits on the line, and what `sbgc emulate` and Python call them. */
export const lineFaults = [
  { key: "bitErrors", label: "Bits flip", option: "bit-errors", argument: "bit_errors" },
  { key: "lostBytes", label: "Bytes are lost", option: "lose", argument: "lost" },
  { key: "duplicatedBytes", label: "Bytes double", option: "duplicate", argument: "duplicated" },
  { key: "delayedBytes", label: "Bytes are late", option: "delay", argument: "delayed" },
] as const;
export type LineFault = (typeof lineFaults)[number]["key"];

/** Parts of the values of the faults that are on, by the names of the faults. */
export type ChosenFaults = Readonly<Record<string, readonly string[]>>;

/** "resonance=37Hz:2:pitch" */
export function faultText(fault: Fault, chosen: readonly string[]): string {
  const parts = fault.parts.map((part, n) => (chosen[n] ?? part.usual) + (part.suffix ?? ""));
  return parts.length ? `${fault.name}=${parts.join(":")}` : fault.name;
}

/** The reverse of faultText(); null if it is no fault, or has no such value. */
export function readFault(text: string): [string, string[]] | null {
  const [name = "", value] = text.split("=", 2);
  const fault = faults.find((one) => one.name === name);
  if (!fault) return null;
  const given = value === undefined ? [] : value.split(":");
  if (given.length > fault.parts.length) return null;
  const parts: string[] = [];
  for (const [n, part] of fault.parts.entries()) {
    const one = given[n] ?? part.usual;
    const bare = part.suffix && one.endsWith(part.suffix) ? one.slice(0, -part.suffix.length) : one;
    if (!isPart(part, bare)) return null;
    parts.push(bare);
  }
  return [name, parts];
}

export function isPart(part: Part, text: string): boolean {
  if (!part.limits) return (axisNames as readonly string[]).includes(text);
  const value = Number(text);
  return (
    /^-?\d+(\.\d+)?$/.test(text) && value >= part.limits.least && value <= part.limits.most
  );
}

export interface Emulation extends Record<LineFault, number> {
  seed: number;
  motion: (typeof motions)[number][0];
  strength: number;
  faults: ChosenFaults;
}

export const faultTexts = (chosen: ChosenFaults): string[] =>
  faults.flatMap((fault) => {
    const parts = chosen[fault.name];
    return parts ? [faultText(fault, parts)] : [];
  });

export function optionsOf(values: Emulation): EmulatorOptions {
  const { seed, motion, strength, bitErrors, lostBytes, duplicatedBytes, delayedBytes } = values;
  const line = { bitErrors, lostBytes, duplicatedBytes, delayedBytes };
  return { seed, motion, strength, ...line, faults: faultTexts(values.faults) };
}
