// The page: connect, then look, move, set and care.

import { useEffect, useRef, useState } from "preact/hooks";

import type { Connected, LinkState } from "../../setup_messages.js";
import { Charts } from "../charts.js";
import { Horizons } from "../horizon.js";
import { Choice } from "../inputs.js";
import { Log } from "../log.js";
import { Numbers } from "../numbers.js";
import { Offline } from "../offline.js";
import { useOutcome } from "../outcome.js";
import { GimbalView } from "../scene.js";
import { DeskContext, type Desk } from "../session.js";
import { Status } from "../status.js";
import { CarePanel } from "./care.js";
import { ConnectPanel } from "./connect.js";
import { Hold } from "./hold.js";
import { MovePanel } from "./move.js";
import { ParametersPanel } from "./parameters.js";
import { download } from "./parts.js";
import { BenchContext, useBench, type Bench, type Setup } from "./setup_session.js";

declare const VERSION: string;
const reloadedFor = "sbgc-setup-reloaded";

const tasks = [
  ["move", "Look and move"],
  ["parameters", "Parameters"],
  ["care", "Care"],
] as const;
type TaskName = (typeof tasks)[number][0];

/** Returns what is wrong with a worker of another version, if it was no use to load the page again. */
function checkVersion(version: string): string {
  if (version === VERSION) return "";
  const key = `${VERSION} ${version}`;
  if (sessionStorage.getItem(reloadedFor) === key) {
    return "the page and its worker have different versions, also after it was loaded again; clear the browser's cache";
  }
  sessionStorage.setItem(reloadedFor, key);
  location.reload();
  return "the page is loaded again, because its worker has another version";
}

export function App({ session, token }: { session: Setup; token: string }) {
  const [isReady, setReady] = useState(false);
  const [failure, setFailure] = useState("");
  const [link, setLink] = useState<{ state: LinkState; text: string }>({ state: "closed", text: "" });
  const [board, setBoard] = useState<Connected | null>(null);
  const [connections, setConnections] = useState(0);
  const [isArmed, setArmed] = useState(false);
  const [canUndo, setUndo] = useState(false);
  const [notice, setNotice] = useState("");
  const [shown, setShown] = useState<TaskName>("move");
  const { outcome, follow } = useOutcome();
  const [hold] = useState(() => new Hold((speeds) => session.hold(speeds)));
  const isConnected = link.state === "connected" && board !== null;

  const arm = (on: boolean): void => {
    if (on && (!isReady || !isConnected)) return;
    if (!on) hold.releaseAll();
    session.arm(on);
    setArmed(on);
  };
  const stop = (): void => {
    void follow("Stop", session.ask({ kind: "stop" }));
    hold.releaseAll(true);
  };
  const newest = useRef({ stop, arm });
  newest.current = { stop, arm };

  useEffect(
    () =>
      session.listen((report) => {
        if (report.kind === "ready" && "version" in report) {
          const problem = checkVersion(report.version);
          setFailure(problem);
          setReady(problem === "");
        }
        if (report.kind === "failed") setFailure(report.message);
        if (report.kind === "notice") setNotice(report.text);
        if (report.kind !== "link") return;
        setLink(report);
        if (report.state !== "connected") newest.current.arm(false);
        if (report.state === "closed") setBoard(null);
      }),
    [session],
  );
  useEffect(() => {
    // Before anything else hears of it, so that no dialog or field keeps the key for itself.
    const key = (event: KeyboardEvent): void => {
      if (event.key === "Escape") newest.current.stop();
    };
    const hide = (): void => {
      if (document.hidden) newest.current.arm(false);
    };
    addEventListener("keydown", key, { capture: true });
    document.addEventListener("visibilitychange", hide);
    return () => {
      removeEventListener("keydown", key, { capture: true });
      document.removeEventListener("visibilitychange", hide);
    };
  }, [session]);

  const connected = (now: Connected): void => {
    setBoard(now);
    setConnections((count) => count + 1);
    setUndo(false);
    setNotice("");
  };
  const desk: Desk = {
    session,
    language: "command",
    isReady: isConnected,
    run: ({ text }, label) => void follow(label, session.ask({ kind: "act", action: text })),
  };
  const bench: Bench = { session, isConnected, isArmed, arm, stop, canUndo, setUndo };
  const title = board ? board.identity : isReady ? "No gimbal is connected" : "The page starts…";
  return (
    <DeskContext.Provider value={desk}>
      <BenchContext.Provider value={bench}>
        <Offline />
        {failure && (
          <div class="note bad" role="alert">
            <p>This page cannot work: {failure}</p>
          </div>
        )}
        <Status title={title} onStop={stop}>
          <span class={isArmed ? "armed" : "muted"}>{isArmed ? "armed" : "motion locked"}</span>
          {isArmed && (
            <button type="button" class="plain quiet small" onClick={() => arm(false)}>
              Lock
            </button>
          )}
          {board && <Recorder />}
          {board && (
            <button
              type="button"
              class="plain quiet small"
              onClick={() => void session.ask({ kind: "disconnect" })}
            >
              Disconnect
            </button>
          )}
        </Status>
        <p class={link.state === "lost" ? "link bad" : "link"} role="status">
          {link.text}
        </p>
        {board && board.lacks.length > 0 && (
          <details class="lacks">
            <summary>What this board lacks</summary>
            <ul>
              {board.lacks.map((one) => (
                <li key={one}>{one}</li>
              ))}
            </ul>
          </details>
        )}
        {!board && <ConnectPanel token={token} isReady={isReady} onConnected={connected} />}
        {board && (
          <>
            <Choice
              class="tasks"
              legend="What to do"
              options={tasks}
              value={shown}
              onChange={setShown}
            />
            <p class={outcome.isBad ? "outcome bad" : "outcome"} role="status">
              {outcome.text || notice}
            </p>
            <div hidden={shown !== "move"} key={`move ${connections}`}>
              <div class="bench">
                <div class="stage">
                  <GimbalView />
                  <Horizons />
                  <Numbers />
                </div>
                <div class="panels">
                  <MovePanel hold={hold} />
                </div>
              </div>
              <Charts />
              <Log />
            </div>
            <div hidden={shown !== "parameters"} key={`parameters ${connections}`}>
              <ParametersPanel />
            </div>
            <div hidden={shown !== "care"} key={`care ${connections}`}>
              <CarePanel />
            </div>
          </>
        )}
      </BenchContext.Provider>
    </DeskContext.Provider>
  );
}

function Recorder() {
  const { session } = useBench();
  const [isOn, setOn] = useState(false);
  const [problem, setProblem] = useState("");
  const toggle = async (): Promise<void> => {
    try {
      const bytes = await session.get("record", { on: !isOn });
      if (isOn && bytes) download(bytes, "capture");
      setOn(!isOn);
      setProblem("");
    } catch (error) {
      setProblem(String(error));
    }
  };
  return (
    <>
      <button
        type="button"
        class={isOn ? "plain small" : "plain quiet small"}
        onClick={() => void toggle()}
      >
        {isOn ? "Save the recording" : "Record"}
      </button>
      {problem && <span class="bad">{problem}</span>}
    </>
  );
}
