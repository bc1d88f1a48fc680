// What would be written: differences and problems; tried on the emulated board, and written.

import { useState } from "preact/hooks";

import type { Change, Plan, Trial, Written } from "../../setup_messages.js";
import { Dialog, TaskState } from "./parts.js";
import { useBench, useTask } from "./setup_session.js";

interface Props {
  plan: Plan;
  onWritten: (written: Written) => void;
  onClose: () => void;
}

export function Review({ plan, onWritten, onClose }: Props) {
  const { session, setUndo } = useBench();
  const [trial, setTrial] = useState<Trial | null>(null);
  const [asks, setAsks] = useState(false);
  const task = useTask();
  const { problems, remarks } = plan;
  const changes = [...plan.changes.filter(({ line }) => !line), ...plan.changes.filter(({ line }) => line)];
  const lines = changes.filter(({ line }) => line).map(({ name }) => name);
  const isWritable = changes.length > 0 && problems.length === 0 && !task.isBusy;
  const attempt = async (): Promise<void> =>
    setTrial(await task.run((progress) => session.get("try", {}, progress)));
  const write = async (): Promise<void> => {
    const written = await task.run((progress) => session.get("write", {}, progress));
    if (!written) return;
    setUndo(true);
    onWritten(written);
  };
  const count = changes.length === 1 ? "1 parameter" : `${changes.length} parameters`;
  return (
    <section class="review" aria-labelledby="review-title">
      <div class="head">
        <h3 id="review-title">What would be written</h3>
        <button type="button" class="plain quiet small" onClick={onClose}>
          Close
        </button>
      </div>
      {changes.length === 0 && <p>Nothing differs from what is on the board.</p>}
      {problems.length > 0 && (
        <ul class="bad" aria-label="Problems" role="alert">
          {problems.map(([name, sentence]) => (
            <li key={`${name} ${sentence}`}>
              {name && <code>{name}</code>} {sentence}
            </li>
          ))}
        </ul>
      )}
      {remarks.length > 0 && (
        <ul class="muted" aria-label="Remarks">
          {remarks.map((one) => (
            <li key={one}>{one}</li>
          ))}
        </ul>
      )}
      {changes.length > 0 && <Differences changes={changes} />}
      {lines.length > 0 && (
        <p class="warn">
          {lines.join(", ")}: this changes the line to this page, so it is written last; the page
          may have to connect again.
        </p>
      )}
      <div class="do">
        <button
          type="button"
          class="plain quiet"
          disabled={!isWritable}
          onClick={() => void attempt()}
        >
          Try on the emulated board
        </button>
        <button type="button" class="plain" disabled={!isWritable} onClick={() => setAsks(true)}>
          Write
        </button>
      </div>
      <TaskState task={task} />
      {trial && (
        <div class="trial-result" role="status">
          {(["before", "after"] as const).map((when) => (
            <div key={when}>
              <h3>{when === "before" ? "As it is" : "With the changes"}</h3>
              <ul>
                {trial[when].map((one) => (
                  <li key={one}>{one}</li>
                ))}
              </ul>
              {trial[when].length === 0 && <p class="good">Nothing is wrong.</p>}
            </div>
          ))}
        </div>
      )}
      {asks && (
        <Dialog
          title={`Write ${count}?`}
          action="Write"
          onAgree={() => void write()}
          onClose={() => setAsks(false)}
        >
          <p>
            Parameters take effect at once, and the camera can move. The page reads them back and
            compares; “Undo the last write” brings the present values back.
          </p>
          {lines.length > 0 && <p class="warn">The line changes at the end: {lines.join(", ")}.</p>}
        </Dialog>
      )}
    </section>
  );
}

const Differences = ({ changes }: { changes: Change[] }) => (
  <div class="wide-table" tabIndex={0} role="group" aria-label="Differences">
    <table>
      <thead>
        <tr>
          <th scope="col">Parameter</th>
          <th scope="col">Profile</th>
          <th scope="col">Now</th>
          <th scope="col">Then</th>
        </tr>
      </thead>
      <tbody>
        {changes.map(({ name, profile, before, after, line }) => (
          <tr key={`${name} ${profile}`} class={line ? "warn" : ""}>
            <th scope="row">{name}</th>
            <td>{profile || "all"}</td>
            <td>{before}</td>
            <td>
              <b>{after}</b>
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  </div>
);
