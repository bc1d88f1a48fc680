// Results of workers for their pages.

import type { Report } from "./worker_messages.js";

type Done = Extract<Report, { kind: "done" }>;

export const sentenceOf = (error: unknown): string =>
  error instanceof Error ? error.message : String(error);

/** Reports the end of the requested work to the page. */
export function answer(say: (report: Done) => void, id: number, work: Promise<object | void>): void {
  work.then(
    (result) => say({ kind: "done", id, ...result }),
    (error: unknown) => say({ kind: "done", id, error: sentenceOf(error) }),
  );
}
