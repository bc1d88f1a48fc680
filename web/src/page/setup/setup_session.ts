// The page's side of the worker that has the line of a real gimbal.

import { createContext } from "preact";
import { useContext, useState } from "preact/hooks";

import type * as setup from "../../setup_messages.js";
import type { Axes } from "../../worker_messages.js";
import { Session, type Progress, type Question } from "../session.js";

/** What `done` brings, where the page looks at it. */
interface Results {
  connect: setup.Connected;
  record: Blob | null;
  parameters: setup.Read;
  profile: setup.Topic[];
  plan: setup.Plan;
  "plan-file": setup.Plan;
  "plan-undo": setup.Plan;
  try: setup.Trial;
  write: setup.Written;
  backup: string;
  calibrations: setup.Calibration[];
  check: setup.Check;
  calibrate: void;
  tune: void;
  bode: setup.Response;
}
type Asked<K extends keyof Results> = Omit<Question<Extract<setup.Request, { kind: K }>>, "kind">;
type OnProgress = (progress: Progress) => void;

export class Setup extends Session {
  arm(on: boolean): void {
    this.post({ kind: "arm", on });
  }

  hold(speeds: Axes): void {
    this.post({ kind: "hold", speeds });
  }

  /** Throws what the worker says is wrong. */
  async get<K extends keyof Results>(
    kind: K,
    asked: Asked<K>,
    progress?: OnProgress,
  ): Promise<Results[K]> {
    const question = { kind, ...asked } as unknown as Question<setup.Request>;
    const done = await this.ask(question, progress);
    if (done.error !== undefined) throw new Error(done.error);
    return ("result" in done ? done.result : undefined) as Results[K];
  }
}

/** What the parts of this page need besides the desk. */
export interface Bench {
  session: Setup;
  isConnected: boolean;
  isArmed: boolean;
  arm: (on: boolean) => void;
  stop: () => void;
  /** Whether this page has written something that it can undo. */
  canUndo: boolean;
  setUndo: (can: boolean) => void;
}

export const BenchContext = createContext<Bench | null>(null);

export function useBench(): Bench {
  const bench = useContext(BenchContext);
  if (!bench) throw new Error("no bench");
  return bench;
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
      setProblem(error instanceof Error ? error.message : String(error));
      return null;
    } finally {
      setBusy(false);
      setProgress(null);
    }
  };
  return { isBusy, problem, progress, run };
}
