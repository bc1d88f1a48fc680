// The state of the gimbal: the line at the top, with the board, its battery, the errors that it
// reports and the button that stops; and the numbers of its axes.

import type { ComponentChildren } from "preact";

import { type AxisName, angleWords, axisNames, axisNumbers, fixed } from "./axes.js";
import { useView } from "./session.js";

const perSecond = 4;
const paces = [0, 0.25, 1, 4, 16];

interface Props {
  title: string;
  onStop: () => void;
  children?: ComponentChildren;
}

export function Status({ title, onStop, children }: Props) {
  const view = useView(perSecond);
  return (
    <div class="flow status">
      <p class="flow board">
        <b>{title}</b>
        {view && (
          <>
            <span class={view.motorsOn ? "good" : "warn"}>
              {view.motorsOn ? "motors on" : "motors off"}
            </span>
            <span>profile {view.profile}</span>
            <span>{fixed(view.volts)} V</span>
            <span>{fixed(view.amperes, 2)} A</span>
            <span>{fixed(view.seconds)} s</span>
          </>
        )}
        {view?.errors.map((error) => (
          <code class="bad" key={error}>
            {error}
          </code>
        ))}
      </p>
      {children}
      <StopButton onStop={onStop} />
    </div>
  );
}

export const StopButton = ({ onStop }: { onStop: () => void }) => (
  <button type="button" class="plain stop" onClick={onStop}>
    Stop <kbd>Esc</kbd>
  </button>
);

/** How quickly the time of an emulated board passes. */
export const Pace = ({ pace, onPace }: { pace: number; onPace: (pace: number) => void }) => (
  <label class="check pace">
    Time
    <select value={pace} onChange={(event) => onPace(Number(event.currentTarget.value))}>
      {paces.map((one) => (
        <option key={one} value={one}>
          {one === 0 ? "paused" : `× ${one}`}
        </option>
      ))}
    </select>
  </label>
);

const numbersPerSecond = 8;
const angle = (value: number, axis: AxisName): string => angleWords(axis, value);
const columns = [
  ["Camera", "camera", angle],
  ["Target", "targets", angle],
  ["Frame", "frame", angle],
  ["Joint", "joints", (value: number) => `${fixed(value)}°`],
  ["Speed", "speeds", (value: number) => `${fixed(value)}°/s`],
  ["Power", "power", (value: number) => `${fixed(value * 100, 0)} %`],
] as const;

export function Numbers() {
  const view = useView(numbersPerSecond);
  return (
    <table class="numbers">
      <caption class="hidden">Angles, speeds and powers of the gimbal</caption>
      <thead>
        <tr>
          <td></td>
          {columns.map(([title]) => (
            <th key={title} scope="col">
              {title}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {axisNumbers.map((n) => {
          const axis = axisNames[n];
          return (
            <tr key={axis}>
              <th scope="row">
                <i class={`swatch ${axis}`} /> {axis}
              </th>
              {columns.map(([title, of, text]) => (
                <td key={title}>{view ? text(view[of][n], axis) : "–"}</td>
              ))}
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
