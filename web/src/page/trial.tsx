// A request that a link has brought. It is shown, and sent when the visitor wants it.

import { useEffect, useState } from "preact/hooks";

import type { LoggedFrame } from "../worker_messages.js";
import { FrameEntry } from "./log.js";
import { useDesk, type Done } from "./session.js";

export function Trial({ hex, onClose }: { hex: string; onClose: () => void }) {
  const { session, isReady } = useDesk();
  const [request, setRequest] = useState<LoggedFrame | null>(null);
  const [problem, setProblem] = useState("");
  const [answer, setAnswer] = useState<Done | null>(null);
  const [isBusy, setBusy] = useState(false);
  useEffect(() => {
    if (!isReady) return;
    void session.ask({ kind: "decode", frame: hex }).then((done) => {
      const [first] = done.frames ?? [];
      setRequest(first ?? null);
      setProblem(done.error ?? first?.problem ?? (first ? "" : "These bytes are no frame."));
    });
  }, [session, hex, isReady]);
  const send = async (): Promise<void> => {
    setBusy(true);
    setAnswer(await session.ask({ kind: "send", frame: hex }));
    setBusy(false);
  };
  const isSendable = isReady && !isBusy && request !== null && !problem;
  return (
    <section aria-labelledby="trial-title" class="trial">
      <div class="head">
        <h2 id="trial-title">A request from a link</h2>
        <button type="button" class="plain quiet small" onClick={onClose}>
          Close
        </button>
      </div>
      {!answer && <p>Nothing has been sent yet. The board here is emulated.</p>}
      {problem && (
        <p class="bad" role="alert">
          {problem}
        </p>
      )}
      {request && <FrameEntry frame={request} isOpen />}
      <button type="button" class="plain" disabled={!isSendable} onClick={() => void send()}>
        {isBusy ? "Waiting…" : "Send"}
      </button>
      <div role="status">
        {answer && <h3>The answer</h3>}
        {answer?.error && <p class="bad">{answer.error}</p>}
        {answer && !answer.error && !answer.frames?.length && (
          <p class="muted">The board has accepted it; it does not answer this request.</p>
        )}
        {answer?.frames?.map((frame, n) => <FrameEntry key={n} frame={frame} isOpen />)}
      </div>
    </section>
  );
}
