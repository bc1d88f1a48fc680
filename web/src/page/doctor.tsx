// The findings of `sbgc doctor` about the gimbal.

import { useState } from "preact/hooks";

import type { Finding } from "../modules.js";
import { CodeLine } from "./actions.js";
import { doctorLines } from "./lines.js";
import { useDesk } from "./session.js";

export function DoctorPanel() {
  const { session, isReady } = useDesk();
  const [isBusy, setBusy] = useState(false);
  const [findings, setFindings] = useState<Finding[] | null>(null);
  const [problem, setProblem] = useState("");
  const examine = async (): Promise<void> => {
    setBusy(true);
    setProblem("");
    const done = await session.ask({ kind: "doctor" });
    setBusy(false);
    setProblem(done.error ?? "");
    setFindings(done.error ? null : (done.findings ?? []));
  };
  return (
    <section aria-labelledby="doctor-title" class="doctor">
      <h2 id="doctor-title">Doctor</h2>
      <div class="action">
        <div class="do">
          <button
            type="button"
            class="plain"
            disabled={!isReady || isBusy}
            onClick={() => void examine()}
          >
            {isBusy ? "Measuring…" : "Examine"}
          </button>
        </div>
        <CodeLine lines={doctorLines} about="Examine" />
      </div>
      <div role="status" aria-busy={isBusy}>
        {problem && <p class="bad">{problem}</p>}
        {findings?.length === 0 && <p class="good">Nothing is wrong.</p>}
        {findings && findings.length > 0 && (
          <ul class="findings">
            {findings.map((finding) => (
              <li key={`${finding.id} ${finding.axis}`} data-finding={finding.id}>
                <b>{finding.sentence}</b> {finding.advice}
                {finding.command && (
                  <>
                    {" "}
                    <code>{finding.command}</code>
                  </>
                )}
              </li>
            ))}
          </ul>
        )}
      </div>
    </section>
  );
}
