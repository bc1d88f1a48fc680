// Charts of angles with targets, speeds and powers. uPlot is loaded after the controls.

import type { RefObject } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";

import type { View } from "../worker_messages.js";
import { anglesWords, axisNames } from "./axes.js";
import { History } from "./history.js";
import type { Plot, PlotOptions } from "./plot.js";
import { everySecond, useDesk } from "./session.js";
import { onThemeChange } from "./theme.js";

const perSecond = 20;
const kinds = [
  { key: "angles", title: "Angles of the camera, targets dashed", unit: "°", hasTargets: true, columns: [0, 6] },
  { key: "speeds", title: "Speeds of the camera: how it vibrates", unit: "°/s", columns: [6, 9] },
  { key: "power", title: "Powers of the motors", unit: " %", hasZero: true, columns: [9] },
] as const;

type Kind = PlotOptions & { key: string; title: string };

/** Figures with plots, which are made again in new colors. `place` gets their element. */
export function usePlots(
  place: RefObject<HTMLDivElement | null>,
  kinds: readonly Kind[],
  draw: (plots: Plot[]) => void,
) {
  const [problem, setProblem] = useState("");
  const newest = useRef(draw);
  newest.current = draw;
  useEffect(() => {
    const target = place.current;
    if (!target) return;
    const boxes = [...target.querySelectorAll<HTMLElement>("[data-chart]")];
    let plots: Plot[] = [];
    let isEnded = false;
    const make = async (): Promise<void> => {
      try {
        const { createPlot } = await import("./plot.js");
        if (isEnded) return;
        for (const plot of plots) plot.end();
        plots = boxes.map((box, n) => createPlot(box, kinds[n] ?? { unit: "" }));
        newest.current(plots);
      } catch (error) {
        setProblem(`The charts could not be loaded: ${String(error)}`);
      }
    };
    void make();
    const size = new ResizeObserver(() => plots.forEach((plot) => plot.resize()));
    size.observe(target);
    const endTheme = onThemeChange(() => void make());
    return () => {
      isEnded = true;
      endTheme();
      size.disconnect();
      for (const plot of plots) plot.end();
    };
  }, [place]);
  return (
    <>
      {problem && <p class="bad">{problem}</p>}
      <div class="charts" ref={place}>
        {kinds.map(({ key, title }) => (
          <figure key={key}>
            <figcaption class="muted small">{title}</figcaption>
            <div data-chart={title} role="img" aria-label={title} />
          </figure>
        ))}
      </div>
    </>
  );
}

export function Charts() {
  const { session } = useDesk();
  const place = useRef<HTMLDivElement>(null);
  const plots = useRef<Plot[]>([]);
  const draw = useRef(() => {});
  const figures = usePlots(place, kinds, (made) => {
    plots.current = made;
    draw.current();
  });
  useEffect(() => {
    const target = place.current;
    if (!target) return;
    const history = new History();
    let isInSight = false;
    const label = everySecond(({ camera }: View) => {
      const now = anglesWords(camera);
      for (const box of target.querySelectorAll<HTMLElement>("[data-chart]")) {
        box.setAttribute("aria-label", `${box.dataset.chart}; now ${now}`);
      }
    });
    draw.current = () => {
      if (!isInSight || !plots.current.length || !history.times.length) return;
      const { times, columns } = history;
      for (const [n, plot] of plots.current.entries()) {
        plot.draw([times, ...columns.slice(...(kinds[n]?.columns ?? []))]);
      }
      if (session.view) label(session.view);
    };
    const endViews = session.listen((report) => {
      if (report.kind === "view") history.add(report.view);
    });
    const endDrawing = session.draw(perSecond, () => draw.current());
    const sight = new IntersectionObserver(([entry]) => {
      isInSight = entry?.isIntersecting ?? false;
      draw.current();
    });
    sight.observe(target);
    return () => {
      endViews();
      endDrawing();
      sight.disconnect();
    };
  }, [session]);
  return (
    <section aria-labelledby="charts-title">
      <div class="flow apart head">
        <h2 id="charts-title">Charts</h2>
        <p class="flow small legend">
          {axisNames.map((axis) => (
            <span key={axis}>
              <i class={`swatch ${axis}`} /> {axis}
            </span>
          ))}
        </p>
      </div>
      {figures}
    </section>
  );
}
