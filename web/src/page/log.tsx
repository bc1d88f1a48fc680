// The frames on the line, decoded; the newest ones.

import { useEffect, useRef, useState } from "preact/hooks";

import type { LoggedFrame } from "../worker_messages.js";
import { fixed } from "./axes.js";
import { Check, SmallButton } from "./inputs.js";
import { useDesk } from "./session.js";

const most = 200;
const shown = 60;
const interval = 250; // ms

/** The pages of the messages, which the template of the page names. */
const pages: Record<string, string> = JSON.parse(
  document.getElementById("message-pages")?.textContent ?? "{}",
);

const nameOf = (frame: LoggedFrame): string => frame.message || frame.command;
const keyOf = (frame: LoggedFrame): string => `${frame.from} ${nameOf(frame)}`;

/** As many fields as may fit into a line. */
const briefOf = ({ fields }: LoggedFrame): string =>
  fields
    .slice(0, 6)
    .map(([path, value]) => `${path} ${value}`)
    .join(", ");

/** A frame with its fields behind a summary; they are created when it is opened. */
export function FrameEntry({ frame, isOpen }: { frame: LoggedFrame; isOpen?: boolean }) {
  const [hasBody, setBody] = useState(isOpen ?? false);
  return (
    <details
      class={`frame ${frame.from}`}
      open={isOpen ?? false}
      onToggle={(event) => setBody(event.currentTarget.open)}
    >
      <summary>
        <span class="time">{fixed(frame.seconds, 3)}</span>
        <span class="from">{frame.from === "host" ? "to board" : "from board"}</span>
        <b>{nameOf(frame)}</b>
        <span class="brief">{frame.problem || briefOf(frame)}</span>
      </summary>
      {hasBody && <FrameBody frame={frame} />}
    </details>
  );
}

function FrameBody({ frame }: { frame: LoggedFrame }) {
  const page = Object.hasOwn(pages, frame.message) ? pages[frame.message] : undefined;
  return (
    <div>
      {page && (
        <p>
          <a href={page}>{frame.message}</a> <span class="muted">{frame.command}</span>
        </p>
      )}
      <pre tabIndex={0} role="group" aria-label={`Bytes of ${nameOf(frame)}`}>
        {frame.hex.match(/../g)?.join(" ").toUpperCase()}
      </pre>
      {frame.problem && <p class="bad">{frame.problem}</p>}
      <dl>
        {frame.fields.map(([path, value]) => (
          <div key={path}>
            <dt>{path}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
    </div>
  );
}

export function Log() {
  const { session } = useDesk();
  const frames = useRef<[number, LoggedFrame][]>([]);
  const count = useRef(0);
  const lost = useRef(0);
  const [isOn, setOn] = useState(false);
  const [isPaused, setPaused] = useState(false);
  const [without, setWithout] = useState<readonly string[]>([]);
  const [, redraw] = useState(0);
  useEffect(() => {
    if (!isOn || isPaused) return;
    let isNew = false;
    const end = session.listen((report) => {
      if (report.kind !== "log") return;
      isNew = true;
      lost.current += report.lost;
      for (const frame of report.frames) frames.current.push([++count.current, frame]);
      frames.current.splice(0, frames.current.length - most);
    });
    const timer = setInterval(() => {
      if (isNew) redraw(count.current);
      isNew = false;
    }, interval);
    session.post({ kind: "log", on: true });
    return () => {
      end();
      clearInterval(timer);
      session.post({ kind: "log", on: false });
    };
  }, [session, isOn, isPaused]);

  const kinds = [...new Set(frames.current.map(([, frame]) => keyOf(frame)))].sort();
  const visible = frames.current.filter(([, frame]) => !without.includes(keyOf(frame)));
  const toggle = (kind: string): void =>
    setWithout(without.includes(kind) ? without.filter((k) => k !== kind) : [...without, kind]);
  return (
    <section aria-labelledby="log-title" class="log">
      <div class="flow apart head">
        <h2 id="log-title">Frames on the line</h2>
        <div class="flow do">
          <SmallButton onClick={() => setOn(!isOn)}>
            {isOn ? "End the log" : "Show the log"}
          </SmallButton>
          {isOn && (
            <SmallButton onClick={() => setPaused(!isPaused)}>
              {isPaused ? "Continue" : "Pause"}
            </SmallButton>
          )}
        </div>
      </div>
      {isOn && (
        <>
          <fieldset class="flow small kinds">
            <legend class="hidden">Shown messages</legend>
            {kinds.map((kind) => (
              <Check
                key={kind}
                label={kind}
                checked={!without.includes(kind)}
                onChange={() => toggle(kind)}
              />
            ))}
          </fieldset>
          <p class="muted small">
            {count.current} frames, the newest first
            {lost.current > 0 && `; ${lost.current} were too many to decode`}
          </p>
          <div class="frames">
            {visible
              .slice(-shown)
              .reverse()
              .map(([number, frame]) => (
                <FrameEntry key={number} frame={frame} />
              ))}
          </div>
        </>
      )}
    </section>
  );
}
