// The parameters of the board by their topics; changes are collected, reviewed and then written.

import { useRef, useState } from "preact/hooks";

import type { Parameter, Plan, Read, Topic, Written } from "../../setup_messages.js";
import { elementsOf } from "../../vendor_file.js";
import { Button, Check, Select, SmallButton } from "../inputs.js";
import { ParameterRow } from "./parameter_row.js";
import { download, TaskState } from "./parts.js";
import { Review } from "./review.js";
import { useBench, useTask } from "./setup_session.js";

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
    setTopics(await session.get("profile", { profile: one }));
    setProfile(one);
  };
  const readAll = (): Promise<unknown> =>
    task.run(async (progress) => {
      const now = await session.get("parameters", {}, progress);
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
      return session.get("plan-file", { text, profile });
    });
  };
  const backup = (): Promise<unknown> =>
    task.run(async (progress) => download(await session.get("backup", {}, progress), "json"));
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
      <div class="head">
        <h2 id="parameters-title">Parameters</h2>
        {!read && (
          <Button disabled={!isPossible} onClick={readAll}>Read the parameters</Button>
        )}
        {read && (
          <div class="row">
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
              onClick={() => review(() => session.get("plan-undo", {}))}
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
          <div class="row">
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
          <div class="row changes">
            <span role="status">{counts || "Nothing is changed"}</span>
            <SmallButton disabled={!counts} onClick={discard}>Discard</SmallButton>
            <Button
              look="plain small"
              disabled={!isPossible || Object.keys(values).length === 0}
              onClick={() => review(() => session.get("plan", { profile, values }), true)}
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
