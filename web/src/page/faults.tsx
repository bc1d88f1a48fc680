// Switches for the faults of the board and of the line.

import type { ComponentChildren } from "preact";

import { axisNames } from "./axes.js";
import type { PanelProps } from "./controls.js";
import { faults, lineFaults, type Part } from "./emulation.js";
import { Check, NumberInput, Select } from "./inputs.js";

const usualShare = 0.001;

export function FaultPanel({ values, set }: PanelProps) {
  const choose = (name: string, parts: readonly string[] | null): void => {
    const { [name]: _, ...others } = values.faults;
    set({ faults: parts ? { ...others, [name]: parts } : others });
  };
  return (
    <section aria-labelledby="faults-title">
      <h2 id="faults-title">Faults</h2>
      <div class="fault-columns">
        <fieldset class="faults">
          <legend class="muted small">Of the gimbal</legend>
          {faults.map(({ name, label, parts: known }) => {
            const parts = values.faults[name];
            const usual = known.map((part) => part.usual);
            const change = (at: number, text: string): void =>
              choose(name, (parts ?? usual).map((one, n) => (n === at ? text : one)));
            return (
              <Switch
                key={name}
                label={label}
                isOn={parts !== undefined}
                onChange={() => choose(name, parts ? null : usual)}
              >
                {known.map((part, n) => (
                  <PartInput
                    key={n}
                    label={`${label}: ${part.limits?.unit ?? "axis"}`}
                    part={part}
                    value={parts?.[n] ?? part.usual}
                    onChange={(text) => change(n, text)}
                  />
                ))}
              </Switch>
            );
          })}
        </fieldset>
        <fieldset class="faults">
          <legend class="muted small">Of the line</legend>
          {lineFaults.map(({ key, label }) => (
            <Switch
              key={key}
              label={label}
              isOn={values[key] > 0}
              onChange={() => set({ [key]: values[key] > 0 ? 0 : usualShare })}
            >
              <NumberInput
                label={`${label}: share`}
                limits={{ least: 0.001, most: 100 }}
                value={Number((values[key] * 100).toPrecision(6))}
                onChange={(percent) => set({ [key]: percent / 100 })}
              />
              <span class="muted small">%</span>
            </Switch>
          ))}
        </fieldset>
      </div>
    </section>
  );
}

interface SwitchProps {
  label: string;
  isOn: boolean;
  onChange: () => void;
  /** Its parameters, which can be set while it is on. */
  children: ComponentChildren;
}

const Switch = ({ label, isOn, onChange, children }: SwitchProps) => (
  <div class="flow fault">
    <Check label={label} checked={isOn} onChange={onChange} />
    {isOn && <span class="flow">{children}</span>}
  </div>
);

interface PartProps {
  label: string;
  part: Part;
  value: string;
  onChange: (text: string) => void;
}

function PartInput({ label, part: { limits }, value, onChange }: PartProps) {
  const shared = { label, value };
  if (!limits) return <Select {...shared} options={axisNames} onChange={onChange} />;
  const change = (one: number): void => onChange(String(one));
  return (
    <>
      <NumberInput {...shared} limits={limits} value={Number(value)} onChange={change} />
      <span class="muted small">{limits.unit}</span>
    </>
  );
}
