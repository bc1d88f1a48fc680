// The messages between the page that sets up a real gimbal and its worker, besides worker_messages.ts.
// The worker owns the line, the client, the clock, and an emulated board for trials.

import type { LineSettings, Progress } from "./client.js";
import type * as playground from "./worker_messages.js";
import type { Axes } from "./worker_messages.js";

export type { LineSettings };

/** The end of a line: a port of Web Serial, or the WebSocket of `sbgc bridge`. */
export type Place =
  /** One of navigator.serial.getPorts(); adapters of one kind differ only by their place in it. */
  | { kind: "serial"; index: number; vendor: number | null; product: number | null }
  | { kind: "bridge"; url: string; token: string };

/** The requests of the page by name; `done` has their result. */
export interface Work {
  /** Opens the line, searches for its settings unless they are given, and identifies the board. */
  connect(place: Place, line: LineSettings | null): Connected;
  /** Stops what this page moves, and gives the line back. */
  disconnect(): void;
  /** Begins and ends a recording; returns its bytes, which `sbgc decode` reads. */
  record(on: boolean): Uint8Array<ArrayBuffer> | undefined;
  /** Reads all parameters. */
  read(): Read;
  /** The parameters of a profile, from 1, as they were read. */
  profile(profile: number): Topic[];
  /** What these values would change: by `message.path`, as people write them, in one profile. */
  plan(values: Record<string, string>, profile: number): Plan;
  /** What a file would change: a backup, or the elementsOf() one of the vendor's program. */
  planFile(text: string, profile: number): Plan;
  /** What would undo the last writing. */
  planUndo(): Plan;
  /** Writes the last plan to an emulated board that has the parameters of the real one. */
  tryOut(): Trial;
  /** Writes the last plan, reads back and compares. */
  write(): Written;
  /** The text of a backup. */
  backup(): string;
  calibrations(): Calibration[];
  /** Looks whether the gimbal is as the calibration expects it. */
  check(calibration: string): Check;
  calibrate(calibration: string, values: Record<string, string>): void;
  /** Tunes the controllers; the parameters are read before, for `planUndo`. */
  tune(axes: boolean[], gain: number, profile: number): void;
  /** Records the response of an axis, 0 roll, 1 pitch, 2 yaw, to noise of these frequencies in hertz. */
  bode(axis: number, gain: number, from: number, to: number): Response;
  /** Ends a calibration's wait, a tuning or a recording as far as the board allows. */
  cancel(): void;
}
type Asked<Name extends keyof Work> = { kind: "work"; id: number; name: Name; args: Parameters<Work[Name]> };

/** From the page. The worker answers everything that has an `id` with `done` of the same one. */
export type Request =
  | Extract<playground.Request, { kind: "act" | "doctor" | "log" }>
  | { [Name in keyof Work]: Asked<Name> }[keyof Work]
  /** Whether `act` and `hold` may move the camera; a new connection is not armed. */
  | { kind: "arm"; on: boolean }
  /** Stops the camera, before everything that waits. */
  | { kind: "stop"; id: number }
  /**
   * Turns at these speeds, roll, pitch, yaw in degrees a second, as long as it is repeated: the camera
   * brakes when none has come for 300 ms. All 0: it stops.
   */
  | { kind: "hold"; speeds: Axes };

/** To the page. */
export type Report =
  | Exclude<playground.Report, { kind: "done" | "ready" }>
  /** The worker's VERSION, which build.mjs defines in the page as well. */
  | { kind: "ready"; version: string }
  | { kind: "link"; state: LinkState; text: string }
  /** Motion is locked, although the line is there: the computer has slept. */
  | { kind: "locked"; text: string }
  /** Of a task that takes long. */
  | ({ kind: "progress"; id: number } & Progress)
  | (Extract<playground.Report, { kind: "done" }> & { result?: unknown });

export type LinkState = "closed" | "searching" | "connected" | "lost";

/** The result of `connect`. */
export interface Connected {
  identity: string;
  /** The serial number; "" if the board has none. */
  serialNumber: string;
  /** The settings of a serial line. */
  line: LineSettings | null;
  /** What this board and firmware lack, in sentences. */
  lacks: string[];
}

/** The result of `read`. */
export interface Read {
  /** From 1. */
  active: number;
  profiles: number;
}

/** The result of `profile`: the topics, and the parameters in them. */
export interface Topic {
  name: string;
  summary: string;
  parameters: Parameter[];
}

export interface Parameter {
  /** Message and path, such as ReadParams3.axes.roll.p. */
  name: string;
  path: string;
  summary: string;
  /** As people write it, in the unit. */
  text: string;
  unit: string;
  /** In the unit; null: no limit is known. */
  least: number | null;
  most: number | null;
  /** Of an enum or of flags: name, summary. */
  names: [string, string][];
  kind: "number" | "enum" | "flags" | "text" | "bytes";
  /** The same in all profiles. */
  general: boolean;
  /** The default that the specification states; "" if it states none. */
  default: string;
}

/** The result of `plan`, `planFile` and `planUndo`. */
export interface Plan {
  changes: Change[];
  /** What is wrong with the values: `message.path`, or "", and a sentence. Nothing can be written then. */
  problems: [string, string][];
  /** What of a file is not taken, and what does not fit this board: sentences. */
  remarks: string[];
}

export interface Change {
  name: string;
  /** From 1; 0: all or none. */
  profile: number;
  before: string;
  after: string;
  /** It changes the line to this page, so it is written last. */
  line: boolean;
}

/** The result of `tryOut`: what the emulated board says. */
export interface Trial {
  /** Sentences of the doctor before and with the plan. */
  before: string[];
  after: string[];
}

/** The result of `write`. */
export interface Written {
  ok: boolean;
  /** The outcome, and the state of each block, for people. */
  text: string;
}

/** One of the result of `calibrations`. */
export interface Calibration {
  name: string;
  summary: string;
  /** What to do before: how to hold the camera. */
  preparation: string;
  effects: string;
  /** It needs armed motion. */
  moves: boolean;
  /** Fields that need a value; with names, one of them. */
  values: { path: string; unit: string; summary: string; names: string[] }[];
}

/** The result of `check`: "" if the gimbal is ready. */
export interface Check {
  problem: string;
}

/** The result of `bode`: frequencies in hertz, gain in decibels, phase in degrees. */
export interface Response {
  frequency: number[];
  gain: number[];
  phase: number[];
  /** For the vendor's program, and `sbgc bode`. */
  csv: string;
}
