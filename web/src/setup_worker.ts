// The worker of the page that sets up a real gimbal: the line, its client, and what moves the camera.
// Hidden pages sleep, their workers do not, so what is held is stopped here.

import { answer, sentenceOf } from "./answers.js";
import { Capture } from "./capture.js";
import type { LineSettings, OnProgress } from "./client.js";
import { Connection, usualLine } from "./connection.js";
import * as lines from "./line_ends.js";
import type { Direction } from "./messages.js";
import { Reports } from "./reports.js";
import { SetupClient } from "./setup_client.js";
import type { Connected, Place, Report, Request, Trial } from "./setup_messages.js";
import { now } from "./timer.js";
import { tryOut } from "./trial.js";
import { Wasm } from "./wasm.js";
import type { Axes } from "./worker_messages.js";

declare const VERSION: string;

/** A camera that is turned by hand brakes after this time without a command: the client sees to it. */
const holdSeconds = 0.3;
const searchAgainMs = 1000;
const reportMs = 16;
/** A worker that did not run for so long was asleep with its computer. */
const sleepMs = 2000;

const say = (report: Report): void => postMessage(report);
const moves = (action: string): boolean => action !== "stop" && action !== "motors off";

/** What the page asks for by name: the results are in setup_messages.ts. */
export type Work = Workshop["work"] &
  Pick<
    SetupClient,
    "profile" | "plan" | "planFile" | "planUndo" | "write" | "calibrations" | "check" | "cancel"
  >;

type Methods = Record<keyof Work, (...all: unknown[]) => unknown>;

class Workshop {
  #connection: Connection<SetupClient> | null = null;
  #opening: Connection<SetupClient> | null = null;
  #place: Place | null = null;
  #line: LineSettings | null = null;
  #serialNumber = "";
  #hasRead = false; // the page shows parameters
  #isArmed = false;
  #capture: Capture | null = null;
  readonly #reports = new Reports(say);
  #awake = performance.now();
  #release = (): void => {}; // the lock of the port
  /** What is held turns nothing until it is released: somebody has stopped the camera. */
  #isBlocked = false;

  constructor(readonly setup: Wasm) {
    setInterval(() => this.#report(), reportMs);
    addEventListener("message", ({ data }: MessageEvent<Request>) => this.#take(data));
  }

  get #client(): SetupClient {
    if (!this.#connection) throw new Error("no gimbal is connected");
    return this.#connection.client;
  }

  #run(): void {
    this.#connection?.run();
  }

  #take(request: Request): void {
    const work = this.#begin(request);
    if ("id" in request) answer(say, request.id, work);
    this.#run();
  }

  async #begin(request: Request): Promise<object | void> {
    switch (request.kind) {
      case "work": {
        const { id, name, args } = request;
        const owner = (name in this.work ? this.work : this.#client) as unknown as Methods;
        const progressed: OnProgress = (now) => say({ kind: "progress", id, ...now });
        return { result: await owner[name](...args, progressed) };
      }
      case "act":
        if (moves(request.action)) this.#needArmed();
        return this.#client.act(request.action, now());
      case "hold":
        return this.#turn(request.speeds);
      case "doctor":
        return { findings: await this.#client.diagnose() };
      case "log":
        return this.#reports.setLog(request.on);
    }
  }

  readonly work = {
    connect: (place: Place, line: LineSettings | null) => this.#connect(place, line),
    disconnect: () => this.#disconnect(),
    arm: (on: boolean) => void (this.#isArmed = on && this.#connection !== null),
    stop: () => this.#client.act("stop", now()),
    record: (on: boolean) => this.#record(on),
    read: (progressed: OnProgress) => {
      this.#hasRead = true;
      return this.#client.read(progressed);
    },
    tryOut: () => this.#tryOut(),
    backup: () => this.#client.backup(false),
    calibrate: (calibration: string, values: Record<string, string>, progressed: OnProgress) => {
      const one = this.#client.calibrations().find(({ name }) => name === calibration);
      if (one?.moves) this.#needArmed();
      return this.#client.calibrate(calibration, values, progressed);
    },
    tune: (...all: Parameters<SetupClient["tune"]>) => this.#tune(...all),
    bode: (...all: Parameters<SetupClient["bode"]>) => {
      this.#needArmed();
      return this.#client.bode(...all);
    },
  };

  #needArmed(): void {
    if (!this.#isArmed) throw new Error("motion is locked: arm it first");
  }

  #turn(speeds: Axes): void {
    const isStill = speeds.every((speed) => speed === 0);
    if (isStill) this.#isBlocked = false;
    if (!this.#connection || this.#isBlocked || (!this.#isArmed && !isStill)) return;
    const [roll, pitch, yaw] = speeds;
    const turn = `turn roll=${roll} pitch=${pitch} yaw=${yaw} seconds=${holdSeconds}`;
    this.#client.act(isStill ? "stop" : turn, now()).catch((error: unknown) => {
      this.#isBlocked = true;
      say({ kind: "notice", text: sentenceOf(error) });
    });
  }

  /** Opens the line, searches for its settings unless they are given, and identifies the board. */
  async #connect(place: Place, line: LineSettings | null): Promise<Connected> {
    if (this.#connection || this.#opening) throw new Error("a gimbal is connected already");
    await this.#lock(place);
    this.#hasRead = false;
    try {
      return await this.#open(place, line);
    } catch (error) {
      this.#release();
      say({ kind: "link", state: "closed", text: sentenceOf(error) });
      throw error;
    }
  }

  /** A port belongs to one tab. */
  #lock(place: Place): Promise<void> {
    const name = place.kind === "serial" ? `serial ${place.vendor} ${place.product} ${place.index}` : place.url;
    return new Promise((resolve, reject) => {
      void navigator.locks.request(`sbgc ${name}`, { ifAvailable: true }, (lock) => {
        if (!lock) return reject(new Error("another tab of this page holds the port: disconnect there"));
        resolve();
        return new Promise<void>((release) => void (this.#release = release));
      });
    });
  }

  async #open(place: Place, wanted: LineSettings | null): Promise<Connected> {
    say({ kind: "link", state: "searching", text: "looking for the board" });
    const known = place.kind === "serial" ? wanted : usualLine; // a bridge knows the settings
    const opened = new Connection(
      (handlers) => new SetupClient(this.setup, handlers, known === null),
      (settings, handlers) => lines.open(place, settings, handlers),
      {
        observed: (from, bytes) => this.#observe(from, bytes),
        lost: (reason) => opened === this.#connection && void this.#find(reason),
        noticed: (text) => say({ kind: "notice", text }),
      },
      known ?? usualLine,
    );
    this.#opening = opened;
    const identity = await opened.identity.finally(() => (this.#opening = null));
    this.#connection = opened;
    this.#place = place;
    this.#line = opened.settings;
    const { board } = opened.client;
    this.#serialNumber = board.serialNumber;
    say({ kind: "link", state: "connected", text: "connected" });
    const line = place.kind === "serial" ? opened.settings : null;
    return { ...board, identity, line };
  }

  /** A line that was lost is looked for until it is there again; it is not armed then. */
  async #find(reason: string): Promise<void> {
    const place = this.#place;
    const before = this.#serialNumber;
    this.#connection = null;
    this.#isArmed = false;
    say({ kind: "link", state: "lost", text: reason });
    while (place !== null && place === this.#place) {
      await new Promise((resolve) => setTimeout(resolve, searchAgainMs));
      if (place !== this.#place) return;
      try {
        await this.#open(place, this.#line);
      } catch {
        say({ kind: "link", state: "lost", text: reason });
        continue;
      }
      if (this.#hasRead) {
        const read = this.#client.read(); // plans compare with them
        this.#run();
        read.catch(() => {});
      }
      if (this.#serialNumber !== before) say({ kind: "notice", text: "this is another board than before" });
      return;
    }
  }

  /** Stops what this page moves, and gives the line back. */
  async #disconnect(): Promise<void> {
    const connection = this.#connection;
    this.#place = null;
    this.#connection = null;
    if (connection && this.#isArmed) {
      const stopped = connection.client.act("stop", now());
      connection.run();
      await stopped.catch((error: unknown) => say({ kind: "notice", text: sentenceOf(error) }));
    }
    this.#isArmed = false;
    await this.#opening?.close();
    await connection?.close();
    this.#release();
    say({ kind: "link", state: "closed", text: "" });
  }

  /** Begins and ends a recording; returns its bytes, which `sbgc decode` reads. */
  #record(on: boolean): Uint8Array<ArrayBuffer> | undefined {
    const made = this.#capture;
    this.#capture = on ? new Capture(now()) : null;
    return on ? undefined : made?.bytes();
  }

  /** Writes the last plan to an emulated board that has the parameters of the real one. */
  async #tryOut(): Promise<Trial> {
    const client = this.#client;
    const gimbal = await Wasm.load(new URL("./gimbal.wasm", import.meta.url));
    const setup = await Wasm.load(this.setup.module);
    return tryOut({ gimbal, setup }, client.board, client.backup(false), client.backup(true));
  }

  /** The parameters are read before, for `planUndo`. */
  async #tune(...all: Parameters<SetupClient["tune"]>): Promise<void> {
    this.#needArmed();
    const client = this.#client;
    await client.read();
    client.remember();
    const tuned = client.tune(...all);
    this.#run();
    await tuned;
    await client.read();
  }

  #observe(from: Direction, bytes: Uint8Array): void {
    this.#capture?.add(from, bytes, now());
    this.#reports.observe(from, bytes, now() / 1e6);
  }

  /** After a sleep, nobody knows what is held or in the way. */
  #wake(): void {
    const slept = performance.now() - this.#awake;
    this.#awake = performance.now();
    if (slept < sleepMs || !this.#isArmed) return;
    this.#turn([0, 0, 0]);
    this.#isArmed = false;
    say({ kind: "locked", text: "the computer has slept: motion is locked" });
  }

  #report(): void {
    this.#wake();
    this.#reports.send(this.#connection?.client.view ?? null, performance.now());
  }
}

// A message that arrives before the worker listens is lost, so the page waits for `ready`.
Wasm.load(new URL("./setup.wasm", import.meta.url)).then(
  (setup) => {
    new Workshop(setup);
    say({ kind: "ready", version: VERSION });
  },
  (error: unknown) => say({ kind: "failed", message: sentenceOf(error) }),
);
