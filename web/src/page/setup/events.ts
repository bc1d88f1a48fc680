// Listening as long as a part is in the page.

import { useEffect, useRef } from "preact/hooks";

type Hear = (event: Event) => unknown;

/** `isFirst`: before the elements inside `target` hear of it. */
export function useEvents(
  target: EventTarget | undefined,
  kinds: string[],
  hear: Hear,
  isFirst = false,
): void {
  const newest = useRef(hear);
  newest.current = hear;
  useEffect(() => {
    const call: Hear = (event) => newest.current(event);
    for (const kind of kinds) target?.addEventListener(kind, call, isFirst);
    return () => kinds.forEach((kind) => target?.removeEventListener(kind, call, isFirst));
  }, [target]);
}
