// The frequency response of an axis: recorded, drawn and saved.

import { useEffect, useRef, useState } from "preact/hooks";

import type { Response } from "../../setup_messages.js";
import { axisNames, type AxisName } from "../axes.js";
import { Choice } from "../inputs.js";
import { onThemeChange } from "../theme.js";
import { ArmSwitch, download, TaskState } from "./parts.js";
import { useBench, useTask } from "./setup_session.js";

const axes = [
  ["roll", "Roll"],
  ["pitch", "Pitch"],
  ["yaw", "Yaw"],
] as const;

export function BodePanel() {
  const { session, isArmed } = useBench();
  const [axis, setAxis] = useState<AxisName>("roll");
  const [response, setResponse] = useState<Response | null>(null);
  const task = useTask();
  const record = async (): Promise<void> => {
    const asked = { axis: axisNames.indexOf(axis) };
    setResponse(await task.run((progress) => session.get("bode", asked, progress)));
  };
  return (
    <section aria-labelledby="bode-title">
      <h2 id="bode-title">Frequency response</h2>
      <ArmSwitch>
        The board shakes the {axis} axis for some seconds, and no command ends that early. Fasten
        the frame and keep your hands off.
      </ArmSwitch>
      <Choice class="axes" legend="Axis" options={axes} value={axis} onChange={setAxis} />
      <div class="do">
        <button
          type="button"
          class="plain"
          disabled={!isArmed || task.isBusy}
          onClick={() => void record()}
        >
          Record the response
        </button>
        {response && (
          <button
            type="button"
            class="plain quiet"
            onClick={() => download(response.csv, "csv")}
          >
            Save as CSV
          </button>
        )}
      </div>
      <TaskState task={task} hasCancel />
      {response && <Curves response={response} />}
    </section>
  );
}

const curves = [
  { key: "gain", title: "Gain", unit: " dB" },
  { key: "phase", title: "Phase", unit: "°" },
] as const;

function Curves({ response }: { response: Response }) {
  const place = useRef<HTMLDivElement>(null);
  const [problem, setProblem] = useState("");
  useEffect(() => {
    const boxes = [...(place.current?.querySelectorAll<HTMLElement>("[data-chart]") ?? [])];
    let ends: (() => void)[] = [];
    let isEnded = false;
    const make = async (): Promise<void> => {
      try {
        const { createPlot } = await import("../plot.js");
        if (isEnded) return;
        for (const end of ends) end();
        ends = curves.map(({ key, unit }, n) => {
          const plot = createPlot(boxes[n] as HTMLElement, { unit, isResponse: true });
          plot.draw([response.frequency, response[key]]);
          return plot.end;
        });
      } catch (error) {
        setProblem(`The curves could not be loaded: ${String(error)}`);
      }
    };
    void make();
    const endTheme = onThemeChange(() => void make());
    return () => {
      isEnded = true;
      endTheme();
      for (const end of ends) end();
    };
  }, [response]);
  return (
    <div class="charts" ref={place}>
      {problem && <p class="bad">{problem}</p>}
      {curves.map(({ key, title }) => (
        <figure key={key}>
          <figcaption>{title} by frequency</figcaption>
          <div data-chart={title} role="img" aria-label={`${title} by frequency`} />
        </figure>
      ))}
    </div>
  );
}
