// Reviews changes: shows differences and problems, tries them on the emulated board, and writes them.

import { useEffect, useRef, useState } from "preact/hooks";

import type { Change, Plan, Trial, Written } from "../../setup_messages.js";
import { Button, SmallButton } from "../inputs.js";
import { useTask } from "../session.js";
import { AskButton, Sentences, TaskState } from "./parts.js";
import { useBench } from "./setup_session.js";

interface Props {
  plan: Plan;
  onWritten: (written: Written) => void;
  onClose: () => void;
}

export function Review({ plan, onWritten, onClose }: Props) {
  const { session, setUndo } = useBench();
  const [trial, setTrial] = useState<Trial | null>(null);
  const place = useRef<HTMLElement>(null);
  useEffect(() => place.current?.scrollIntoView({ block: "nearest" }), [plan]);
  const task = useTask();
  const { changes, problems, remarks } = plan;
  const lines = changes.filter(({ line }) => line).map(({ name }) => name);
  const isWritable = changes.length > 0 && problems.length === 0 && !task.isBusy;
  const attempt = (): Promise<void> =>
    task.run((progress) => session.do("tryOut", [], progress)).then(setTrial);
  const write = (): Promise<unknown> =>
    task.run(async (progress) => {
      setUndo(true); // also of a part
      onWritten(await session.do("write", [], progress));
    });
  return (
    <section ref={place} class="trial review" aria-labelledby="review-title">
      <div class="flow apart head">
        <h3 id="review-title">What would be written</h3>
        <SmallButton onClick={onClose}>Close</SmallButton>
      </div>
      {changes.length + problems.length === 0 && <p>Nothing differs from what is on the board.</p>}
      {problems.length > 0 && (
        <div class="bad" role="alert">
          <Sentences of={problems.map(([, sentence]) => sentence)} />
        </div>
      )}
      <Sentences of={remarks} />
      {changes.length > 0 && <Differences changes={changes} />}
      {lines.length > 0 && (
        <p class="warn">
          {lines.join(", ")}: this changes the line to this page, so it is written last. The page
          may have to connect again.
        </p>
      )}
      <div class="flow row">
        <Button look="plain quiet" disabled={!isWritable} onClick={attempt}>
          Try on the emulated board
        </Button>
        <AskButton
          action="Write"
          question={changes.length === 1 ? "Write 1 parameter?" : `Write ${changes.length} parameters?`}
          disabled={!isWritable}
          onAgree={write}
        >
          <p>
            Parameters take effect at once, and the camera can move. The page reads them back and
            compares; “Undo the last write” brings the present values back.
          </p>
          {lines.length > 0 && <p class="warn">The line changes at the end: {lines.join(", ")}.</p>}
        </AskButton>
      </div>
      <TaskState task={task} />
      {trial && (
        <div class="fault-columns" role="status">
          {(["before", "after"] as const).map((when) => (
            <div key={when}>
              <h3>{when === "before" ? "As it is" : "With the changes"}</h3>
              <Sentences of={trial[when]} />
              {trial[when].length === 0 && <p class="good">Nothing is wrong.</p>}
            </div>
          ))}
        </div>
      )}
    </section>
  );
}

const Differences = ({ changes }: { changes: Change[] }) => (
  <div class="differences" tabIndex={0} role="group" aria-label="Differences">
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
            <td>{after}</td>
          </tr>
        ))}
      </tbody>
    </table>
  </div>
);
