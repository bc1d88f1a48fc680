// A parameter: its name and meaning, its value to change, what is possible, and what is usual.

import { useId } from "preact/hooks";

import type { Parameter } from "../../setup_messages.js";

/** Numbers are edited without their unit, which stands beside them. */
const bare = (text: string, unit: string): string =>
  unit && text.endsWith(` ${unit}`) ? text.slice(0, -unit.length - 1) : text;
const isNumber = (text: string): boolean => text.trim() !== "" && Number.isFinite(Number(text));
const whole = (text: string, unit: string): string =>
  unit && isNumber(text) ? `${text.trim()} ${unit}` : text;

function rangeOf({ least, most }: Parameter): string {
  if (least !== null && most !== null) return `${least} to ${most}`;
  if (least !== null) return `from ${least}`;
  return most === null ? "" : `to ${most}`;
}

const isOutside = ({ kind, least, most, unit }: Parameter, text: string): boolean => {
  const value = bare(text, unit);
  if (kind !== "number" || !isNumber(value)) return false;
  return (least !== null && Number(value) < least) || (most !== null && Number(value) > most);
};

interface Props {
  parameter: Parameter;
  /** The changed value; undefined if it is as it was read. */
  edit: string | undefined;
  problem: string | undefined;
  onEdit: (text: string | undefined) => void;
}

export function ParameterRow({ parameter, edit, problem, onEdit }: Props) {
  const id = useId();
  const { path, summary, text, general } = parameter;
  const change = (now: string): void => onEdit(now === text ? undefined : now);
  const range = rangeOf(parameter);
  const wrong = problem ?? (edit && isOutside(parameter, edit) ? `Possible: ${range}` : undefined);
  const usual = parameter.default;
  return (
    <div class={edit === undefined ? "parameter" : "parameter changed"}>
      <div class="meaning">
        <label for={id}>{path}</label> <span id={`${id}-summary`}>{summary}</span>
        {general && <span class="muted"> The same in all profiles.</span>}
      </div>
      <div class="value">
        <Field
          id={id}
          parameter={parameter}
          value={edit ?? text}
          isWrong={wrong !== undefined}
          onChange={change}
        />
        {edit !== undefined && (
          <button
            type="button"
            class="plain quiet small"
            aria-label={`Back to ${text}: ${path}`}
            onClick={() => onEdit(undefined)}
          >
            was {text || "empty"}
          </button>
        )}
        {wrong && (
          <p class="bad" id={`${id}-problem`}>
            {wrong}
          </p>
        )}
      </div>
      <div class="facts">
        {range && <span>{range}</span>}
        {usual && (
          <span>
            default{" "}
            <button
              type="button"
              class="usual"
              aria-label={`The default, ${usual}: ${path}`}
              onClick={() => change(usual)}
            >
              {usual}
            </button>
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
  isWrong: boolean;
  onChange: (text: string) => void;
}

function Field({ id, parameter, value, isWrong, onChange }: FieldProps) {
  const { kind, names, unit, path } = parameter;
  const described = {
    id,
    "aria-describedby": isWrong ? `${id}-problem` : `${id}-summary`,
    "aria-invalid": isWrong,
  };
  if (kind === "enum") {
    const isKnown = names.some(([name]) => name === value);
    return (
      <select
        {...described}
        value={value}
        onChange={(event) => onChange(event.currentTarget.value)}
      >
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
    const toggle = (name: string): void => {
      const now = set.includes(name) ? set.filter((one) => one !== name) : [...set, name];
      // In the order of the names, so that a change back is none.
      const order = (one: string): number => {
        const at = names.findIndex(([known]) => known === one);
        return at < 0 ? names.length : at;
      };
      onChange(now.sort((a, b) => order(a) - order(b)).join("|") || "0");
    };
    return (
      <details class="flags">
        <summary id={id}>{set.join(", ") || "none"}</summary>
        <fieldset>
          <legend class="hidden">{path}</legend>
          {names.map(([name, summary]) => (
            <label key={name} title={summary}>
              <input type="checkbox" checked={set.includes(name)} onChange={() => toggle(name)} />
              {name}
            </label>
          ))}
        </fieldset>
      </details>
    );
  }
  return (
    <>
      <input
        {...described}
        type="text"
        inputMode={kind === "number" ? "decimal" : "text"}
        class={kind === "number" ? "number" : ""}
        spellcheck={false}
        autocomplete="off"
        value={bare(value, unit)}
        onInput={(event) => onChange(whole(event.currentTarget.value, unit))}
      />
      {unit && <span class="unit">{unit}</span>}
    </>
  );
}
