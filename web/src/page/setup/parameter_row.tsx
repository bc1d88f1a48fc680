// A parameter: its name and meaning, its value to change, what is possible, and what is usual.

import { useId } from "preact/hooks";

import type { Parameter } from "../../setup_messages.js";
import { Button, Check, SmallButton } from "../inputs.js";

/** Numbers are edited without their unit, which stands beside them. */
const bare = (text: string, unit: string): string =>
  unit && text.endsWith(` ${unit}`) ? text.slice(0, -unit.length - 1) : text;
const isNumber = (text: string): boolean => text.trim() !== "" && Number.isFinite(Number(text));
const whole = (text: string, unit: string): string =>
  unit && isNumber(text) ? `${text.trim()} ${unit}` : text;

/** Without the noise of floating point. */
const short = (value: number): string => String(Number(value.toPrecision(7)));
function rangeOf({ least, most }: Parameter): string {
  if (least !== null && most !== null) return `${short(least)} to ${short(most)}`;
  if (least !== null) return `from ${short(least)}`;
  return most === null ? "" : `to ${short(most)}`;
}

function isOutside({ kind, least, most, unit }: Parameter, text: string): boolean {
  const value = Number(bare(text, unit));
  if (kind !== "number" || !isNumber(bare(text, unit))) return false;
  return value < (least ?? -Infinity) || value > (most ?? Infinity);
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
  const change = (now: string): void => onEdit(now === text ? undefined : now);
  const range = rangeOf(parameter);
  const isWrong = edit !== undefined && isOutside(parameter, edit);
  const wrong = problem ?? (isWrong ? `Possible: ${range}` : "");
  return (
    <div class={edit === undefined ? "parameter" : "parameter changed"}>
      <div>
        <label for={id}>{path}</label> {summary}
        {general && <span class="muted"> The same in all profiles.</span>}
      </div>
      <div class="row">
        <Field id={id} parameter={parameter} value={edit ?? text} wrong={wrong} onChange={change} />
        {edit !== undefined && (
          <SmallButton label={`was ${text}; back: ${path}`} onClick={() => onEdit(undefined)}>
            was {text}
          </SmallButton>
        )}
        {wrong && (
          <p class="bad" id={`${id}-wrong`}>
            {wrong}
          </p>
        )}
      </div>
      <div class="row muted">
        <span>{range}</span>
        {usual && (
          <span>
            default{" "}
            <Button
              look="usual"
              label={`The default, ${usual}: ${path}`}
              onClick={() => change(usual)}
            >
              {usual}
            </Button>
          </span>
        )}
      </div>
    </div>
  );
}

interface FieldProps {
  id: string;
  parameter: Parameter;
  value: string;
  wrong: string;
  onChange: (text: string) => void;
}

function Field({ id, parameter, value, wrong, onChange }: FieldProps) {
  const { kind, names, unit, path } = parameter;
  const state = { "aria-invalid": wrong !== "", "aria-describedby": wrong && `${id}-wrong` };
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
        {...state}
        type="text"
        inputMode={kind === "number" ? "decimal" : "text"}
        autocomplete="off"
        value={bare(value, unit)}
        onInput={(event) => onChange(whole(event.currentTarget.value, unit))}
      />
      {unit && <span class="unit">{unit}</span>}
    </>
  );
}
