// The worker of the page that sets up a real gimbal: the line, its client, and what moves the camera.
// Hidden pages sleep, their workers do not, so the dead man's switch is here.

import { Capture } from "./capture.js";
import type { LineSettings } from "./client.js";
import * as lines from "./line_ends.js";
import { Log } from "./log.js";
import type { Direction } from "./messages.js";
import { SetupClient } from "./setup_client.js";
import type { Connected, Place, Report, Request } from "./setup_messages.js";
import { tryOut } from "./trial.js";
import { bytesOf, Wasm } from "./wasm.js";
import type { Axes, LoggedFrame } from "./worker_messages.js";

declare const VERSION: string;

const usualLine: LineSettings = { baudRate: 115200, parity: "none" };
/** A camera that is turned by hand brakes after this time without a command. */
const holdSeconds = 0.3;
const searchAgainMs = 1000;
const reportMs = 16;
const mostFrames = 200;
/** A worker that did not run for so long was asleep with its computer. */
const sleepMs = 2000;

const now = (): number => Math.floor(performance.now() * 1000);
const say = (report: Report): void => postMessage(report);
const sentence = (error: unknown): string => (error instanceof Error ? error.message : String(error));
const isStill = (speeds: Axes): boolean => speeds.every((speed) => speed === 0);
const moves = (action: string): boolean => action !== "stop" && action !== "motors off";

/** One connection: the client on one side, the port on the other. */
class Connection {
  readonly client: SetupClient;
  #end: lines.LineEnd | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #settings: LineSettings;
  #wanted: LineSettings | undefined; // that a search tries next
  #isWriting = false;
  #isOver = false;
  /** Versions of the board, in words. */
  identity = "";

  private constructor(
    setup: Wasm,
    line: LineSettings | null,
    ready: () => void,
    readonly failed: (text: string) => void,
    readonly observe: (from: Direction, bytes: Uint8Array) => void,
    readonly lost: (reason: string) => void,
  ) {
    this.#settings = line ?? usualLine;
    const handlers = {
      identified: (text: string) => {
        this.identity = text;
        ready();
      },
      failed,
      noticed: (text: string) => say({ kind: "notice", text }),
      lineSet: (settings: LineSettings) => void (this.#wanted = settings),
    };
    this.client = new SetupClient(setup, handlers, line === null);
  }

  /** Opens a line and identifies the board; calls `begun` before, with what can be closed. */
  static async open(
    setup: Wasm,
    place: Place,
    line: LineSettings | null,
    observe: (from: Direction, bytes: Uint8Array) => void,
    lost: (reason: string) => void,
    begun: (made: Connection) => void,
  ): Promise<Connection> {
    const searched = place.kind === "serial" ? line : usualLine; // a bridge knows the settings
    let fail = (_: Error): void => {};
    let identified = (): void => {};
    const ready = new Promise<void>((resolve, reject) => {
      identified = resolve;
      fail = reject;
    });
    const failed = (text: string): void => fail(new Error(text));
    const made = new Connection(setup, searched, identified, failed, observe, lost);
    begun(made);
    ready.catch(() => {}); // it may fail before it is waited for
    made.#end = await lines.open(place, made.#settings, {
      received: (bytes) => {
        observe("board", bytes);
        made.client.receive(bytes, now());
        made.run();
      },
      lost: (reason) => {
        failed(reason);
        made.#fail(reason);
      },
    });
    made.run();
    await ready.catch(async (error: unknown) => {
      await made.close();
      throw error;
    });
    return made;
  }

  get settings(): LineSettings {
    return this.#settings;
  }

  /** Sends what is due, and waits for the rest. */
  run(): void {
    clearTimeout(this.#timer);
    if (this.#isOver) return;
    const bytes = this.client.advance(now());
    if (bytes.length > 0) void this.#send(bytes);
    const due = this.client.deadline;
    if (due === Infinity || this.#isOver) return;
    const ms = Math.min(Math.max(0, (due - now()) / 1000), 60_000);
    // A client that waits for the line has news when the bytes have left.
    this.#timer = setTimeout(() => this.run(), this.#isWriting ? Math.max(ms, 1) : ms);
  }

  async #send(bytes: Uint8Array): Promise<void> {
    this.#isWriting = true;
    try {
      const wanted = this.#wanted;
      this.#wanted = undefined;
      if (wanted) await this.#end?.set((this.#settings = wanted));
      this.observe("host", bytes);
      await this.#end?.write(bytes);
    } catch (error) {
      return this.#fail(sentence(error));
    } finally {
      this.#isWriting = false;
    }
    this.client.written(now());
    this.run();
  }

  #fail(reason: string): void {
    if (this.#isOver) return;
    this.#isOver = true;
    clearTimeout(this.#timer);
    this.client.close(reason);
    this.lost(reason);
  }

  async close(): Promise<void> {
    this.#isOver = true;
    clearTimeout(this.#timer);
    this.client.close("the line has been closed");
    this.failed("the line has been closed");
    await this.#end?.close();
  }
}

class Workshop {
  #connection: Connection | null = null;
  #opening: Connection | null = null;
  #place: Place | null = null;
  #line: LineSettings | null = null;
  #serialNumber = "";
  #isArmed = false;
  #capture: Capture | null = null;
  #log: Log | null = null;
  #logs = false;
  #frames: LoggedFrame[] = [];
  #lost = 0;
  #lastView = -1;
  #awake = performance.now();
  #release = (): void => {}; // the lock of the port
  #hold: ReturnType<typeof setTimeout> | undefined;
  #messages: Promise<Wasm> | undefined;

  constructor(readonly setup: Wasm) {
    setInterval(() => this.#report(), reportMs);
    addEventListener("message", ({ data }: MessageEvent<Request>) => this.#take(data));
  }

  get #client(): SetupClient {
    if (!this.#connection) throw new Error("no gimbal is connected");
    return this.#connection.client;
  }

  #take(request: Request): void {
    try {
      const work = this.#begin(request);
      if ("id" in request) void this.#answer(request.id, work);
    } catch (error) {
      if ("id" in request) say({ kind: "done", id: request.id, error: sentence(error) });
    }
    this.#connection?.run();
  }

  async #answer(id: number, work: unknown): Promise<void> {
    try {
      say({ kind: "done", id, ...((await work) as object | undefined) });
    } catch (error) {
      say({ kind: "done", id, error: sentence(error) });
    }
  }

  #begin(request: Request): unknown {
    const result = async (work: unknown): Promise<object> => ({ result: await work });
    const progressed = (progress: { share: number | null; text: string }): void =>
      say({ kind: "progress", id: "id" in request ? request.id : 0, ...progress });
    switch (request.kind) {
      case "connect":
        return result(this.#connect(request.place, request.line));
      case "disconnect":
        return this.#disconnect();
      case "arm":
        this.#isArmed = request.on && this.#connection !== null;
        return undefined;
      case "act":
        if (moves(request.action)) this.#needArmed();
        return this.#client.act(request.action, now());
      case "stop":
        clearTimeout(this.#hold);
        return this.#client.act("stop", now());
      case "hold":
        return this.#turn(request.speeds);
      case "send":
        this.#needArmed();
        return this.#client
          .send(bytesOf(request.frame))
          .then((reply) => this.#decoded("board", reply.frame));
      case "decode":
        return this.#decoded("host", bytesOf(request.frame));
      case "doctor":
        return this.#client.diagnose().then((findings) => ({ findings }));
      case "log":
        return this.#setLog(request.on);
      case "record":
        return result(this.#record(request.on));
      case "parameters":
        return result(this.#client.read(progressed));
      case "profile":
        return result(this.#client.profile(request.profile));
      case "plan":
        return result(this.#client.plan(request.values, request.profile));
      case "plan-file":
        return result(this.#client.planFile(request.text, request.profile));
      case "plan-undo":
        return result(this.#client.planUndo());
      case "try":
        return result(this.#try());
      case "write":
        return result(this.#client.write());
      case "backup":
        return result(this.#client.backup(false));
      case "calibrations":
        return result(this.#client.calibrations());
      case "check":
        return result(this.#client.check(request.calibration));
      case "calibrate":
        return result(this.#client.calibrate(request.calibration, request.values, progressed));
      case "tune":
        return this.#tune(request.axes, request.gain, request.profile, progressed);
      case "bode": {
        this.#needArmed();
        const { axis, gain, from, to } = request;
        return result(this.#client.bode(axis, gain, from, to, progressed));
      }
      case "cancel":
        return this.#client.cancel();
    }
  }

  #needArmed(): void {
    if (!this.#isArmed) throw new Error("motion is locked: arm it first");
  }

  #turn(speeds: Axes): void {
    if (!this.#connection || (!this.#isArmed && !isStill(speeds))) return;
    clearTimeout(this.#hold);
    const failed = (error: unknown): void => say({ kind: "notice", text: sentence(error) });
    if (isStill(speeds)) return void this.#client.act("stop", now()).catch(failed);
    const [roll, pitch, yaw] = speeds;
    const turn = `turn roll=${roll} pitch=${pitch} yaw=${yaw} seconds=${holdSeconds}`;
    this.#client.act(turn, now()).catch(failed);
    this.#hold = setTimeout(() => this.#turn([0, 0, 0]), holdSeconds * 1000);
  }

  async #connect(place: Place, line: LineSettings | null): Promise<Connected> {
    if (this.#connection || this.#opening) throw new Error("a gimbal is connected already");
    await this.#lock(place);
    try {
      return await this.#open(place, line);
    } catch (error) {
      this.#release();
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
    let opened: Connection | undefined;
    try {
      opened = await Connection.open(
        this.setup,
        place,
        wanted,
        (from, bytes) => this.#observe(from, bytes),
        (reason) => opened !== undefined && opened === this.#connection && void this.#find(reason),
        (made) => void (this.#opening = made),
      );
    } catch (error) {
      say({ kind: "link", state: "closed", text: sentence(error) });
      throw error;
    } finally {
      this.#opening = null;
    }
    this.#connection = opened;
    this.#place = place;
    this.#line = opened.settings;
    const { serialNumber, lacks } = opened.client.board;
    const { identity, settings } = opened;
    const { baudRate, parity } = settings;
    const line = `${baudRate} baud, ${parity === "none" ? "no parity" : "even parity"}`;
    this.#serialNumber = serialNumber;
    say({ kind: "identity", text: identity });
    say({ kind: "link", state: "connected", text: place.kind === "serial" ? line : place.url });
    return { identity, serialNumber, line: place.kind === "serial" ? settings : null, lacks };
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
      if (this.#serialNumber !== before) say({ kind: "notice", text: "this is another board than before" });
      return;
    }
  }

  async #disconnect(): Promise<void> {
    const connection = this.#connection;
    this.#place = null;
    this.#connection = null;
    clearTimeout(this.#hold);
    if (connection && this.#isArmed) {
      const stopped = connection.client.act("stop", now());
      connection.run();
      await stopped.catch((error: unknown) => say({ kind: "notice", text: sentence(error) }));
    }
    this.#isArmed = false;
    await this.#opening?.close();
    await connection?.close();
    this.#release();
    say({ kind: "link", state: "closed", text: "" });
  }

  #record(on: boolean): Uint8Array | undefined {
    const made = this.#capture;
    this.#capture = on ? new Capture(now()) : null;
    return on ? undefined : made?.bytes();
  }

  async #try(): Promise<unknown> {
    const client = this.#client;
    const gimbal = await Wasm.load(new URL("./gimbal.wasm", import.meta.url));
    const setup = await Wasm.load(this.setup.module);
    return tryOut({ gimbal, setup }, client.board, client.backup(false), client.backup(true));
  }

  async #tune(
    axes: boolean[],
    gain: number,
    profile: number,
    progressed: (progress: { share: number | null; text: string }) => void,
  ): Promise<void> {
    this.#needArmed();
    const client = this.#client;
    await client.read();
    client.remember();
    const tuned = client.tune(axes, gain, profile, progressed);
    this.#connection?.run();
    await tuned;
    await client.read();
  }

  #observe(from: Direction, bytes: Uint8Array): void {
    this.#capture?.add(from, bytes, now());
    if (this.#log === null) return;
    this.#frames.push(...this.#log.feed(from, bytes, now() / 1e6));
    const excess = this.#frames.length - mostFrames;
    if (excess <= 0) return;
    this.#frames.splice(0, excess);
    this.#lost += excess;
  }

  async #setLog(on: boolean): Promise<void> {
    this.#logs = on;
    this.#log = null;
    if (!on) return;
    const log = await Log.make(await this.#loadMessages());
    if (this.#logs) this.#log = log;
  }

  #loadMessages(): Promise<Wasm> {
    return (this.#messages ??= Wasm.load(new URL("./messages.wasm", import.meta.url)));
  }

  async #decoded(from: Direction, bytes: Uint8Array): Promise<{ frames: LoggedFrame[] }> {
    const log = await Log.make(await this.#loadMessages());
    return { frames: log.feed(from, bytes, now() / 1e6) };
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
    const view = this.#connection?.client.view ?? null;
    if (view !== null && view.seconds !== this.#lastView) {
      this.#lastView = view.seconds;
      say({ kind: "view", view });
    }
    if (this.#frames.length === 0) return;
    say({ kind: "log", frames: this.#frames, lost: this.#lost });
    this.#frames = [];
    this.#lost = 0;
  }
}

// What a worker does not listen to when it arrives is lost; the page waits for `ready`.
Wasm.load(new URL("./setup.wasm", import.meta.url)).then(
  (setup) => {
    new Workshop(setup);
    say({ kind: "ready", version: VERSION });
  },
  (error: unknown) => say({ kind: "failed", message: sentence(error) }),
);
