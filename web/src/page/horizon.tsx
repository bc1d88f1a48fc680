// The view of the camera, and the view that it would have fixed to the frame: sky, ground with lines
// to its headings, and posts at every 15 degrees. Drawn in 2D, so that it needs no WebGL.

import { useEffect, useRef } from "preact/hooks";

import type { Axes } from "../worker_messages.js";
import { anglesWords, type Direction, radians, seenFrom } from "./axes.js";
import { everySecond, useDesk } from "./session.js";
import { colorsOf, onThemeChange } from "./theme.js";

/** The angle of view along the smaller side of the picture, in degrees. */
const fieldOfView = 64;
/** Points nearer to the plane of the lens, or behind it, are not drawn. */
const nearest = 0.05;
const headings = Array.from({ length: 24 }, (_, n) => n * 15);
const rings = [-8, -14, -24, -40, -62, -80];

type Point = [number, number];

const directionOf = (heading: number, elevation: number): Direction => {
  const level = Math.cos(radians(elevation));
  const up = Math.sin(radians(elevation));
  return [level * Math.sin(radians(heading)), up, level * Math.cos(radians(heading))];
};

function drawHorizon(canvas: HTMLCanvasElement, angles: Axes): void {
  const context = canvas.getContext("2d");
  if (!context) return;
  const color = colorsOf(canvas);
  const { width, height } = canvas;
  const scale = Math.min(width, height) / 2 / Math.tan(radians(fieldOfView / 2));
  const seen = seenFrom(angles);
  const place = (direction: Direction): Point | null => {
    const [right, up, forward] = seen(direction);
    return forward < nearest ? null : [(right / forward) * scale, (-up / forward) * scale];
  };
  const stroke = (lines: (Point | null)[][], name: string, thickness: number): void => {
    context.strokeStyle = color(name);
    context.lineWidth = height * thickness;
    context.beginPath();
    for (const line of lines) {
      let last: Point | null = null;
      for (const point of line) {
        if (point) context[last ? "lineTo" : "moveTo"](...point);
        last = point;
      }
    }
    context.stroke();
  };

  context.setTransform(1, 0, 0, 1, width / 2, height / 2);
  context.fillStyle = color("--tint-0");
  context.fillRect(-width / 2, -height / 2, width, height);

  // Ground is where the ray (x, -y, scale) points down: one side of a line.
  const [right, up, forward] = seen([0, 1, 0]);
  const far = 4 * (width + height);
  const level = (forward * scale) / Math.max(Math.hypot(right, up), 1e-6);
  context.save();
  context.rotate(Math.atan2(right, up));
  context.fillStyle = color("--tint-1");
  context.fillRect(-far, Math.max(-far, Math.min(far, level)), 2 * far, 2 * far);
  stroke([[[-far, level], [far, level]]], "--edge-1", 0.01);
  context.restore();

  const around = [...headings, 360].flatMap((heading) => [heading - 7.5, heading]);
  const grid = [
    ...rings.map((ring) => around.map((heading) => place(directionOf(heading, ring)))),
    ...headings.map((heading) => [-4, ...rings].map((ring) => place(directionOf(heading, ring)))),
  ];
  stroke(grid, "--line-strong", 0.005);
  const posts = headings.map((heading) =>
    [-3, heading % 45 ? 3 : 7].map((elevation) => place(directionOf(heading, elevation))),
  );
  stroke(posts, "--edge-0", 0.018);
  context.fillStyle = color("--muted");
  context.font = `${Math.round(height / 13)}px system-ui, sans-serif`;
  context.textAlign = "center";
  for (const heading of headings.filter((one) => one % 45 === 0)) {
    const top = place(directionOf(heading, 8.5));
    if (top) context.fillText(`${heading > 180 ? heading - 360 : heading}°`, ...top);
  }
  const mark: Point[] = [[-1.6, 0], [-0.5, 0], [0, 0.4], [0.5, 0], [1.6, 0]];
  stroke([mark.map(([x, y]): Point => [(x * height) / 9, (y * height) / 9])], "--text", 0.011);
}

function Horizon({ title, of }: { title: string; of: "camera" | "frame" }) {
  const { session } = useDesk();
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const target = canvas.current;
    if (!target) return;
    const label = everySecond((angles: Axes) =>
      target.setAttribute("aria-label", `${title}: ${anglesWords(angles)}`),
    );
    const draw = (): void => {
      const angles = session.view?.[of] ?? [0, 0, 0];
      drawHorizon(target, angles);
      label(angles);
    };
    const size = new ResizeObserver(() => {
      target.width = Math.round(target.clientWidth * Math.min(devicePixelRatio, 2));
      target.height = Math.round(target.clientHeight * Math.min(devicePixelRatio, 2));
      draw();
    });
    size.observe(target);
    const ends = [onThemeChange(draw), session.draw(60, draw), () => size.disconnect()];
    return () => ends.forEach((end) => end());
  }, [session]);
  return (
    <figure>
      <canvas ref={canvas} role="img" aria-label={title} />
      <figcaption class="muted small">{title}</figcaption>
    </figure>
  );
}

export const Horizons = () => (
  <div class="horizons">
    <Horizon title="The camera sees" of="camera" />
    <Horizon title="Without a gimbal" of="frame" />
  </div>
);
