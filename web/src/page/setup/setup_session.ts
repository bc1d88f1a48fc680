// The page's side of the worker that has the line of a real gimbal.

import { createContext } from "preact";
import { useContext } from "preact/hooks";

import type { Request, Work } from "../../setup_messages.js";
import { Session, type OnProgress, type Question } from "../session.js";

export class Setup extends Session {
  async do<Name extends keyof Work>(
    name: Name,
    args: Parameters<Work[Name]>,
    progress?: OnProgress,
  ): Promise<ReturnType<Work[Name]>> {
    const question = { kind: "work", name, args } as Question<Request>;
    const done = await this.ask(question, progress);
    return ("result" in done ? done.result : undefined) as ReturnType<Work[Name]>;
  }

  /** Nobody waits for its end. */
  end(name: "cancel" | "disconnect"): void {
    this.do(name, []).catch(() => {});
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
