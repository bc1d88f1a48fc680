// How what the visitor has asked for has ended.

import { useRef, useState } from "preact/hooks";

import type { Done } from "./session.js";

export function useOutcome() {
  const [outcome, setOutcome] = useState({ text: "", isBad: false });
  const latest = useRef(0);
  /** Only the newest action says how it ended: it has taken the camera from those before. */
  const follow = async (label: string, work: Promise<Done>): Promise<void> => {
    const number = ++latest.current;
    setOutcome({ text: `${label} …`, isBad: false });
    const done = await work;
    if (number !== latest.current) return;
    setOutcome({ text: `${label}: ${done.error ?? "done"}`, isBad: Boolean(done.error) });
  };
  const clear = (): void => setOutcome({ text: "", isBad: false });
  return { outcome, follow, clear };
}
