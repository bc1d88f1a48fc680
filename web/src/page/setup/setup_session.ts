// The page's side of the worker that has the line of a real gimbal.

import type { OnProgress } from "../../client.js";
import type { Work } from "../../setup_worker.js";
import { type Desk, Session, useDesk } from "../session.js";

/** What the page says; the worker adds a function for progress. */
type Said<All extends unknown[]> = All extends [...infer Args, OnProgress] ? Args : All;

export class Setup extends Session {
  async do<Name extends keyof Work>(
    name: Name,
    args: Said<Parameters<Work[Name]>>,
    progress?: OnProgress,
  ): Promise<Awaited<ReturnType<Work[Name]>>> {
    const done = await this.ask({ kind: "work", name, args }, progress);
    return ("result" in done ? done.result : undefined) as Awaited<ReturnType<Work[Name]>>;
  }

  /** Nobody waits for its end. */
  end(name: "cancel" | "disconnect"): void {
    this.do(name, []).catch(() => {});
  }
}

/** The desk of this page. */
export interface Bench extends Desk {
  session: Setup;
  isConnected: boolean;
  isArmed: boolean;
  arm: (on: boolean) => void;
  stop: () => void;
  /** Whether this page has written something that it can undo. */
  canUndo: boolean;
  setUndo: (can: boolean) => void;
}

export const useBench = (): Bench => useDesk() as Bench;
