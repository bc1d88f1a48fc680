// The messages between the page that sets up a real gimbal and its worker, besides worker_messages.ts.
// The worker owns the line, the client, the clock, and an emulated board for trials.

import type { LineSettings, Progress } from "./client.js";
import type { Work } from "./setup_worker.js";
import type * as playground from "./worker_messages.js";
import type { Axes } from "./worker_messages.js";

export type { LineSettings };

/** The end of a line: a port of Web Serial, or the WebSocket of `sbgc bridge`. */
export type Place =
  /** One of navigator.serial.getPorts(); adapters of one kind differ only by their place in it. */
  | { kind: "serial"; index: number; vendor: number | null; product: number | null }
  | { kind: "bridge"; url: string; token: string };

/** From the page. The worker answers everything that has an `id` with `done` of the same one. */
export type Request =
  | Extract<playground.Request, { kind: "act" | "doctor" | "log" }>
  /** `done` has the result. */
  | { kind: "work"; id: number; name: keyof Work; args: unknown[] }
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

/** The identity and features of the board. */
export interface BoardFacts {
  /** The raw value. */
  board: number;
  firmware: number;
  /** "" if the board has none. */
  serialNumber: string;
  /** What this board and firmware lack, in sentences. */
  lacks: string[];
}

/** The result of `connect`. */
export interface Connected extends BoardFacts {
  identity: string;
  /** The settings of a serial line. */
  line: LineSettings | null;
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

/** The result of `bode`: frequencies in hertz, gain in decibels, phase in degrees. */
export interface Response {
  frequency: number[];
  gain: number[];
  phase: number[];
  /** For the vendor's program, and `sbgc bode`. */
  csv: string;
}
