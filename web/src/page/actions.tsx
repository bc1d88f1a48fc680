// Buttons with the equivalent lines of code.

import { Fragment, type ComponentChildren } from "preact";
import { useState } from "preact/hooks";

import { Button } from "./inputs.js";
import type { Action, Language, Lines } from "./lines.js";
import { useDesk } from "./session.js";

const missing: Record<Language, string> = {
  command: "The command has no line for this.",
  cpp: "C++ has no short line for this.",
  python: "The Python package has no line for this.",
};

export function CodeLine({ lines, about }: { lines: Lines; about: string }) {
  const { language } = useDesk();
  const [copied, setCopied] = useState("");
  const text = lines[language];
  if (!text) return <p class="muted small says">{missing[language]}</p>;
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
      <pre class="wrap">
        <code>
          {text.split(/ (?=--)/).map((word, n) => (
            <Fragment key={n}>
              {n > 0 && " "}
              <span>{word}</span>
            </Fragment>
          ))}
        </code>
      </pre>
      <button type="button" class="copy" aria-label={`Copy: ${about}`} onClick={copy}>
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
      <div class="flow do">
        <Button
          look={isMain ? "plain" : "plain quiet"}
          disabled={!isReady}
          onClick={() => run(action, label)}
        >
          {label}
        </Button>
        {children}
      </div>
      <CodeLine lines={action.lines} about={label} />
    </div>
  );
}
