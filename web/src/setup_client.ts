// The client of the module `setup`: parameters, calibrations and tuning beside motion.

import { Client, type Handlers, type OnProgress } from "./client.js";
import type { BoardFacts, Calibration, Plan, Read, Response, Topic, Written } from "./setup_messages.js";
import { settingLines, type Wasm } from "./wasm.js";

const now = (): string => `${new Date().toISOString().slice(0, 19)}Z`;

/** One for each instance of the module. Moves end when the page no longer sends commands. */
export class SetupClient extends Client {
  constructor(setup: Wasm, handlers: Handlers = {}, searches = false) {
    super(setup, handlers, searches);
    this.wasm.call("setup_begin");
  }

  get board(): BoardFacts {
    return this.#json("setup_board", null);
  }

  /** Reads all parameters. */
  read(progressed?: OnProgress): Promise<Read> {
    return this.#task("setup_read", now(), progressed);
  }

  /** The parameters of a profile, from 1. Other work, such as a stop, may come between two topics. */
  async profile(profile: number): Promise<Topic[]> {
    const topics: Topic[] = [];
    for (let number = 0; ; ++number) {
      const topic = this.#json<Topic | null>("setup_topic", null, number, profile);
      if (topic === null) return topics;
      const { parameters } = topic;
      // The module writes a list of names once; elsewhere it names the parameter that has it.
      for (const one of parameters) {
        const { names } = one;
        if (typeof names === "string") one.names = parameters.find(({ name }) => name === names)?.names ?? [];
      }
      if (parameters.length > 0) topics.push(topic);
      await new Promise((resolve) => setTimeout(resolve));
    }
  }

  /** What these values would change: by `message.path`, as people write them, in one profile. */
  plan(values: Record<string, string>, profile: number): Plan {
    return this.#json("setup_plan", settingLines(values), profile);
  }

  /** What a file would change: a backup, or the elementsOf() one of the vendor's program. */
  planFile(text: string, profile: number): Plan {
    return this.#json("setup_plan_file", text, profile);
  }

  /** What would undo the last writing. */
  planUndo(): Plan {
    return this.#json("setup_plan_undo", null);
  }

  /** Writes the last plan, reads back and compares. */
  write(): Promise<Written> {
    return this.#task("setup_write", now());
  }

  /** The text of a backup: of the board, or of the board with the last plan. */
  backup(ofPlan: boolean): string {
    return this.wasm.text("setup_backup", null, Number(ofPlan));
  }

  /** Makes the next undo go back to the parameters that were read last. */
  remember(): void {
    this.wasm.call("setup_remember");
  }

  calibrations(): Calibration[] {
    return this.#json("setup_calibrations", null);
  }

  /** Looks whether the gimbal is as the calibration expects it: "", or what is wrong. */
  check(calibration: string): Promise<string> {
    return this.#task("setup_check", calibration);
  }

  calibrate(name: string, values: Record<string, string>, progressed: OnProgress): Promise<void> {
    return this.#task("setup_calibrate", `${name}\n${settingLines(values)}`, progressed);
  }

  /** Tunes the controllers of some axes. */
  tune(axes: boolean[], gain: number, profile: number, progressed: OnProgress): Promise<void> {
    const bits = axes.reduce((all, isOn, axis) => all + (isOn ? 2 ** axis : 0), 0);
    return this.#task("setup_tune", null, progressed, bits, gain, profile);
  }

  /** Records the response of an axis, 0 roll, 1 pitch, 2 yaw, to noise of these frequencies in hertz. */
  bode(axis: number, gain: number, from: number, to: number, progressed: OnProgress): Promise<Response> {
    return this.#task("setup_bode", null, progressed, axis, gain, from, to);
  }

  /** Ends a calibration's wait, a tuning or a recording as far as the board allows. */
  cancel(): void {
    this.wasm.call("setup_cancel");
  }

  #json<Result>(name: string, input: string | null, ...numbers: number[]): Result {
    return JSON.parse(this.wasm.text(name, input, ...numbers));
  }

  async #task<Result>(
    name: string,
    input: string | null,
    progressed?: OnProgress,
    ...numbers: number[]
  ): Promise<Result> {
    const line = await this.begin((id) => {
      this.wasm.text(name, input, id, ...numbers);
      return "";
    }, progressed);
    return line.result as Result;
  }
}
