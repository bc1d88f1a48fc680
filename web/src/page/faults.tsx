// Switches for the faults of the board and of the line.

import type { PanelProps } from "./controls.js";
import { axisNames } from "./axes.js";
import { faults, lineFaults, type Fault, type Part } from "./emulation.js";
import { NumberInput } from "./inputs.js";

const usualShare = 0.001;

export function FaultPanel({ values, set }: PanelProps) {
  const chosen = values.faults;
  const choose = (fault: Fault, parts: readonly string[] | null): void => {
    const { [fault.name]: _, ...others } = chosen;
    set({ faults: parts ? { ...others, [fault.name]: parts } : others });
  };
  return (
    <section aria-labelledby="faults-title">
      <h2 id="faults-title">Faults</h2>
      <div class="fault-columns">
        <fieldset class="faults">
          <legend>Of the gimbal</legend>
          {faults.map((fault) => (
            <FaultRow
              key={fault.name}
              fault={fault}
              parts={chosen[fault.name] ?? null}
              onChange={(parts) => choose(fault, parts)}
            />
          ))}
        </fieldset>
        <fieldset class="faults">
          <legend>Of the line</legend>
          {lineFaults.map(({ key, label }) => (
            <div class="fault" key={key}>
              <label>
                <input
                  type="checkbox"
                  checked={values[key] > 0}
                  onChange={() => set({ [key]: values[key] > 0 ? 0 : usualShare })}
                />
                <span>{label}</span>
              </label>
              {values[key] > 0 && (
                <span class="parts">
                  <NumberInput
                    label={`${label}: share`}
                    limits={{ least: 0.001, most: 100, step: 0.01 }}
                    value={Number((values[key] * 100).toPrecision(6))}
                    onChange={(percent) => set({ [key]: percent / 100 })}
                  />
                  <span class="unit">%</span>
                </span>
              )}
            </div>
          ))}
        </fieldset>
      </div>
    </section>
  );
}

interface RowProps {
  fault: Fault;
  /** null: the fault is off. */
  parts: readonly string[] | null;
  onChange: (parts: readonly string[] | null) => void;
}

function FaultRow({ fault, parts, onChange }: RowProps) {
  const usual = fault.parts.map((part) => part.usual);
  return (
    <div class="fault">
      <label>
        <input
          type="checkbox"
          checked={parts !== null}
          onChange={() => onChange(parts ? null : usual)}
        />
        <span>{fault.label}</span>
      </label>
      {parts && parts.length > 0 && (
        <span class="parts">
          {fault.parts.map((part, n) => (
            <PartInput
              key={n}
              label={`${fault.label}: ${part.limits?.unit ?? "axis"}`}
              part={part}
              value={parts[n] ?? part.usual}
              onChange={(text) => onChange(parts.map((one, m) => (m === n ? text : one)))}
            />
          ))}
        </span>
      )}
    </div>
  );
}

interface PartProps {
  label: string;
  part: Part;
  value: string;
  onChange: (text: string) => void;
}

function PartInput({ label, part, value, onChange }: PartProps) {
  if (!part.limits) {
    return (
      <select
        aria-label={label}
        value={value}
        onChange={(event) => onChange(event.currentTarget.value)}
      >
        {axisNames.map((axis) => (
          <option key={axis}>{axis}</option>
        ))}
      </select>
    );
  }
  return (
    <>
      <NumberInput
        label={label}
        limits={part.limits}
        value={Number(value)}
        onChange={(one) => onChange(String(one))}
      />
      <span class="unit">{part.limits.unit}</span>
    </>
  );
}
