// Moves, turns, motors and profiles.

import { useEffect, useRef } from "preact/hooks";

import type { Axes } from "../worker_messages.js";
import { ActionRow, useDesk } from "./actions.js";
import { angleWords, axisNames } from "./axes.js";
import { SliderRow } from "./inputs.js";
import { chooseProfile, motorsOff, motorsOn, moveTo, release, stop, turn } from "./lines.js";
import { useSession, useView } from "./session.js";
import { numbers, type NumberName, type Values } from "./values.js";

export interface PanelProps {
  values: Values;
  set: (change: Partial<Values>) => void;
}

const title = (axis: string): string => axis.charAt(0).toUpperCase() + axis.slice(1);
const targetsOf = ({ roll, pitch, yaw }: Values): Axes => [roll, pitch, yaw];
const speedsOf = (v: Values): Axes => [v["turn-roll"], v["turn-pitch"], v["turn-yaw"]];

/** How often the buttons look whether the motors are on. */
const perSecond = 4;
/** The least time between two moves of a slider, in ms. */
const pause = 150;

export function MovePanel({ values, set }: PanelProps) {
  const session = useSession();
  const areOn = useView(perSecond)?.motorsOn ?? false;
  const { run, isReady } = useDesk();
  const timer = useRef(0);
  const newest = useRef(values);
  newest.current = values;
  const action = moveTo(targetsOf(values), values.speed);
  useEffect(() => () => clearTimeout(timer.current), []);
  /** A slider that is dragged takes the camera along. */
  const follow = (change: Partial<Values>): void => {
    set(change);
    if (!isReady || !session.view?.motorsOn || timer.current) return;
    const { asked } = session;
    timer.current = window.setTimeout(() => {
      timer.current = 0;
      // What the visitor has asked for in the meantime is newer.
      if (session.asked !== asked) return;
      run(moveTo(targetsOf(newest.current), newest.current.speed), "Move");
    }, pause);
  };
  return (
    <section aria-labelledby="move-title">
      <h2 id="move-title">Move</h2>
      {axisNames.map((axis) => (
        <SliderRow
          key={axis}
          label={title(axis)}
          unit="°"
          limits={numbers[axis]}
          value={values[axis]}
          describe={(value) => angleWords(axis, value)}
          onChange={(value) => follow({ [axis]: value })}
        />
      ))}
      <SliderRow
        label="Speed"
        unit="°/s"
        limits={numbers.speed}
        value={values.speed}
        onChange={(speed) => set({ speed })}
      />
      <ActionRow action={action} label="Move" isMain={areOn} />
      <ActionRow action={moveTo([0, 0, 0], values.speed)} label="Center" />
      <ActionRow action={stop} label="Stop">
        <kbd>Esc</kbd>
      </ActionRow>
    </section>
  );
}

export function TurnPanel({ values, set }: PanelProps) {
  return (
    <section aria-labelledby="turn-title">
      <h2 id="turn-title">Turn at a speed</h2>
      {axisNames.map((axis) => {
        const name: NumberName = `turn-${axis}`;
        return (
          <SliderRow
            key={axis}
            label={title(axis)}
            unit="°/s"
            limits={numbers[name]}
            value={values[name]}
            onChange={(value) => set({ [name]: value })}
          />
        );
      })}
      <SliderRow
        label="Time"
        unit="s"
        limits={numbers.seconds}
        value={values.seconds}
        onChange={(seconds) => set({ seconds })}
      />
      <ActionRow action={turn(speedsOf(values), values.seconds)} label="Turn" />
    </section>
  );
}

export function BoardPanel({ values, set }: PanelProps) {
  const areOn = useView(perSecond)?.motorsOn ?? false;
  return (
    <section aria-labelledby="board-title">
      <h2 id="board-title">Motors and profile</h2>
      <ActionRow action={motorsOn} label="Motors on" isMain={!areOn} />
      <ActionRow action={motorsOff} label="Motors off" />
      <ActionRow action={release} label="Release" />
      <ActionRow action={chooseProfile(values.profile)} label="Profile">
        <select
          aria-label="Number of the profile"
          value={values.profile}
          onChange={(event) => set({ profile: Number(event.currentTarget.value) })}
        >
          {[1, 2, 3, 4, 5].map((one) => (
            <option key={one}>{one}</option>
          ))}
        </select>
      </ActionRow>
    </section>
  );
}
