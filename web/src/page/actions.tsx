// Buttons with the lines that do the same elsewhere.

import { createContext, Fragment, type ComponentChildren } from "preact";
import { useContext, useState } from "preact/hooks";

import { languages, type Action, type Language, type Lines } from "./lines.js";

/** What the buttons need from the page. */
export interface Desk {
  language: Language;
  isReady: boolean;
  run: (action: Action, label: string) => void;
}
const Context = createContext<Desk | null>(null);
export const DeskProvider = Context.Provider;

export function useDesk(): Desk {
  const desk = useContext(Context);
  if (!desk) throw new Error("no desk");
  return desk;
}

export function LanguageChoice(props: { language: Language; onChange: (one: Language) => void }) {
  return (
    <fieldset class="languages">
      <legend>Lines to take home</legend>
      {languages.map(({ key, title }) => (
        <label key={key}>
          <input
            type="radio"
            name="language"
            checked={props.language === key}
            onChange={() => props.onChange(key)}
          />
          <span>{title}</span>
        </label>
      ))}
    </fieldset>
  );
}

const missing: Record<Language, string> = {
  command: "The command has no line for this.",
  cpp: "C++ has no short line for this.",
  python: "The Python package has no line for this.",
};

export function CodeLine({ lines, about }: { lines: Lines; about: string }) {
  const { language } = useDesk();
  const [copied, setCopied] = useState("");
  const text = lines[language];
  if (!text) return <p class="no-line">{missing[language]}</p>;
  const copy = async (): Promise<void> => {
    try {
      await navigator.clipboard.writeText(text);
      setCopied("Copied");
    } catch {
      setCopied("Not allowed");
    }
    setTimeout(() => setCopied(""), 1500);
  };
  return (
    <div class="line">
      <pre>
        <code>
          {text.split(/ (?=--)/).map((word, n) => (
            <Fragment key={n}>
              {n > 0 && " "}
              <span>{word}</span>
            </Fragment>
          ))}
        </code>
      </pre>
      <button type="button" class="copy-line" aria-label={`Copy: ${about}`} onClick={copy}>
        {copied || "Copy"}
      </button>
    </div>
  );
}

interface ActionProps {
  action: Action;
  label: string;
  isMain?: boolean;
  children?: ComponentChildren;
}

export function ActionRow({ action, label, isMain, children }: ActionProps) {
  const { isReady, run } = useDesk();
  return (
    <div class="action">
      <div class="do">
        <button
          type="button"
          class={isMain ? "plain" : "plain quiet"}
          disabled={!isReady}
          onClick={() => run(action, label)}
        >
          {label}
        </button>
        {children}
      </div>
      <CodeLine lines={action.lines} about={label} />
    </div>
  );
}
