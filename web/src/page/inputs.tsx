// Inputs: numbers, with a slider or without, and choices.

import type { ComponentChildren } from "preact";
import { useEffect, useId, useState } from "preact/hooks";

import type { Limits } from "./values.js";

interface InputProps {
  id?: string;
  label?: string;
  limits: { least: number; most: number };
  value: number;
  onChange: (value: number) => void;
}

/** Keeps what is typed; takes a value that is within the limits. */
export function NumberInput({ id, label, limits, value, onChange }: InputProps) {
  const [text, setText] = useState(String(value));
  const { least, most } = limits;
  const isValid = (one: string): boolean =>
    one.trim() !== "" && Number(one) >= least && Number(one) <= most;
  useEffect(() => {
    if (Number(text) !== value) setText(String(value));
  }, [value]);
  const type = (now: string): void => {
    setText(now);
    if (isValid(now)) onChange(Number(now));
  };
  return (
    <input
      {...(label ? { "aria-label": label } : { id })}
      type="number"
      min={least}
      max={most}
      step="any"
      value={text}
      aria-invalid={!isValid(text)}
      onInput={(event) => type(event.currentTarget.value)}
      onBlur={() => setText(String(value))}
    />
  );
}

interface SliderProps extends InputProps {
  label: string;
  unit: string;
  limits: Limits;
  describe?: (value: number) => string;
}

export function SliderRow({ label, unit, limits, value, describe, onChange }: SliderProps) {
  const id = useId();
  return (
    <div class="slider">
      <label for={id}>{label}</label>
      <input
        type="range"
        min={limits.least}
        max={limits.most}
        step={limits.step}
        value={value}
        aria-label={`${label}, slider`}
        aria-valuetext={describe?.(value) ?? `${value} ${unit}`}
        onInput={(event) => onChange(event.currentTarget.valueAsNumber)}
      />
      <NumberInput id={id} limits={limits} value={value} onChange={onChange} />
      <span class="muted small">{unit}</span>
    </div>
  );
}

interface SelectProps {
  label: string;
  options: readonly (string | number)[];
  value: string | number;
  onChange: (value: string) => void;
}

export const Select = ({ label, options, value, onChange }: SelectProps) => (
  <select
    aria-label={label}
    value={value}
    onChange={(event) => onChange(event.currentTarget.value)}
  >
    {options.map((one) => (
      <option key={one}>{one}</option>
    ))}
  </select>
);

/** The emphasis of a button. */
type Look = "plain" | "plain quiet" | "plain small" | "plain quiet small" | "armed";

interface ButtonProps {
  look?: Look;
  label?: string;
  disabled?: boolean;
  onClick: () => unknown;
  children: ComponentChildren;
}

export const Button = ({ look = "plain", label, onClick, ...rest }: ButtonProps) => (
  <button type="button" class={look} aria-label={label} onClick={() => void onClick()} {...rest} />
);

/** For secondary actions. */
export const SmallButton = (props: ButtonProps) => <Button look="plain quiet small" {...props} />;

interface TextProps {
  label: string;
  type?: "text" | "number" | "url" | "password";
  placeholder?: string;
  value: string;
  onChange: (text: string) => void;
}

export const TextInput = ({ label, onChange, type = "text", ...rest }: TextProps) => (
  <label>
    {label}{" "}
    <input
      type={type as "text"} // Preact types each kind apart
      autocomplete="off"
      {...rest}
      onInput={(event) => onChange(event.currentTarget.value)}
    />
  </label>
);

interface CheckProps {
  label: string;
  checked: boolean;
  title?: string;
  onChange: (checked: boolean) => void;
}

export const Check = ({ label, title, checked, onChange }: CheckProps) => (
  <label class="check" title={title}>
    <input
      type="checkbox"
      checked={checked}
      onChange={(event) => onChange(event.currentTarget.checked)}
    />
    <span>{label}</span>
  </label>
);

interface ChoiceProps<T extends string> {
  class: string;
  legend: string;
  options: readonly (readonly [T, string])[];
  value: T;
  onChange: (value: T) => void;
}

/** A choice of one of several visible options. */
export function Choice<T extends string>(props: ChoiceProps<T>) {
  const name = useId();
  return (
    <fieldset class={`flow choice ${props.class}`}>
      <legend>{props.legend}</legend>
      {props.options.map(([key, title]) => (
        <label key={key}>
          <input
            type="radio"
            name={name}
            checked={props.value === key}
            onChange={() => props.onChange(key)}
          />
          <span>{title}</span>
        </label>
      ))}
    </fieldset>
  );
}
