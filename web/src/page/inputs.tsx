// A number with a slider and an input, which hold the same value.

import { useEffect, useId, useState } from "preact/hooks";

import type { Limits } from "./values.js";

interface NumberProps {
  label: string;
  unit: string;
  limits: Limits;
  value: number;
  describe?: (value: number) => string;
  onChange: (value: number) => void;
}

export function SliderRow({ label, unit, limits, value, describe, onChange }: NumberProps) {
  const id = useId();
  const { least, most, step } = limits;
  const range = { min: least, max: most, step, value };
  return (
    <div class="slider">
      <label for={id}>{label}</label>
      <input
        type="range"
        {...range}
        aria-label={`${label}, slider`}
        aria-valuetext={describe?.(value) ?? `${value} ${unit}`}
        onInput={(event) => onChange(event.currentTarget.valueAsNumber)}
      />
      <NumberInput id={id} label="" limits={limits} value={value} onChange={onChange} />
      <span class="unit">{unit}</span>
    </div>
  );
}

interface InputProps {
  id?: string;
  /** For inputs without a label of their own. */
  label: string;
  limits: Omit<Limits, "usual">;
  value: number;
  onChange: (value: number) => void;
}

/** Keeps what is typed; takes a value that is within the limits. */
export function NumberInput({ id, label, limits, value, onChange }: InputProps) {
  const [text, setText] = useState(String(value));
  const isValid = (one: string): boolean =>
    one.trim() !== "" && Number(one) >= limits.least && Number(one) <= limits.most;
  useEffect(() => {
    if (Number(text) !== value) setText(String(value));
  }, [value]);
  return (
    <input
      type="number"
      {...(id ? { id } : {})}
      {...(label ? { "aria-label": label } : {})}
      min={limits.least}
      max={limits.most}
      step="any"
      value={text}
      aria-invalid={!isValid(text)}
      onInput={(event) => {
        const now = event.currentTarget.value;
        setText(now);
        if (isValid(now)) onChange(Number(now));
      }}
      onBlur={() => setText(String(value))}
    />
  );
}
