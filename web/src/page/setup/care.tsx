// Doctor, calibrations, tuning and frequency responses.

import { useEffect, useRef, useState } from "preact/hooks";

import type { Calibration, Response } from "../../setup_messages.js";
import { type AxisName, axisNames, axisNumbers } from "../axes.js";
import { usePlots } from "../charts.js";
import { DoctorPanel } from "../doctor.js";
import { Button, Check, Choice, Select, SliderRow, TextInput } from "../inputs.js";
import { useTask, useView } from "../session.js";
import type { Limits } from "../values.js";
import { ArmSwitch, AskButton, download, TaskState } from "./parts.js";
import { useBench } from "./setup_session.js";

export const CarePanel = () => (
  <>
    <DoctorPanel />
    <Calibrations />
    <TunePanel />
    <BodePanel />
    <section aria-labelledby="firmware-title">
      <h2 id="firmware-title">Firmware of the board</h2>
      <p>This page does not update the firmware of a board: use the program of its vendor.</p>
    </section>
  </>
);

function Calibrations() {
  const { session } = useBench();
  const [all, setAll] = useState<Calibration[]>([]);
  const task = useTask();
  useEffect(() => {
    void task.run(() => session.do("calibrations", [])).then((found) => setAll(found ?? []));
  }, [session]);
  return (
    <section aria-labelledby="calibrations-title">
      <h2 id="calibrations-title">Calibrations</h2>
      {all.map((one) => (
        <CalibrationCard key={one.name} calibration={one} />
      ))}
      <TaskState task={task} />
    </section>
  );
}

function CalibrationCard({ calibration }: { calibration: Calibration }) {
  const { session, isConnected, isArmed } = useBench();
  const [values, setValues] = useState<Record<string, string>>({});
  const [said, setSaid] = useState({ text: "", isGood: true });
  const task = useTask();
  const { name, summary, preparation, effects, moves, values: fields } = calibration;
  const isComplete = fields.every(({ path }) => values[path]?.trim());
  const isPossible = isConnected && !task.isBusy && isComplete;
  const check = (): Promise<unknown> =>
    task.run(async (progress) => {
      const problem = await session.do("check", [name], progress);
      setSaid({ text: problem ? `Not ready: ${problem}` : "The gimbal is ready.", isGood: !problem });
    });
  const calibrate = (): Promise<unknown> =>
    task.run(async (progress) => {
      setSaid({ text: "", isGood: true });
      await session.do("calibrate", [name, values], progress);
      setSaid({ text: "The calibration is done.", isGood: true });
    });
  return (
    <details class="topic">
      <summary>
        <b>{summary.replace(/\.$/, "")}</b> <span class="muted">{name}</span>
      </summary>
      <ol>
        <li>
          <b>Prepare.</b> {preparation || "Nothing needs to be prepared."}
        </li>
        {fields.length > 0 && (
          <li>
            <b>Enter.</b>{" "}
            {fields.map(({ path, unit, summary: meaning, names }) => {
              const label = `${meaning || path}${unit && `, ${unit}`}`;
              const value = values[path] ?? "";
              const set = (text: string): void => setValues({ ...values, [path]: text });
              if (names.length === 0) {
                return <TextInput key={path} label={label} value={value} onChange={set} />;
              }
              return (
                <label key={path}>
                  {label}{" "}
                  <Select label={label} options={["", ...names]} value={value} onChange={set} />
                </label>
              );
            })}
          </li>
        )}
        <li>
          <b>Check</b> that the gimbal is as the calibration expects it.
        </li>
        <li>
          <b>Calibrate.</b> {effects} Keep your hands off, unless a step says otherwise.
        </li>
      </ol>
      {moves && <ArmSwitch>The motors turn the camera during this calibration.</ArmSwitch>}
      <div class="flow row">
        <Button look="plain quiet" disabled={!isPossible} onClick={check}>Check</Button>
        <AskButton
          action="Calibrate"
          question={`Calibrate: ${name}?`}
          disabled={!isPossible || (moves && !isArmed)}
          onAgree={calibrate}
        >
          <p>
            {summary} {effects}
          </p>
          {preparation && <p>Before: {preparation}</p>}
        </AskButton>
      </div>
      <TaskState task={task} onCancel={() => session.end("cancel")} />
      <p class={said.isGood ? "good" : "bad"} role="status">
        {said.text}
      </p>
    </details>
  );
}

const gainLimits: Limits = { least: 0, most: 100, step: 1, usual: 50 };

function TunePanel() {
  const { session, isArmed, setUndo } = useBench();
  const [axes, setAxes] = useState<[boolean, boolean, boolean]>([true, true, true]);
  const [gain, setGain] = useState(gainLimits.usual);
  const [chosen, setChosen] = useState(0);
  const [isDone, setDone] = useState(false);
  const task = useTask();
  const active = useView(1)?.profile ?? 1;
  const profile = chosen || active;
  const names = axisNames.filter((_, n) => axes[n]).join(", ");
  const tune = (): Promise<unknown> =>
    task.run(async (progress) => {
      setDone(false);
      setUndo(true); // also of what a tuning that fails has stored
      await session.do("tune", [axes, gain, profile], progress);
      setDone(true);
    });
  return (
    <section aria-labelledby="tune-title">
      <h2 id="tune-title">Tune the controllers</h2>
      <ArmSwitch>
        The board shakes the camera about {names || "no axis"} for some minutes and stores new gains
        in profile {profile}. Balance the camera, fasten the frame and keep your hands off.
      </ArmSwitch>
      <div class="flow row">
        {axisNumbers.map((n) => (
          <Check
            key={n}
            label={axisNames[n]}
            checked={axes[n]}
            onChange={(on) => setAxes(axes.map((one, m) => (m === n ? on : one)) as typeof axes)}
          />
        ))}
        <label>
          Profile{" "}
          <Select
            label="Profile to tune"
            options={[1, 2, 3, 4, 5]}
            value={profile}
            onChange={(one) => setChosen(Number(one))}
          />
        </label>
      </div>
      <SliderRow label="Gain" unit="%" limits={gainLimits} value={gain} onChange={setGain} />
      <p class="muted small says">A low gain is stable, a high one holds the camera more firmly.</p>
      <Button disabled={!isArmed || task.isBusy || !names} onClick={tune}>Tune</Button>
      <TaskState task={task} onCancel={() => session.end("cancel")} />
      {isDone && (
        <p class="good" role="status">
          The board has stored new gains. Read the parameters to see them; “Undo the last write” is
          beside them.
        </p>
      )}
    </section>
  );
}

const axes = axisNames.map((axis) => [axis, axis] as const);
/** Of the noise that shakes the axis; as `sbgc bode` takes it. */
const limits = {
  gain: { least: 1, most: 10_000, step: 1, usual: 1000 },
  from: { least: 1, most: 500, step: 1, usual: 3 },
  to: { least: 1, most: 500, step: 1, usual: 200 },
};
const titles = { gain: "Gain", from: "From", to: "To" };
const curves = [
  { key: "gain", title: "Gain by frequency", unit: " dB", isResponse: true },
  { key: "phase", title: "Phase by frequency", unit: "°", isResponse: true },
] as const;

function BodePanel() {
  const { session, isArmed } = useBench();
  const [axis, setAxis] = useState<AxisName>("roll");
  const [response, setResponse] = useState<Response | null>(null);
  const [noise, setNoise] = useState({ gain: limits.gain.usual, from: limits.from.usual, to: limits.to.usual });
  const task = useTask();
  const { gain, from, to } = noise;
  const record = (): Promise<void> =>
    task
      .run((progress) => session.do("bode", [axisNames.indexOf(axis), gain, from, to], progress))
      .then(setResponse);
  return (
    <section aria-labelledby="bode-title">
      <h2 id="bode-title">Frequency response</h2>
      <ArmSwitch>
        The {axis} axis shakes for some seconds, from {from} to {to} Hz with a gain of {gain}, and
        no command ends that. Begin with a gain of 1000. Fasten the frame and keep your hands off.
      </ArmSwitch>
      <Choice class="axes" legend="Axis" options={axes} value={axis} onChange={setAxis} />
      {(["gain", "from", "to"] as const).map((name) => (
        <SliderRow
          key={name}
          label={titles[name]}
          unit={name === "gain" ? "" : "Hz"}
          limits={limits[name]}
          value={noise[name]}
          onChange={(value) => setNoise({ ...noise, [name]: value })}
        />
      ))}
      <div class="flow row">
        <Button disabled={!isArmed || task.isBusy} onClick={record}>Record the response</Button>
        {response && (
          <Button look="plain quiet" onClick={() => download(response.csv, "csv")}>
            Save as CSV
          </Button>
        )}
      </div>
      <TaskState task={task} />
      {response && <Curves key={response.csv} response={response} />}
    </section>
  );
}

function Curves({ response }: { response: Response }) {
  const place = useRef<HTMLDivElement>(null);
  const figures = usePlots(place, curves, (plots) =>
    curves.forEach(({ key }, n) => plots[n]?.draw([response.frequency, response[key]])),
  );
  return <div class="stacked">{figures}</div>;
}
