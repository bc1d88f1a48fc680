// Moves, turns, motors, profiles, and the motion of the frame.

import { useRef } from "preact/hooks";

import type { Axes } from "../worker_messages.js";
import { ActionRow, CodeLine } from "./actions.js";
import { angleWords, axisNames, type AxisName } from "./axes.js";
import { motions } from "./emulation.js";
import { Choice, Select, SliderRow } from "./inputs.js";
import {
  chooseProfile,
  emulateLines,
  motorsOff,
  motorsOn,
  moveTo,
  release,
  stop,
  turn,
} from "./lines.js";
import { useDesk, useView } from "./session.js";
import { numbers, type NumberName, type Values } from "./values.js";

export interface PanelProps {
  values: Values;
  set: (change: Partial<Values>) => void;
}

/** How often the buttons look whether the motors are on. */
const perSecond = 4;
/** The least time between two moves of a slider, in ms. */
const pause = 150;

const moveOf = ({ roll, pitch, yaw, speed }: Values) => moveTo([roll, pitch, yaw], speed);
const speedsOf = (v: Values): Axes => [v["turn-roll"], v["turn-pitch"], v["turn-yaw"]];

interface SlidersProps {
  rows: readonly (readonly [NumberName, string, string])[];
  values: Partial<Values>;
  set: (change: Partial<Values>) => void;
}

/** A row for each value, with its title and unit. */
export const Sliders = ({ rows, values, set }: SlidersProps) => (
  <>
    {rows.map(([name, label, unit]) => (
      <SliderRow
        key={name}
        label={label}
        unit={unit}
        limits={numbers[name]}
        value={values[name] ?? numbers[name].usual}
        {...(unit === "°" ? { describe: (one) => angleWords(name as AxisName, one) } : {})}
        onChange={(value) => set({ [name]: value })}
      />
    ))}
  </>
);

const axisTitles = ["Roll", "Pitch", "Yaw"] as const;
export const angleRows = axisNames.map((axis, n) => [axis, axisTitles[n] ?? "", "°"] as const);
const turnRows = axisNames.map((axis, n) => [`turn-${axis}`, axisTitles[n] ?? "", "°/s"] as const);

export function BoardPanel({ values, set }: PanelProps) {
  const areOn = useView(perSecond)?.motorsOn ?? false;
  return (
    <section aria-labelledby="board-title">
      <h2 id="board-title">Motors and profile</h2>
      <ActionRow action={motorsOn} label="Motors on" isMain={!areOn} />
      <ActionRow action={motorsOff} label="Motors off" />
      <ActionRow action={release} label="Release" />
      <ActionRow action={chooseProfile(values.profile)} label="Profile">
        <Select
          label="Number of the profile"
          options={[1, 2, 3, 4, 5]}
          value={values.profile}
          onChange={(one) => set({ profile: Number(one) })}
        />
      </ActionRow>
    </section>
  );
}

export function MovePanel({ values, set }: PanelProps) {
  const areOn = useView(perSecond)?.motorsOn ?? false;
  const { session, run, isReady } = useDesk();
  const timer = useRef(0);
  const newest = useRef(values);
  newest.current = values;
  /** A slider that is dragged takes the camera along. */
  const follow = (change: Partial<Values>): void => {
    set(change);
    if (!isReady || !areOn || timer.current) return;
    const { asked } = session;
    timer.current = window.setTimeout(() => {
      timer.current = 0;
      // The visitor may have asked for something else in the meantime.
      if (session.asked === asked) run(moveOf(newest.current), "Move");
    }, pause);
  };
  return (
    <section aria-labelledby="move-title">
      <h2 id="move-title">Move</h2>
      <Sliders rows={angleRows} values={values} set={follow} />
      <Sliders rows={[["speed", "Speed", "°/s"]]} values={values} set={set} />
      <ActionRow action={moveOf(values)} label="Move" isMain={areOn} />
      <ActionRow action={moveTo([0, 0, 0], values.speed)} label="Center" />
      <ActionRow action={stop} label="Stop">
        <kbd>Esc</kbd>
      </ActionRow>
    </section>
  );
}

export const TurnPanel = ({ values, set }: PanelProps) => (
  <section aria-labelledby="turn-title">
    <h2 id="turn-title">Turn at a speed</h2>
    <Sliders rows={[...turnRows, ["seconds", "Time", "s"]]} values={values} set={set} />
    <ActionRow action={turn(speedsOf(values), values.seconds)} label="Turn" />
  </section>
);

export const MotionPanel = ({ values, set }: PanelProps) => (
  <section aria-labelledby="motion-title">
    <h2 id="motion-title">Motion of the frame</h2>
    <Choice
      class="motions"
      legend="Motion"
      options={motions}
      value={values.motion}
      onChange={(motion) => set({ motion })}
    />
    <Sliders rows={[["strength", "Strength", "×"]]} values={values} set={set} />
    <CodeLine lines={emulateLines(values)} about="the same board on your computer" />
  </section>
);
