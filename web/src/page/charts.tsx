// Charts of angles with targets, speeds and powers. uPlot is loaded after the controls.

import { useEffect, useRef, useState } from "preact/hooks";

import type { View } from "../worker_messages.js";
import { anglesWords, axisNames } from "./axes.js";
import { History } from "./history.js";
import type { Plot } from "./plot.js";
import { everySecond, useDesk } from "./session.js";
import { onThemeChange } from "./theme.js";

const perSecond = 20;
const kinds = [
  { key: "angles", title: "Angles of the camera, targets dashed", unit: "°", hasTargets: true },
  { key: "speeds", title: "Speeds of the camera: how it vibrates", unit: "°/s" },
  { key: "power", title: "Powers of the motors", unit: " %", hasZero: true },
] as const;

export function Charts() {
  const { session } = useDesk();
  const place = useRef<HTMLDivElement>(null);
  const [problem, setProblem] = useState("");
  useEffect(() => {
    const target = place.current;
    if (!target) return;
    const history = new History();
    const boxes = [...target.querySelectorAll<HTMLElement>("[data-chart]")];
    let plots: Plot[] = [];
    let isInSight = false;
    let isEnded = false;
    const label = everySecond(({ camera }: View) => {
      const now = anglesWords(camera);
      for (const box of boxes) box.setAttribute("aria-label", `${box.dataset.chart}; now ${now}`);
    });

    const draw = (): void => {
      if (!isInSight || !plots.length || !history.times.length) return;
      const { times, camera, targets, speeds, power } = history;
      const columns = [[...camera, ...targets], speeds, power];
      for (const [n, plot] of plots.entries()) plot.draw([times, ...(columns[n] ?? [])]);
      if (session.view) label(session.view);
    };
    const make = async (): Promise<void> => {
      try {
        const { createPlot } = await import("./plot.js");
        if (isEnded) return;
        for (const plot of plots) plot.end();
        plots = boxes.map((box, n) => createPlot(box, kinds[n] ?? { unit: "" }));
        draw();
      } catch (error) {
        setProblem(`The charts could not be loaded: ${String(error)}`);
      }
    };
    void make();
    const endViews = session.listen((report) => {
      if (report.kind === "view") history.add(report.view);
    });
    const endDrawing = session.draw(perSecond, draw);
    const sight = new IntersectionObserver(([entry]) => {
      isInSight = entry?.isIntersecting ?? false;
      draw();
    });
    sight.observe(target);
    const size = new ResizeObserver(() => plots.forEach((plot) => plot.resize()));
    size.observe(target);
    const endTheme = onThemeChange(() => void make());
    return () => {
      isEnded = true;
      endViews();
      endDrawing();
      endTheme();
      sight.disconnect();
      size.disconnect();
      for (const plot of plots) plot.end();
    };
  }, [session]);
  return (
    <section aria-labelledby="charts-title">
      <div class="head">
        <h2 id="charts-title">Charts</h2>
        <p class="legend">
          {axisNames.map((axis) => (
            <span key={axis}>
              <i class={`swatch ${axis}`} /> {axis}
            </span>
          ))}
        </p>
      </div>
      {problem && <p class="bad">{problem}</p>}
      <div class="charts" ref={place}>
        {kinds.map(({ key, title }) => (
          <figure key={key}>
            <figcaption>{title}</figcaption>
            <div data-chart={title} role="img" aria-label={title} />
          </figure>
        ))}
      </div>
    </section>
  );
}
