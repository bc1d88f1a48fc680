// Moves and turns a real camera, once motion is armed.

import { useEffect, useState } from "preact/hooks";

import type { Axes, View } from "../../worker_messages.js";
import { ActionRow } from "../actions.js";
import { angleWords, axisNames, axisNumbers, fixed, sides } from "../axes.js";
import { angleRows, Sliders } from "../controls.js";
import { motorsOff, motorsOn, moveTo, release } from "../lines.js";
import { DeskContext, useView } from "../session.js";
import { ArmSwitch, useEvents } from "./parts.js";
import { period, type Hold } from "./hold.js";
import { useBench } from "./setup_session.js";

const perSecond = 4;

/** What `sbgc move` says before it asks. */
function moveSentence(angles: Axes, speed: number, view: View | null): string {
  const now = view?.camera ?? angles;
  const turns = axisNumbers.map((n) => {
    const axis = axisNames[n];
    const by = angles[n] - now[n];
    const way = `${sides[axis][by > 0 ? 0 : 1]} by ${fixed(Math.abs(by))}°`;
    const turn = Number(fixed(by)) === 0 ? "it is there" : `now ${angleWords(axis, now[n])}: ${way}`;
    return `${axis} ${angleWords(axis, angles[n])} (${turn})`;
  });
  const far = axisNumbers.filter((n) => Math.abs(angles[n] - now[n]) > 180);
  const cables = far.map((n) => ` Watch the cables: ${axisNames[n]} turns by more than 180°.`);
  return `The camera turns to ${turns.join(", ")}, at up to ${speed}°/s.${cables.join("")}`;
}

export function MovePanel({ hold }: { hold: Hold }) {
  const bench = useBench();
  const { isArmed } = bench;
  const view = useView(perSecond);
  const [goal, setGoal] = useState({ roll: 0, pitch: 0, yaw: 0, speed: 20 });
  const { roll, pitch, yaw, speed } = goal;
  const angles: Axes = [roll, pitch, yaw];
  const areOn = view?.motorsOn ?? false;
  const set = (change: Partial<typeof goal>): void => setGoal((now) => ({ ...now, ...change }));
  hold.limit = speed;
  return (
    <DeskContext.Provider value={{ ...bench, isReady: isArmed }}>
      <section aria-labelledby="arm-title">
        <h2 id="arm-title">Motion</h2>
        <ArmSwitch>
          Armed, this page moves the real camera, at up to {speed}°/s. Watch the cables, and keep
          hands and lens clear. It is locked again when the line is lost, you disconnect, or this
          page is hidden. <kbd>Esc</kbd> stops the camera at any time.
        </ArmSwitch>
        <Sliders rows={[["speed", "Speed", "°/s"]]} values={goal} set={set} />
        <ActionRow action={motorsOn} label="Motors on" isMain={!areOn} />
        <p class="muted small says">The motors turn on, and the camera jumps to its target angle.</p>
        <ActionRow action={motorsOff} label="Motors off" />
        <p class="muted small says">The motors lose power, and the camera drops to its heavy side.</p>
      </section>
      <section aria-labelledby="move-title">
        <h2 id="move-title">Move</h2>
        <Sliders rows={angleRows} values={goal} set={set} />
        <ActionRow action={moveTo(angles, speed)} label="Move" isMain={areOn} />
        <p class="muted small says">{moveSentence(angles, speed, view)}</p>
        <ActionRow action={moveTo([0, 0, 0], speed)} label="Center" />
        <ActionRow action={release} label="Release" />
      </section>
      <TurnPanel hold={hold} />
    </DeskContext.Provider>
  );
}

interface Way {
  name: string;
  sign: string;
  key: string;
  direction: Axes;
}
const ways: Way[] = [
  { name: "Pitch up", sign: "↑", key: "ArrowUp", direction: [0, -1, 0] },
  { name: "Yaw left", sign: "←", key: "ArrowLeft", direction: [0, 0, -1] },
  { name: "Yaw right", sign: "→", key: "ArrowRight", direction: [0, 0, 1] },
  { name: "Pitch down", sign: "↓", key: "ArrowDown", direction: [0, 1, 0] },
  { name: "Roll left", sign: "↺", key: "", direction: [-1, 0, 0] },
  { name: "Roll right", sign: "↻", key: "", direction: [1, 0, 0] },
];

function TurnPanel({ hold }: { hold: Hold }) {
  const { isArmed } = useBench();
  useEffect(() => {
    if (!isArmed) return;
    const timer = setInterval(() => hold.tick(), period);
    return () => clearInterval(timer);
  }, [hold, isArmed]);
  useEvents(window, ["blur"], () => hold.releaseAll());
  const pad = navigator.getGamepads?.().find((one) => one !== null)?.id;

  /** The way of an arrow key, or of the button on which Space or Enter is held. */
  const wayOf = ({ key, target }: KeyboardEvent): Way | undefined =>
    ways.find((way) =>
      key === " " || key === "Enter"
        ? target instanceof Element && target.getAttribute("aria-label") === way.name
        : way.key === key,
    );
  const keyed = (event: KeyboardEvent): void => {
    const way = wayOf(event);
    if (!way) return;
    event.preventDefault();
    if (event.type === "keyup") hold.release(`key ${event.key}`);
    else if (!event.repeat && isArmed) hold.press(`key ${event.key}`, way.direction);
  };
  const pressed = (event: PointerEvent, way: Way): void => {
    if (!isArmed || event.button !== 0) return;
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    hold.press(`pointer ${event.pointerId}`, way.direction);
  };
  const lifted = ({ pointerId }: PointerEvent): void => hold.release(`pointer ${pointerId}`);
  return (
    <section aria-labelledby="turn-title">
      <h2 id="turn-title">Turn while you hold</h2>
      <div
        class="pad"
        role="group"
        aria-labelledby="turn-title"
        onKeyDown={keyed}
        onKeyUp={keyed}
        onFocusOut={() => hold.releaseAll()}
      >
        {ways.map((way) => (
          <button
            key={way.name}
            type="button"
            class="plain quiet"
            style={{ gridArea: way.name.toLowerCase().replace(" ", "-") }}
            aria-label={way.name}
            title={way.name}
            disabled={!isArmed}
            onPointerDown={(event) => pressed(event, way)}
            onMouseDown={(event) => event.preventDefault()} // it would move the focus, and so let go
            onPointerUp={lifted}
            onPointerCancel={lifted}
            onLostPointerCapture={lifted}
            onContextMenu={(event) => event.preventDefault()}
          >
            {way.sign}
          </button>
        ))}
        <button type="button" class="plain quiet small" disabled={!isArmed}>
          Arrow keys
        </button>
      </div>
      <p class="muted small says">
        The camera turns as long as a button, an arrow key in this pad, or a gamepad is held, and
        brakes within half a second when the page is gone.{" "}
        {pad
          ? `Gamepad “${pad}”: hold a shoulder button, and tilt the sticks.`
          : "A gamepad counts once one of its buttons was pressed."}
      </p>
    </section>
  );
}
