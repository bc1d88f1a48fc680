// The frequency response of an axis: recorded, drawn and saved.

import { useRef, useState } from "preact/hooks";

import type { Response } from "../../setup_messages.js";
import { axisNames, type AxisName } from "../axes.js";
import { usePlots } from "../charts.js";
import { Button, Choice, SliderRow } from "../inputs.js";
import { ArmSwitch, download, TaskState } from "./parts.js";
import { useBench, useTask } from "./setup_session.js";

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

export function BodePanel() {
  const { session, isArmed } = useBench();
  const [axis, setAxis] = useState<AxisName>("roll");
  const [response, setResponse] = useState<Response | null>(null);
  const [noise, setNoise] = useState({ gain: limits.gain.usual, from: limits.from.usual, to: limits.to.usual });
  const task = useTask();
  const record = (): Promise<void> =>
    task
      .run((progress) => session.get("bode", { axis: axisNames.indexOf(axis), ...noise }, progress))
      .then(setResponse);
  return (
    <section aria-labelledby="bode-title">
      <h2 id="bode-title">Frequency response</h2>
      <ArmSwitch>
        The {axis} axis shakes for some seconds, from {noise.from} to {noise.to} Hz with a gain of{" "}
        {noise.gain}, and no command ends that. Begin with a gain of 1000. Fasten the frame and keep
        your hands off.
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
      <div class="row">
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
  const problem = usePlots(place, curves, (plots) =>
    curves.forEach(({ key }, n) => plots[n]?.draw([response.frequency, response[key]])),
  );
  return (
    <div class="charts stacked" ref={place}>
      {problem && <p class="bad">{problem}</p>}
      {curves.map(({ key, title }) => (
        <figure key={key}>
          <figcaption>{title}</figcaption>
          <div data-chart={title} role="img" aria-label={title} />
        </figure>
      ))}
    </div>
  );
}
