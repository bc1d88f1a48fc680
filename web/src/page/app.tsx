// The page: the gimbal on one side, the controls on the other.

import { useEffect, useRef, useState } from "preact/hooks";

import { Charts } from "./charts.js";
import { BoardPanel, MotionPanel, MovePanel, TurnPanel } from "./controls.js";
import { DoctorPanel } from "./doctor.js";
import { optionsOf } from "./emulation.js";
import { FaultPanel } from "./faults.js";
import { Horizons } from "./horizon.js";
import { Choice, SmallButton } from "./inputs.js";
import { languages, stop, type Action, type Language } from "./lines.js";
import { Log } from "./log.js";
import { Numbers, Pace, Status } from "./status.js";
import { Offline } from "./offline.js";
import { type Desk, DeskContext, type Session, useOutcome } from "./session.js";
import { GimbalView } from "./scene.js";
import { Trial } from "./trial.js";
import { linkOf, readLink, usualValues, type Values } from "./values.js";

/** How long the page waits for more changes of motion and faults, in ms. */
const changePause = 200;
const isTyping = (target: EventTarget | null): boolean =>
  target instanceof Element && target.closest(".search, .menu") !== null;

/** The skip link of the site has an address of its own. */
const linkInAddress = (): string => (location.hash === "#main" ? "" : location.hash);

export function App({ session }: { session: Session }) {
  const [{ first, refusal }] = useState(() => {
    const read = readLink(linkInAddress());
    return typeof read === "string"
      ? { first: usualValues(), refusal: read }
      : { first: read, refusal: "" };
  });
  const [values, setValues] = useState(first);
  const [refused, setRefused] = useState(refusal);
  const [language, setLanguage] = useState<Language>("command");
  const [identity, setIdentity] = useState("");
  const [failure, setFailure] = useState("");
  const [notice, setNotice] = useState("");
  const { outcome, follow, clear } = useOutcome();
  const [pace, setPace] = useState(1);
  const set = (change: Partial<Values>): void => setValues((now) => ({ ...now, ...change }));

  useEffect(() => {
    const end = session.listen((report) => {
      if (report.kind === "ready") session.post({ kind: "start", options: optionsOf(first) });
      if (report.kind === "identity") setIdentity(report.text);
      if (report.kind === "failed") setFailure(report.message);
      if (report.kind === "notice") setNotice(report.text);
    });
    return end;
  }, [session]);

  const emulation = JSON.stringify(optionsOf(values));
  const applied = useRef(emulation);
  useEffect(() => {
    if (emulation === applied.current) return;
    const timer = setTimeout(() => {
      applied.current = emulation;
      session.post({ kind: "change", options: JSON.parse(emulation) });
    }, changePause);
    return () => clearTimeout(timer);
  }, [session, emulation]);

  const run = (action: Action, label: string): Promise<void> =>
    follow(label, session.ask({ kind: "act", action: action.text }));

  useEffect(() => {
    const key = (event: KeyboardEvent): void => {
      if (event.key === "Escape" && !isTyping(event.target)) void run(stop, "Stop");
    };
    const address = (): void => {
      const link = linkInAddress();
      if (!link) return;
      const read = readLink(link);
      setRefused(typeof read === "string" ? read : "");
      if (typeof read !== "string") setValues(read);
    };
    addEventListener("keydown", key);
    addEventListener("hashchange", address);
    return () => {
      removeEventListener("keydown", key);
      removeEventListener("hashchange", address);
    };
  }, [session]);

  const restart = (): void => {
    setIdentity("");
    clear();
    setNotice("");
    session.post({ kind: "start", options: optionsOf(values) });
    session.post({ kind: "pace", factor: pace });
  };
  const choosePace = (factor: number): void => {
    session.post({ kind: "pace", factor });
    setPace(factor);
  };
  const desk: Desk = {
    session,
    language,
    isReady: identity !== "",
    run: (action, label) => void run(action, label),
  };
  return (
    <DeskContext.Provider value={desk}>
      <Offline />
      {failure && (
        <div class="note bad" role="alert">
          <p>The gimbal cannot run here: {failure}</p>
        </div>
      )}
      {refused && (
        <div class="note warn" role="alert">
          <p>The link is refused, and nothing of it is used: {refused}.</p>
        </div>
      )}
      <Status title={identity || "The board starts…"} onStop={() => void run(stop, "Stop")}>
        <Pace pace={pace} onPace={choosePace} />
        <SmallButton onClick={restart}>New board</SmallButton>
      </Status>
      {values.send && (
        <Trial key={values.send} hex={values.send} onClose={() => set({ send: "" })} />
      )}
      <div class="bench">
        <div class="stage">
          <GimbalView />
          <Horizons />
          <Numbers />
          <p class={outcome.isBad ? "outcome small bad" : "outcome small muted"} role="status">
            {outcome.text || notice}
          </p>
        </div>
        <div class="panels">
          <Choice
            class="languages"
            legend="Lines to take home"
            options={languages}
            value={language}
            onChange={setLanguage}
          />
          <BoardPanel values={values} set={set} />
          <MovePanel values={values} set={set} />
          <TurnPanel values={values} set={set} />
          <MotionPanel values={values} set={set} />
        </div>
      </div>
      <FaultPanel values={values} set={set} />
      <DoctorPanel />
      <Charts />
      <Log />
      <Share values={values} />
    </DeskContext.Provider>
  );
}

function Share({ values }: { values: Values }) {
  const [said, setSaid] = useState("");
  const copy = async (): Promise<void> => {
    const link = linkOf(values);
    history.replaceState(null, "", link.length > 1 ? link : location.pathname);
    try {
      await navigator.clipboard.writeText(location.href);
      setSaid("The link is copied.");
    } catch {
      setSaid("The address of the page is now the link.");
    }
  };
  return (
    <p class="small share">
      <SmallButton onClick={copy}>Link to these values</SmallButton>{" "}
      <span role="status">{said}</span>
    </p>
  );
}
