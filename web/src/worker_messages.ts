// The messages between the playground's page and its worker. The worker owns the emulated board, the
// client and the clock; nothing here knows the protocol.

import type { EmulatorOptions, Finding } from "./modules.js";

/** From the page. The worker answers `act`, `send`, `decode` and `doctor` with `done` of the same `id`. */
export type Request =
  /** Turns a board on, and connects to it. Repeated: a new board. */
  | { kind: "start"; options: EmulatorOptions }
  /** Changes the motion of the frame, and the faults of board and line, while the board runs. */
  | { kind: "change"; options: EmulatorOptions }
  /** Virtual seconds for each second; 0 is a pause. */
  | { kind: "pace"; factor: number }
  /** An action, such as "move pitch=-30 yaw=20 speed=40"; see web/modules/actions.hpp. */
  | { kind: "act"; id: number; action: string }
  /** A request as a frame in hex, which the frame builder has made. */
  | { kind: "send"; id: number; frame: string }
  /** Decodes such a frame, and sends nothing: `done` has it as a frame of the host. */
  | { kind: "decode"; id: number; frame: string }
  /** Measures for some seconds and judges. */
  | { kind: "doctor"; id: number }
  /** Whether frames are decoded and reported, which loads the module of messages. */
  | { kind: "log"; on: boolean };

/** To the page. */
export type Report =
  | { kind: "ready" }
  /** The module could not be loaded, or the board could not start. */
  | { kind: "failed"; message: string }
  | { kind: "identity"; text: string }
  /** At most 60 times a second, while something runs. */
  | { kind: "view"; view: View }
  | { kind: "log"; frames: LoggedFrame[]; lost: number }
  | { kind: "done"; id: number; error?: string; frames?: LoggedFrame[]; findings?: Finding[] }
  /** What the board says unasked, and what the client notices. */
  | { kind: "notice"; text: string };

/** Roll, pitch, yaw. */
export type Axes = [number, number, number];

/** The state of the gimbal as the board reports it. Angles in degrees, speeds in degrees a second;
 * positive pitch lowers the front, positive yaw turns it to the right, positive roll lowers the right. */
export interface View {
  seconds: number;
  camera: Axes;
  targets: Axes;
  frame: Axes;
  joints: Axes;
  speeds: Axes;
  /** 0 to 1. */
  power: Axes;
  volts: number;
  amperes: number;
  motorsOn: boolean;
  /** From 1. */
  profile: number;
  /** Names of the errors that the board reports. */
  errors: string[];
}

export interface LoggedFrame {
  seconds: number;
  from: "host" | "board";
  /** Of the command, such as CMD_CONTROL; its id if it is unknown. */
  command: string;
  /** Of the message, whose page is in the reference; "" if it is unknown. */
  message: string;
  hex: string;
  /** Path, value with its unit. */
  fields: [string, string][];
  /** Why it could not be decoded. */
  problem: string;
}
