// One chart of uPlot, in the colors of the site; playground.css has the rules that it needs.

import uPlot from "uplot";

import { seconds } from "./history.js";
import { colorsOf } from "./theme.js";

export interface Plot {
  draw(data: number[][]): void;
  resize(): void;
  end(): void;
}

const colors = ["--edge-5", "--edge-2", "--edge-0"];
const height = 150;
/** The least height of the vertical scale, so that noise at rest is not blown up. */
const leastSpan = 2;

export interface PlotOptions {
  unit: string;
  /** Three more columns, which are dashed. */
  hasTargets?: boolean;
  /** The vertical scale begins at 0. */
  hasZero?: boolean;
  /** One column, by the frequency in hertz. */
  isResponse?: boolean;
}

/** Columns for three axes, or a response. */
export function createPlot(place: HTMLElement, options: PlotOptions): Plot {
  const { unit, hasTargets, hasZero, isResponse } = options;
  const color = colorsOf(place);
  const line = (n: number, dash: number[]): uPlot.Series => ({
    stroke: color(colors[n % 3] ?? "--text"),
    width: dash.length ? 1 : 1.6,
    dash,
    points: { show: false },
  });
  const axis: uPlot.Axis = {
    stroke: color("--muted"),
    font: "11px system-ui, sans-serif",
    grid: { stroke: color("--line"), width: 1 },
    ticks: { show: false },
  };
  const range = (_: uPlot, low: number, high: number): [number, number] => {
    const margin = Math.max((leastSpan - (high - low)) / 2, (high - low) * 0.08);
    return hasZero ? [0, Math.max(high, leastSpan) + margin] : [low - margin, high + margin];
  };
  const time: uPlot.Scale = {
    time: false,
    range: (_, low, high) => [low, Math.max(high, low + seconds)],
  };
  const plot = new uPlot(
    {
      width: place.clientWidth,
      height,
      cursor: { show: false },
      legend: { show: false },
      scales: {
        x: isResponse ? { time: false, distr: 3 } : time,
        y: { range },
      },
      axes: [
        {
          ...axis,
          size: 24,
          ...(isResponse ? {} : { incrs: [1, 2, 5, 10, 15, 30] }),
          values: (_, ticks) =>
            ticks.map((one) => (one === null ? null : `${one} ${isResponse ? "Hz" : "s"}`)),
        },
        { ...axis, size: 52, values: (_, ticks) => ticks.map((one) => `${one}${unit}`) },
      ],
      series: [
        {},
        ...(isResponse ? [0] : [0, 1, 2]).map((n) => line(n, [])),
        ...(hasTargets ? [0, 1, 2].map((n) => line(n, [4, 4])) : []),
      ],
    },
    [[]] as unknown as uPlot.AlignedData,
    place,
  );
  return {
    draw: (data) => plot.setData(data as uPlot.AlignedData),
    resize: () => plot.setSize({ width: place.clientWidth, height }),
    end: () => plot.destroy(),
  };
}
