// The parameters of the board by their topics; changes are collected, reviewed and then written.

import { useId, useRef, useState } from "preact/hooks";

import type { Parameter, Plan, Read, Topic, Written } from "../../setup_messages.js";
import { Button, Check, Select, SmallButton } from "../inputs.js";
import { useTask } from "../session.js";
import { download, TaskState } from "./parts.js";
import { Review } from "./review.js";
import { useBench } from "./setup_session.js";

/** Changed values by the name of the parameter, for each profile; 0: the same in all of them. */
type Edits = Record<number, Record<string, string>>;

/** A backup has less. */
const longestFile = 4_000_000;

const has = (needle: string, { name, summary }: Topic, parameter: Parameter): boolean => {
  const text = `${name} ${summary} ${parameter.name} ${parameter.summary}`.toLowerCase();
  return needle.split(/\s+/).every((word) => text.includes(word));
};

export function ParametersPanel() {
  const { session, isConnected, canUndo } = useBench();
  const [read, setRead] = useState<Read | null>(null);
  const [profile, setProfile] = useState(1);
  const [topics, setTopics] = useState<Topic[]>([]);
  const [edits, setEdits] = useState<Edits>({});
  const [plan, setPlan] = useState<Plan | null>(null);
  const [written, setWritten] = useState<Written | null>(null);
  const [needle, setNeedle] = useState("");
  const [onlyChanged, setOnlyChanged] = useState(false);
  const chooser = useRef<HTMLInputElement>(null);
  const task = useTask();

  const show = async (one: number): Promise<void> => {
    setTopics(await session.do("profile", [one]));
    setProfile(one);
  };
  const readAll = (): Promise<unknown> =>
    task.run(async (progress) => {
      const now = await session.do("read", [], progress);
      setRead(now);
      await show(Math.min(profile > 1 ? profile : now.active, now.profiles));
    });
  const choose = (one: number): void => {
    setPlan(null);
    void task.run(() => show(one));
  };
  const values = { ...edits[0], ...edits[profile] };
  const edit = ({ name, general }: Parameter, text: string | undefined): void => {
    const key = general ? 0 : profile;
    const { [name]: _, ...rest } = edits[key] ?? {};
    setEdits({ ...edits, [key]: text === undefined ? rest : { ...rest, [name]: text } });
    setPlan(null);
  };
  /** Whether the changes of the page are under review, and not a file or what undoes a write. */
  const areEdits = useRef(false);
  const review = (work: () => Promise<Plan>, ofEdits = false): void => {
    areEdits.current = ofEdits;
    setWritten(null);
    void task.run(work).then(setPlan);
  };
  const take = (file: File | undefined): void => {
    if (!file || !isConnected) return;
    review(async () => {
      if (file.size > longestFile) throw new Error(`${file.name} is too long for a backup`);
      const content = await file.text();
      const text = file.name.endsWith(".profile") ? elementsOf(content) : content;
      return session.do("planFile", [text, profile]);
    });
  };
  const backup = (): Promise<unknown> =>
    task.run(async (progress) => download(await session.do("backup", [], progress), "json"));
  const end = async (now: Written): Promise<void> => {
    setWritten(now);
    setPlan(null);
    // Changes that failed stay, to try again.
    if (now.ok && areEdits.current) setEdits(({ [0]: _, [profile]: __, ...others }) => others);
    await task.run(() => show(profile));
  };

  const discard = (): void => {
    setEdits({});
    setPlan(null);
  };

  const counts = Object.entries(edits)
    .map(([key, one]) => [key === "0" ? "all profiles" : `profile ${key}`, Object.keys(one).length])
    .flatMap(([where, count]) => (count ? [`${count} changed in ${where}`] : []))
    .join(", ");
  const isPossible = isConnected && !task.isBusy;
  const problems = new Map(plan?.problems);
  return (
    <section
      class="parameters"
      aria-labelledby="parameters-title"
      onDragOver={(event) => read && event.preventDefault()}
      onDrop={(event) => {
        if (!read) return;
        event.preventDefault();
        take(event.dataTransfer?.files[0]);
      }}
    >
      <div class="flow apart head">
        <h2 id="parameters-title">Parameters</h2>
        {!read && (
          <Button disabled={!isPossible} onClick={readAll}>Read the parameters</Button>
        )}
        {read && (
          <div class="flow row">
            <SmallButton disabled={!isPossible} onClick={readAll}>Read again</SmallButton>
            <SmallButton disabled={!isPossible} onClick={backup}>Save a backup</SmallButton>
            <SmallButton disabled={!isPossible} onClick={() => chooser.current?.click()}>
              Open a file
            </SmallButton>
            <input
              ref={chooser}
              hidden
              type="file"
              accept=".json,.profile"
              onChange={({ currentTarget }) => {
                take(currentTarget.files?.[0]);
                currentTarget.value = ""; // the same file may come again
              }}
            />
            <SmallButton
              disabled={!isPossible || !canUndo}
              onClick={() => review(() => session.do("planUndo", []))}
            >
              Undo the last write
            </SmallButton>
          </div>
        )}
      </div>
      <TaskState task={task} />
      {written && (
        <p class={written.ok ? "written good" : "written bad"} role="status">
          {written.text}
        </p>
      )}
      {read && (
        <>
          <div class="flow row">
            <label>
              Profile{" "}
              <Select
                label="Profile of the parameters"
                options={Array.from({ length: read.profiles }, (_, n) => n + 1)}
                value={profile}
                onChange={(one) => choose(Number(one))}
              />
            </label>
            <input
              type="search"
              aria-label="Search the parameters"
              placeholder="Search"
              value={needle}
              onInput={(event) => setNeedle(event.currentTarget.value)}
            />
            <Check label="Only changed" checked={onlyChanged} onChange={setOnlyChanged} />
          </div>
          {plan && (
            <Review plan={plan} onWritten={(now) => void end(now)} onClose={() => setPlan(null)} />
          )}
          {topics.map((topic) => (
            <TopicEntry
              key={topic.name}
              topic={topic}
              values={values}
              problems={problems}
              isFiltered={needle.trim() !== "" || onlyChanged}
              fits={(one) =>
                (!onlyChanged || one.name in values) && has(needle.trim().toLowerCase(), topic, one)
              }
              onEdit={edit}
            />
          ))}
          <div class="flow row changes">
            <span role="status">{counts || "Nothing is changed"}</span>
            <SmallButton disabled={!counts} onClick={discard}>Discard</SmallButton>
            <Button
              look="plain small"
              disabled={!isPossible || Object.keys(values).length === 0}
              onClick={() => review(() => session.do("plan", [values, profile]), true)}
            >
              Review
            </Button>
          </div>
        </>
      )}
    </section>
  );
}

interface TopicProps {
  topic: Topic;
  values: Record<string, string>;
  problems: Map<string, string>;
  isFiltered: boolean;
  fits: (parameter: Parameter) => boolean;
  onEdit: (parameter: Parameter, text: string | undefined) => void;
}

/** Its rows are made when somebody wants them: a board has a thousand parameters. */
function TopicEntry({ topic, values, problems, isFiltered, fits, onEdit }: TopicProps) {
  const [isOpen, setOpen] = useState(false);
  const fitting = topic.parameters.filter(fits);
  if (fitting.length === 0) return null;
  const changed = topic.parameters.filter(({ name }) => name in values).length;
  const isShown = isOpen || isFiltered;
  return (
    <details
      class="topic"
      open={isShown}
      onToggle={(event) => !isFiltered && setOpen(event.currentTarget.open)}
    >
      <summary>
        <b>{topic.summary.replace(/\.$/, "")}</b> <span class="muted">{topic.name}</span>{" "}
        {changed > 0 && <b class="good">{changed} changed</b>}
      </summary>
      {isShown &&
        fitting.map((parameter) => (
          <ParameterRow
            key={parameter.name}
            parameter={parameter}
            edit={values[parameter.name]}
            problem={problems.get(parameter.name)}
            onEdit={(text) => onEdit(parameter, text)}
          />
        ))}
    </details>
  );
}

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

function ParameterRow({ parameter, edit, problem, onEdit }: Props) {
  const id = useId();
  const { path, summary, text, general, default: usual } = parameter;
  return (
    <div class={edit === undefined ? "parameter" : "parameter changed"}>
      <div>
        <label for={id}>{path}</label> {summary}
        {general && <span class="muted"> The same in all profiles.</span>}
      </div>
      <div class="flow row">
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
      <div class="flow row muted">
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
      {unit && <span class="muted small">{unit}</span>}
    </>
  );
}

/** Returns the elements of a file as lines, for web/modules/setup.cpp: <NAME, =TEXT and >. */
export function elementsOf(xml: string): string {
  if (/<!DOCTYPE/i.test(xml)) throw new Error("a document type is not allowed");
  const parsed = new DOMParser().parseFromString(xml, "text/xml");
  if (parsed.querySelector("parsererror")) throw new Error("this is neither a backup nor XML");
  const lines: string[] = [];
  const walk = (element: Element): void => {
    lines.push(`<${element.tagName}`);
    for (const node of element.childNodes) {
      if (node instanceof Element) walk(node);
      else if (node instanceof CharacterData) lines.push(`=${node.data.replaceAll("\n", " ")}`);
    }
    lines.push(">");
  };
  walk(parsed.documentElement);
  return `${lines.join("\n")}\n`;
}
