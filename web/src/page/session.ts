// The page's side of the worker.

import { createContext } from "preact";
import { useContext, useEffect, useRef, useState } from "preact/hooks";

import { sentenceOf } from "../answers.js";
import type { OnProgress, Progress } from "../client.js";
import type * as setup from "../setup_messages.js";
import type * as playground from "../worker_messages.js";
import type { View } from "../worker_messages.js";
import type { Action, Language } from "./lines.js";

/** Reports that a page may get; each worker sends some of them. */
export type Report = playground.Report | setup.Report;
type Request = playground.Request | setup.Request;
export type Done = Extract<Report, { kind: "done" }>;
/** A request that the worker answers, without its number. */
type Question<R = Request> = R extends { id: number } ? Omit<R, "id"> : never;

interface Pending {
  resolve(done: Done): void;
  reject(error: Error): void;
  progress?: OnProgress | undefined;
}

/** Requests of both pages to a gimbal, emulated or real. */
export class Session {
  /** The newest one. */
  view: View | null = null;
  readonly #worker: Worker;
  readonly #pending = new Map<number, Pending>();
  readonly #listeners = new Set<(report: Report) => void>();
  #last = 0;

  constructor(worker: Worker) {
    this.#worker = worker;
    worker.addEventListener("message", (event: MessageEvent<Report>) => this.#take(event.data));
    worker.addEventListener("error", (event) =>
      this.#take({ kind: "failed", message: event.message || "the worker could not be loaded" }),
    );
  }

  /** Rejects with the error that the worker reports. */
  ask(question: Question, progress?: OnProgress): Promise<Done> {
    const id = ++this.#last;
    return new Promise((resolve, reject) => {
      this.#pending.set(id, { resolve, reject, progress });
      this.post({ ...question, id } as Request);
    });
  }

  /** How many questions there were. */
  get asked(): number {
    return this.#last;
  }

  /** Returns a function that ends it. */
  listen(listener: (report: Report) => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /**
   * Calls `draw` before the browser paints, if there is a new view, and at most so many times a
   * second. Hidden pages are not painted. Returns a function that ends it.
   */
  draw(hertz: number, draw: (view: View) => void): () => void {
    let due = 0;
    let pending = 0;
    const paint = (now: number): void => {
      if (now < due) {
        pending = requestAnimationFrame(paint);
        return;
      }
      pending = 0;
      due = now + 1000 / hertz;
      if (this.view) draw(this.view);
    };
    const ask = (): void => {
      pending ||= requestAnimationFrame(paint);
    };
    ask();
    const end = this.listen((report) => report.kind === "view" && ask());
    return () => {
      end();
      cancelAnimationFrame(pending);
    };
  }

  /** Says what needs no answer. */
  post(request: Request): void {
    this.#worker.postMessage(request);
  }

  #take(report: Report): void {
    if (report.kind === "view") this.view = report.view;
    if (report.kind === "done") {
      const pending = this.#pending.get(report.id);
      if (report.error === undefined) pending?.resolve(report);
      else pending?.reject(new Error(report.error));
      this.#pending.delete(report.id);
    }
    if (report.kind === "progress") this.#pending.get(report.id)?.progress?.(report);
    for (const listener of this.#listeners) listener(report);
  }
}

/** Limits the calls of a function, such as one for labels. */
export function everySecond<T>(call: (value: T) => void): (value: T) => void {
  let due = 0;
  return (value) => {
    const now = performance.now();
    if (now < due) return;
    due = now + 1000;
    call(value);
  };
}

/** What the parts of the page need. */
export interface Desk {
  session: Session;
  language: Language;
  isReady: boolean;
  /** The label says in the page what it is. */
  run: (action: Action, label: string) => void;
}

export const DeskContext = createContext<Desk | null>(null);

export function useDesk(): Desk {
  const desk = useContext(DeskContext);
  if (!desk) throw new Error("no desk");
  return desk;
}

/** The newest view, a few times a second. */
export function useView(hertz: number): View | null {
  const { session } = useDesk();
  const [view, setView] = useState(session.view);
  useEffect(() => session.draw(hertz, setView), [session, hertz]);
  return view;
}

export function useOutcome() {
  const [outcome, setOutcome] = useState({ text: "", isBad: false });
  const latest = useRef(0);
  /** Only the newest action says how it ended: it has taken the camera from those before. */
  const follow = async (label: string, work: Promise<unknown>): Promise<void> => {
    const number = ++latest.current;
    setOutcome({ text: `${label} …`, isBad: false });
    const error = await work.then(() => "", sentenceOf);
    if (number !== latest.current) return;
    setOutcome({ text: `${label}: ${error || "done"}`, isBad: error !== "" });
  };
  const clear = (): void => setOutcome({ text: "", isBad: false });
  return { outcome, follow, clear };
}

export interface Task {
  isBusy: boolean;
  problem: string;
  progress: Progress | null;
  /** Returns what the work returns, or null if it has failed: the task has the problem then. */
  run: <T>(work: (progress: OnProgress) => Promise<T>) => Promise<T | null>;
}

/** A piece of work at a time, with its progress and its problem. */
export function useTask(): Task {
  const [isBusy, setBusy] = useState(false);
  const [problem, setProblem] = useState("");
  const [progress, setProgress] = useState<Progress | null>(null);
  const run = async <T,>(work: (progress: OnProgress) => Promise<T>): Promise<T | null> => {
    setBusy(true);
    setProblem("");
    setProgress(null);
    try {
      return await work(setProgress);
    } catch (error) {
      setProblem(sentenceOf(error));
      return null;
    } finally {
      setBusy(false);
      setProgress(null);
    }
  };
  return { isBusy, problem, progress, run };
}
