// The motion of the frame that carries the gimbal.

import { CodeLine } from "./actions.js";
import type { PanelProps } from "./controls.js";
import { motions } from "./emulation.js";
import { SliderRow } from "./inputs.js";
import { emulateLines } from "./lines.js";
import { emulationOf } from "./values.js";

const titles = { rest: "At rest", handheld: "Hand-held", drone: "Drone", vehicle: "Vehicle" };

export function MotionPanel({ values, set }: PanelProps) {
  return (
    <section aria-labelledby="motion-title">
      <h2 id="motion-title">Motion of the frame</h2>
      <fieldset class="choice">
        <legend class="hidden">Motion of the frame</legend>
        {motions.map((motion) => (
          <label key={motion}>
            <input
              type="radio"
              name="motion"
              checked={values.motion === motion}
              onChange={() => set({ motion })}
            />
            <span>{titles[motion]}</span>
          </label>
        ))}
      </fieldset>
      <SliderRow
        label="Strength"
        unit="×"
        limits={{ least: 0, most: 5, step: 0.1, usual: 1 }}
        value={values.strength}
        onChange={(strength) => set({ strength })}
      />
      <CodeLine lines={emulateLines(emulationOf(values))} about="the same board on your computer" />
    </section>
  );
}
