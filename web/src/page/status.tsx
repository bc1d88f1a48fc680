// The line at the top: the board, its battery, the errors that it reports, and the pace of time.

import { fixed } from "./axes.js";
import { useDesk, useView } from "./session.js";

const perSecond = 4;
const paces = [0, 0.25, 1, 4, 16];

interface Props {
  identity: string;
  pace: number;
  onPace: (pace: number) => void;
  onRestart: () => void;
  onStop: () => void;
}

export function Status({ identity, pace, onPace, onRestart, onStop }: Props) {
  const { session } = useDesk();
  const view = useView(perSecond);
  const choosePace = (factor: number): void => {
    session.pace(factor);
    onPace(factor);
  };
  return (
    <div class="status">
      <p class="board">
        <span class="identity">{identity || "The board starts…"}</span>
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
      <label class="pace">
        Time
        <select
          value={pace}
          onChange={(event) => choosePace(Number(event.currentTarget.value))}
        >
          {paces.map((one) => (
            <option key={one} value={one}>
              {one === 0 ? "paused" : `× ${one}`}
            </option>
          ))}
        </select>
      </label>
      <button type="button" class="plain quiet small" onClick={onRestart}>
        New board
      </button>
      <button type="button" class="plain stop" onClick={onStop}>
        Stop <kbd>Esc</kbd>
      </button>
    </div>
  );
}
