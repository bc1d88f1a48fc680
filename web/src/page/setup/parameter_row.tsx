// A parameter: its name and meaning, its value to change, what is possible, and what is usual.

import { useId } from "preact/hooks";

import type { Parameter } from "../../setup_messages.js";
import { Check, SmallButton } from "../inputs.js";

/** Without the noise of floating point. */
const short = (value: number): string => String(Number(value.toPrecision(7)));
function rangeOf({ least, most }: Parameter): string {
  if (least !== null && most !== null) return `${short(least)} to ${short(most)}`;
  if (least !== null) return `from ${short(least)}`;
  return most === null ? "" : `to ${short(most)}`;
}

interface Props {
  parameter: Parameter;
  /** The changed value; undefined if it is as it was read. */
  edit: string | undefined;
  problem: string | undefined;
  onEdit: (text: string | undefined) => void;
}

export function ParameterRow({ parameter, edit, problem, onEdit }: Props) {
  const id = useId();
  const { path, summary, text, general, default: usual } = parameter;
  return (
    <div class={edit === undefined ? "parameter" : "parameter changed"}>
      <div>
        <label for={id}>{path}</label> {summary}
        {general && <span class="muted"> The same in all profiles.</span>}
      </div>
      <div class="row">
        <Field
          id={id}
          parameter={parameter}
          value={edit ?? text}
          isWrong={problem !== undefined}
          onChange={(now) => onEdit(now === text ? undefined : now)}
        />
        {edit !== undefined && (
          <SmallButton label={`was ${text}; back: ${path}`} onClick={() => onEdit(undefined)}>
            was {text}
          </SmallButton>
        )}
        {problem && (
          <p class="bad" id={`${id}-wrong`}>
            {problem}
          </p>
        )}
      </div>
      <div class="row muted">
        <span>{rangeOf(parameter)}</span>
        {usual && <span>default {usual}</span>}
      </div>
    </div>
  );
}

interface FieldProps {
  id: string;
  parameter: Parameter;
  value: string;
  isWrong: boolean;
  onChange: (text: string) => void;
}

function Field({ id, parameter, value, isWrong, onChange }: FieldProps) {
  const { kind, names, unit, path } = parameter;
  if (kind === "enum") {
    const isKnown = names.some(([name]) => name === value);
    return (
      <select id={id} value={value} onChange={(event) => onChange(event.currentTarget.value)}>
        {!isKnown && <option>{value}</option>}
        {names.map(([name, summary]) => (
          <option key={name} value={name} title={summary}>
            {name}
          </option>
        ))}
      </select>
    );
  }
  if (kind === "flags") {
    const set = value.split("|").filter((one) => one !== "0");
    // In the order of the names, then unknown bits, so that a change back is none.
    const known = names.map(([name]) => name);
    const all = [...known, ...set.filter((one) => !known.includes(one))];
    const toggle = (name: string, on: boolean): void =>
      onChange(all.filter((one) => (one === name ? on : set.includes(one))).join("|") || "0");
    return (
      <details>
        <summary id={id}>{set.join(", ") || "none"}</summary>
        <fieldset>
          <legend class="hidden">{path}</legend>
          {names.map(([name, summary]) => (
            <Check
              key={name}
              label={name}
              title={summary}
              checked={set.includes(name)}
              onChange={(on) => toggle(name, on)}
            />
          ))}
        </fieldset>
      </details>
    );
  }
  return (
    <>
      <input
        id={id}
        type="text"
        aria-invalid={isWrong}
        aria-describedby={isWrong ? `${id}-wrong` : undefined}
        inputMode={kind === "number" ? "decimal" : "text"}
        autocomplete="off"
        value={value}
        onInput={(event) => onChange(event.currentTarget.value)}
      />
      {unit && <span class="unit">{unit}</span>}
    </>
  );
}
