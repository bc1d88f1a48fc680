// A request that a link has brought. It is shown, and sent when the visitor wants it.

import { useEffect, useState } from "preact/hooks";

import type { LoggedFrame } from "../worker_messages.js";
import { Button, SmallButton } from "./inputs.js";
import { FrameEntry } from "./log.js";
import { useDesk, useTask, type Done } from "./session.js";

export function Trial({ hex, onClose }: { hex: string; onClose: () => void }) {
  const { session, isReady } = useDesk();
  const [request, setRequest] = useState<LoggedFrame | null>(null);
  const [answer, setAnswer] = useState<Done | null>(null);
  const decoding = useTask();
  const sending = useTask();
  const isSent = sending.isBusy || sending.problem !== "" || answer !== null;
  useEffect(() => {
    if (!isReady) return;
    void decoding.run(async () => {
      const { frames } = await session.ask({ kind: "decode", frame: hex });
      const [first] = frames ?? [];
      setRequest(first ?? null);
      if (!first || first.problem) throw new Error(first?.problem ?? "These bytes are no frame.");
    });
  }, [session, hex, isReady]);
  const send = (): Promise<void> =>
    sending.run(() => session.ask({ kind: "send", frame: hex })).then(setAnswer);
  const isSendable = isReady && !sending.isBusy && request !== null && !decoding.problem;
  return (
    <section aria-labelledby="trial-title" class="trial">
      <div class="flow apart head">
        <h2 id="trial-title">A request from a link</h2>
        <SmallButton onClick={onClose}>Close</SmallButton>
      </div>
      {!isSent && <p>Nothing has been sent yet. The board here is emulated.</p>}
      {decoding.problem && (
        <p class="bad" role="alert">
          {decoding.problem}
        </p>
      )}
      {request && <FrameEntry frame={request} isOpen />}
      <Button disabled={!isSendable} onClick={send}>{sending.isBusy ? "Waiting…" : "Send"}</Button>
      <div role="status">
        {answer && <h3>The answer</h3>}
        {sending.problem && <p class="bad">{sending.problem}</p>}
        {answer && !answer.frames?.length && (
          <p class="muted">The board has accepted it; it does not answer this request.</p>
        )}
        {answer?.frames?.map((frame, n) => <FrameEntry key={n} frame={frame} isOpen />)}
      </div>
    </section>
  );
}
