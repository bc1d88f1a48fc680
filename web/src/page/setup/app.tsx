// The page: connect, then look, move, set and care.

import { useEffect, useRef, useState } from "preact/hooks";

import type { Connected, LinkState } from "../../setup_messages.js";
import { Charts } from "../charts.js";
import { Horizons } from "../horizon.js";
import { Button, Choice, SmallButton } from "../inputs.js";
import type { Action } from "../lines.js";
import { Log } from "../log.js";
import { Numbers, Status } from "../status.js";
import { Offline } from "../offline.js";
import { DeskContext, useOutcome, useTask } from "../session.js";
import { GimbalView } from "../scene.js";
import { CarePanel } from "./care.js";
import { ConnectPanel } from "./connect.js";
import { download, Sentences, useEvents } from "./parts.js";
import { Hold } from "./hold.js";
import { MovePanel } from "./move.js";
import { ParametersPanel } from "./parameters.js";
import { useBench, type Bench, type Setup } from "./setup_session.js";

declare const VERSION: string;
const reloadedFor = "sbgc-setup-reloaded";

const views = [
  ["move", "Look and move"],
  ["parameters", "Parameters"],
  ["care", "Care"],
] as const;

/** Loads the page again if its worker has another version; returns what is wrong, or "". */
function checkVersion(version: string): string {
  if (version === VERSION) return "";
  const both = `${VERSION} ${version}`;
  if (sessionStorage.getItem(reloadedFor) === both) {
    return "it and its worker have different versions, although it was loaded again; clear the browser's cache";
  }
  sessionStorage.setItem(reloadedFor, both);
  location.reload();
  return "its worker has another version, so it is loaded again";
}

export function App({ session, token }: { session: Setup; token: string }) {
  const [isReady, setReady] = useState(false);
  const [failure, setFailure] = useState("");
  const [link, setLink] = useState<{ state: LinkState; text: string }>({ state: "closed", text: "" });
  const [board, setBoard] = useState<Connected | null>(null);
  const [isArmed, setArmed] = useState(false);
  const [canUndo, setUndo] = useState(false);
  const [notice, setNotice] = useState("");
  const [shown, setShown] = useState<(typeof views)[number][0]>("move");
  const { outcome, follow, clear } = useOutcome();
  const [hold] = useState(() => new Hold((speeds) => session.post({ kind: "hold", speeds })));
  const isConnected = link.state === "connected" && board !== null;

  const arm = (on: boolean): void => {
    if (on && (!isReady || !isConnected)) return;
    if (!on) hold.releaseAll();
    void session.do("arm", [on]);
    setArmed(on);
  };
  const stop = (): void => {
    void follow("Stop", session.do("stop", []));
    hold.releaseAll(true);
  };
  /** Actions that have not ended. */
  const running = useRef(0);
  const run = async ({ text }: Action, label: string): Promise<void> => {
    ++running.current;
    await follow(label, session.ask({ kind: "act", action: text }));
    --running.current;
  };
  const disarm = useRef(() => {});
  disarm.current = () => {
    if (!isArmed) return;
    if (isConnected && running.current > 0) stop();
    arm(false);
  };

  useEffect(
    () =>
      session.listen((report) => {
        if (report.kind === "ready" && "version" in report) {
          const problem = checkVersion(report.version);
          setFailure(problem);
          setReady(problem === "");
        }
        if (report.kind === "failed") setFailure(report.message);
        if (report.kind === "notice" || report.kind === "locked") {
          clear();
          setNotice(report.text);
        }
        if (report.kind === "locked") disarm.current();
        if (report.kind !== "link") return;
        setLink(report);
        if (report.state !== "connected") session.view = null;
        if (report.state !== "connected") disarm.current();
        if (report.state === "closed") setBoard(null);
      }),
    [session],
  );
  // No dialog or field can keep the key for itself.
  const isEscape = (event: Event): boolean => (event as KeyboardEvent).key === "Escape";
  useEvents(window, ["keydown"], (event) => isEscape(event) && stop(), true);
  useEvents(document, ["visibilitychange"], () => document.hidden && disarm.current());

  const connected = (now: Connected): void => {
    setBoard(now);
    setUndo(false);
    setNotice("");
    clear();
  };
  const isBad = isConnected ? outcome.isBad : link.state === "lost";
  const bench: Bench = {
    session,
    language: "command",
    isReady: isConnected,
    run,
    isConnected,
    isArmed,
    arm,
    stop,
    canUndo,
    setUndo,
  };
  return (
    <DeskContext.Provider value={bench}>
      <Offline />
      {failure && (
        <div class="note bad" role="alert">
          <p>This page cannot work: {failure}</p>
        </div>
      )}
      <Status key={link.state} title={board?.identity ?? "No gimbal is connected"} onStop={stop}>
        {isArmed ? (
          <Button look="armed" onClick={() => disarm.current()}>Armed: lock</Button>
        ) : (
          <span class="muted">motion locked</span>
        )}
        {board && <Recorder />}
        {board && (
          <SmallButton onClick={() => session.end("disconnect")}>Disconnect</SmallButton>
        )}
      </Status>
      <p class={isBad ? "outcome small bad" : "outcome small muted"} role="status">
        {isConnected ? outcome.text || notice : link.text}
      </p>
      {!board && <ConnectPanel token={token} isReady={isReady} onConnected={connected} />}
      {board && (
        <>
          <Facts board={board} />
          <Choice class="views" legend="View" options={views} value={shown} onChange={setShown} />
          <div hidden={shown !== "move"}>
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
          <div hidden={shown !== "parameters"}>
            <ParametersPanel />
          </div>
          <div hidden={shown !== "care"}>
            <CarePanel />
          </div>
        </>
      )}
    </DeskContext.Provider>
  );
}

function Facts({ board: { serialNumber, line, lacks } }: { board: Connected }) {
  const facts = [
    line && `${line.baudRate} baud, parity ${line.parity}`,
    serialNumber && `serial number ${serialNumber}`,
  ];
  return (
    <div class="flow row muted small says">
      <span>{facts.filter(Boolean).join(", ")}</span>
      {lacks.length > 0 && (
        <details>
          <summary>What this board lacks</summary>
          <Sentences of={lacks} />
        </details>
      )}
    </div>
  );
}

function Recorder() {
  const { session } = useBench();
  const [isOn, setOn] = useState(false);
  const { run, problem } = useTask();
  const toggle = (): Promise<unknown> =>
    run(async () => {
      const bytes = await session.do("record", [!isOn]);
      if (isOn && bytes) download(bytes, "capture");
      setOn(!isOn);
    });
  return (
    <>
      <Button look={isOn ? "plain small" : "plain quiet small"} onClick={toggle}>
        {isOn ? "Save the recording" : "Record"}
      </Button>
      {problem && <span class="bad">{problem}</span>}
    </>
  );
}
