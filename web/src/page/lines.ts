// The actions that the page asks of the worker, and the lines of code that do the same with your own gimbal.

import type { Axes } from "../worker_messages.js";
import { axisNames, axisNumbers } from "./axes.js";
import { faultTexts, lineFaults, type Emulation } from "./emulation.js";

export const languages = [
  ["command", "Command"],
  ["cpp", "C++"],
  ["python", "Python"],
] as const;
export type Language = (typeof languages)[number][0];

/** "" where there is no such line. */
export type Lines = Record<Language, string>;

export interface Action {
  /** For the worker. */
  text: string;
  lines: Lines;
}

const each = (of: Axes, text: (name: string, value: number) => string, separator: string): string =>
  axisNumbers.map((n) => text(axisNames[n], of[n])).join(separator);
const words = (of: Axes): string => each(of, (name, value) => `${name}=${value}`, " ");
const options = (of: Axes): string => each(of, (name, value) => `--${name} ${value}`, " ");
const members = (of: Axes, unit: string): string =>
  `{${each(of, (name, value) => `.${name} = ${value}_${unit}`, ", ")}}`;
const keywords = (of: Axes): string => each(of, (name, value) => `${name}=${value}`, ", ");

/** The compiler warns if nobody takes the result. */
const taken = (call: string): string => `const auto done = ${call};`;

export const moveTo = (angles: Axes, speed: number): Action => ({
  text: `move ${words(angles)} speed=${speed}`,
  lines: {
    command: `sbgc move ${options(angles)} --speed ${speed} --wait`,
    cpp: taken(`client.move_to(${members(angles, "deg")}, {.speed = ${speed}_deg_per_s})`),
    python: `gimbal.move_to(${keywords(angles)}, speed=${speed})`,
  },
});

export const turn = (speeds: Axes, seconds: number): Action => ({
  text: `turn ${words(speeds)} seconds=${seconds}`,
  lines: {
    command: `sbgc speed ${options(speeds)} --for ${seconds}s`,
    cpp: [
      "sbgc::SpeedControl control(client);",
      `for (int i = 0; i < ${Math.round(seconds * 10)}; ++i) {`,
      `  ${taken(`control.set(${members(speeds, "deg_per_s")})`)}`,
      "  std::this_thread::sleep_for(100ms);",
      "}",
      taken("control.stop()"),
    ].join("\n"),
    python: `gimbal.turn(${keywords(speeds)}, seconds=${seconds})`,
  },
});

const plain = (text: string, command: string, call: string): Action => ({
  text,
  lines: { command, cpp: taken(`client.${call}()`), python: `gimbal.${call}()` },
});
export const stop = plain("stop", "sbgc stop", "stop");
export const release = plain("release", "", "release");
export const motorsOn = plain("motors on", "sbgc motors on", "motors_on");
export const motorsOff = plain("motors off", "sbgc motors off", "motors_off");

export const chooseProfile = (profile: number): Action => ({
  text: `menu profile${profile}`,
  lines: {
    command: `sbgc menu profile${profile}`,
    cpp: taken(
      `client.call(sbgc::msg::ExecuteMenu{.cmd_id = sbgc::msg::MenuCommand::profile${profile}})`,
    ),
    python: `gimbal.call(msg.ExecuteMenu(cmd_id=msg.MenuCommand.MENU_CMD_PROFILE${profile}))`,
  },
});

export const doctorLines: Lines = {
  command: "sbgc doctor",
  cpp: [
    "const auto measured = client.run(sbgc::tasks::measure());",
    "for (const auto& finding : sbgc::doctor::findings_of(*measured)) {",
    "  std::puts(finding.sentence.c_str());",
    "}",
  ].join("\n"),
  python: "",
};

/** The same board for programs on this computer. */
export function emulateLines(emulation: Emulation): Lines {
  const { motion, faults, seed } = emulation;
  const texts = faultTexts(faults);
  const shares = lineFaults.filter(({ key }) => emulation[key] > 0);
  const command = [
    "sbgc emulate --link ./gimbal",
    motion !== "rest" && `--motion ${motion}`,
    texts.length > 0 && `--fault ${texts.join(",")}`,
    ...shares.map(({ key, option }) => `--${option} ${emulation[key]}`),
    seed !== 1 && `--seed ${seed}`,
  ];
  const python = [
    motion !== "rest" && `motion="${motion}"`,
    ...shares.map(({ key, argument }) => `${argument}=${emulation[key]}`),
    seed !== 1 && `seed=${seed}`,
  ];
  return {
    command: command.filter(Boolean).join(" "),
    cpp: "",
    python: texts.length ? "" : `board = sbgc.emulator(${python.filter(Boolean).join(", ")})`,
  };
}
