// The place of the 3D view. It loads three.js once it is in sight and the page is idle, where there
// is WebGL.

import { useEffect, useRef, useState } from "preact/hooks";

import type { View } from "../worker_messages.js";
import { anglesWords, type Direction } from "./axes.js";
import { everySecond, useDesk } from "./session.js";
import { onThemeChange } from "./theme.js";
import type { View3D } from "./view3d.js";


/** For tests and for the curious: nothing here changes the page. */
declare global {
  var sbgcPlayground: { opticalAxis: () => Direction | null };
}
let view3d: View3D | null = null;
globalThis.sbgcPlayground = Object.freeze({ opticalAxis: () => view3d?.opticalAxis() ?? null });

const whenIdle = (call: () => void): void => {
  if ("requestIdleCallback" in globalThis) requestIdleCallback(call, { timeout: 1000 });
  else setTimeout(call, 200); // Safari
};

export function GimbalView() {
  const { session } = useDesk();
  const canvas = useRef<HTMLCanvasElement>(null);
  const [problem, setProblem] = useState("");
  useEffect(() => {
    const target = canvas.current;
    if (!target) return;
    const ends: (() => void)[] = [];
    let isInSight = false;
    let isEnded = false;
    let isLoading = false;
    const label = everySecond(({ camera }: View) =>
      target.setAttribute("aria-label", `The gimbal. Camera: ${anglesWords(camera)}`),
    );

    const show = (view: View): void => {
      if (!isInSight) return;
      view3d?.show(view.frame, view.camera);
      label(view);
    };

    const load = async (): Promise<void> => {
      const context = target.getContext("webgl2", { antialias: true });
      if (!context) {
        setProblem("This browser has no WebGL: no 3D view.");
        return;
      }
      try {
        const { createView } = await import("./view3d.js");
        if (isEnded) return;
        const made = createView(target, context);
        view3d = made;
        const size = new ResizeObserver(made.resize);
        size.observe(target);
        ends.push(
          () => size.disconnect(),
          onThemeChange(made.recolor),
          session.draw(60, show),
          onDrag(target, made.orbit),
          made.end,
        );
      } catch (error) {
        setProblem(`The 3D view could not be loaded: ${String(error)}`);
      }
    };

    const sight = new IntersectionObserver(([entry]) => {
      isInSight = entry?.isIntersecting ?? false;
      if (!isInSight) return;
      if (session.view) show(session.view);
      if (isLoading) return;
      isLoading = true;
      whenIdle(() => void load());
    });
    sight.observe(target);
    ends.push(() => sight.disconnect());
    return () => {
      isEnded = true;
      view3d = null;
      for (const end of ends) end();
    };
  }, [session]);
  return (
    <div class="gimbal-view">
      <canvas ref={canvas} role="img" aria-label="The gimbal" hidden={problem !== ""} />
      {problem && <p class="muted">{problem}</p>}
    </div>
  );
}

/** Calls with the radians by which the viewer shall turn. */
function onDrag(target: HTMLElement, turn: (around: number, up: number) => void): () => void {
  const radiansPerPixel = 0.008;
  const drag = (event: PointerEvent): void => {
    if (event.buttons === 0) return;
    turn(event.movementX * radiansPerPixel, event.movementY * radiansPerPixel);
  };
  const grab = (event: PointerEvent): void => target.setPointerCapture(event.pointerId);
  target.addEventListener("pointerdown", grab);
  target.addEventListener("pointermove", drag);
  return () => {
    target.removeEventListener("pointerdown", grab);
    target.removeEventListener("pointermove", drag);
  };
}
