// Small parts of the page.

import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";

import { Button, SmallButton } from "../inputs.js";
import type { Task } from "../session.js";
import { StopButton } from "../status.js";
import { useBench } from "./setup_session.js";

/** Beside what would move. */
export function ArmSwitch({ children }: { children: ComponentChildren }) {
  const { isConnected, isArmed, arm } = useBench();
  return (
    <div class={isArmed ? "flow arming armed" : "flow arming"}>
      <button
        type="button"
        role="switch"
        aria-checked={isArmed}
        class={isArmed ? "plain" : "plain quiet"}
        disabled={!isConnected}
        onClick={() => arm(!isArmed)}
      >
        Arm motion
      </button>
      <p>{children}</p>
    </div>
  );
}

/** Where a task stands; without `onCancel`, nothing can end it. */
export function TaskState({ task, onCancel }: { task: Task; onCancel?: () => void }) {
  const { isBusy, progress, problem } = task;
  return (
    <div role="status" aria-busy={isBusy}>
      {isBusy && (
        <p class="flow row">
          <progress aria-label="Progress" value={progress?.share} />
          <span>{progress?.text ?? "Waiting…"}</span>
          {onCancel && <SmallButton onClick={onCancel}>Cancel</SmallButton>}
        </p>
      )}
      {problem && <p class="bad">{problem}</p>}
    </div>
  );
}

export const Sentences = ({ of }: { of: string[] }) => (
  <ul>
    {of.map((one, n) => (
      <li key={n}>{one}</li>
    ))}
  </ul>
);

interface AskProps {
  /** The name of the button, and of the one that agrees. */
  action: string;
  question: string;
  disabled: boolean;
  onAgree: () => unknown;
  children: ComponentChildren;
}

/** A button that asks; Escape means no, after the page has stopped the camera. */
export function AskButton({ action, question, disabled, onAgree, children }: AskProps) {
  const { stop } = useBench();
  const dialog = useRef<HTMLDialogElement>(null);
  const close = (): void => dialog.current?.close();
  const agree = (): void => {
    close();
    onAgree();
  };
  return (
    <>
      <Button disabled={disabled} onClick={() => dialog.current?.showModal()}>{action}</Button>
      <dialog ref={dialog} aria-label={question}>
        <h2>{question}</h2>
        {children}
        <div class="flow row">
          <Button look="plain quiet" onClick={close}>Leave it</Button>
          <Button onClick={agree}>{action}</Button>
          <StopButton onStop={stop} />
        </div>
      </dialog>
    </>
  );
}

/** Saves to a file of the visitor, such as sbgc-2026-11-29T10-00-00.capture. */
export function download(content: BlobPart, type: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content]));
  link.download = `sbgc-${new Date().toISOString().slice(0, 19).replaceAll(":", "-")}.${type}`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

type Hear = (event: Event) => unknown;

/** `isFirst`: before the elements inside `target` hear of it. */
export function useEvents(
  target: EventTarget | undefined,
  kinds: string[],
  hear: Hear,
  isFirst = false,
): void {
  const newest = useRef(hear);
  newest.current = hear;
  useEffect(() => {
    const call: Hear = (event) => newest.current(event);
    for (const kind of kinds) target?.addEventListener(kind, call, isFirst);
    return () => kinds.forEach((kind) => target?.removeEventListener(kind, call, isFirst));
  }, [target]);
}
