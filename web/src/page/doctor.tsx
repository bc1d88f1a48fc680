// The findings of `sbgc doctor` about the gimbal.

import { useState } from "preact/hooks";

import type { Finding } from "../modules.js";
import { CodeLine } from "./actions.js";
import { Button } from "./inputs.js";
import { doctorLines } from "./lines.js";
import { useDesk, useTask } from "./session.js";

export function DoctorPanel() {
  const { session, isReady } = useDesk();
  const [findings, setFindings] = useState<Finding[] | null>(null);
  const { isBusy, problem, run } = useTask();
  const examine = async (): Promise<void> => {
    const done = await run(() => session.ask({ kind: "doctor" }));
    setFindings(done?.findings ?? null);
  };
  return (
    <section aria-labelledby="doctor-title" class="doctor">
      <h2 id="doctor-title">Doctor</h2>
      <div class="action">
        <div class="flow do">
          <Button disabled={!isReady || isBusy} onClick={examine}>
            {isBusy ? "Measuring…" : "Examine"}
          </Button>
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
