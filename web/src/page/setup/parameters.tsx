// The parameters of the board by their topics; changes are collected, reviewed and then written.

import { useState } from "preact/hooks";

import type { Parameter, Plan, Read, Topic, Written } from "../../setup_messages.js";
import { Select } from "../inputs.js";
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
  const review = (work: () => Promise<Plan>): void => {
    setWritten(null);
    void task.run(work).then(setPlan);
  };
  const take = (file: File | undefined): void => {
    if (!file) return;
    review(async () => {
      if (file.size > longestFile) throw new Error(`${file.name} is too long for a backup`);
      return session.get("plan-file", { name: file.name, text: await file.text(), profile });
    });
  };
  const backup = (): Promise<unknown> =>
    task.run(async (progress) => download(await session.get("backup", {}, progress), "json"));
  const end = async (now: Written): Promise<void> => {
    setWritten(now);
    setPlan(null);
    // What failed is still there to try again.
    if (now.ok) setEdits(({ [0]: _, [profile]: __, ...others }) => others);
    await task.run(() => show(profile));
  };

  const counts = Object.entries(edits)
    .map(([key, one]) => [Number(key), Object.keys(one).length] as const)
    .filter(([, count]) => count > 0);
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
        <div class="do">
          <button
            type="button"
            class={read ? "plain quiet small" : "plain"}
            disabled={!isPossible}
            onClick={() => void readAll()}
          >
            {read ? "Read again" : "Read the parameters"}
          </button>
          {read && (
            <>
              <button
                type="button"
                class="plain quiet small"
                disabled={!isPossible}
                onClick={() => void backup()}
              >
                Save a backup
              </button>
              <label class="plain quiet small file">
                Open a file
                <input
                  type="file"
                  accept=".json,.profile"
                  disabled={!isPossible}
                  onChange={(event) => {
                    take(event.currentTarget.files?.[0]);
                    event.currentTarget.value = "";
                  }}
                />
              </label>
              <button
                type="button"
                class="plain quiet small"
                disabled={!isPossible || !canUndo}
                onClick={() => review(() => session.get("plan-undo", {}))}
              >
                Undo the last write
              </button>
            </>
          )}
        </div>
      </div>
      <TaskState task={task} />
      {written && (
        <p class={written.ok ? "written good" : "written bad"} role="status">
          {written.text}
        </p>
      )}
      {read && (
        <>
          <div class="filter">
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
              placeholder="Search the parameters"
              value={needle}
              onInput={(event) => setNeedle(event.currentTarget.value)}
            />
            <label>
              <input
                type="checkbox"
                checked={onlyChanged}
                onChange={(event) => setOnlyChanged(event.currentTarget.checked)}
              />{" "}
              Only changed
            </label>
            <span class="count" role="status">
              {counts
                .map(([key, count]) => `${count} changed in ${key ? `profile ${key}` : "all profiles"}`)
                .join(", ") || "Nothing is changed"}
            </span>
            <button
              type="button"
              class="plain quiet small"
              disabled={counts.length === 0}
              onClick={() => {
                setEdits({});
                setPlan(null);
              }}
            >
              Discard
            </button>
            <button
              type="button"
              class="plain small"
              disabled={!isPossible || Object.keys(values).length === 0}
              onClick={() => review(() => session.get("plan", { profile, values }))}
            >
              Review
            </button>
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
        <b>{topic.name}</b> <span class="muted">{topic.summary}</span>{" "}
        <span class={changed ? "count changed" : "count"}>
          {changed ? `${changed} changed of ${topic.parameters.length}` : topic.parameters.length}
        </span>
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
