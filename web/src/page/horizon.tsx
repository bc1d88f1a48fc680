// What the camera sees, and what it would see if it were fixed to the frame: sky, ground with lines
// to its headings, and posts at every 15 degrees. Drawn in 2D, so that it needs no WebGL.

import { useEffect, useRef } from "preact/hooks";

import type { Axes } from "../worker_messages.js";
import { radians, seenFrom, type Direction } from "./attitude.js";
import { anglesWords } from "./axes.js";
import { useSession } from "./session.js";
import { onThemeChange } from "./theme.js";

const perSecond = 60;
const labelsPerSecond = 1;
/** Of the smaller side of the picture. */
const fieldOfView = 64;
const nearest = 0.05;
const ringElevations = [-8, -14, -24, -40, -62, -80];

interface Look {
  sky: string;
  ground: string;
  line: string;
  field: string;
  post: string;
  text: string;
  mark: string;
}

const lookOf = (element: Element): Look => {
  const style = getComputedStyle(element);
  const color = (name: string): string => style.getPropertyValue(name).trim();
  return {
    sky: color("--tint-0"),
    ground: color("--tint-1"),
    line: color("--edge-1"),
    field: color("--line-strong"),
    post: color("--edge-0"),
    text: color("--muted"),
    mark: color("--text"),
  };
};

function drawHorizon(canvas: HTMLCanvasElement, angles: Axes, look: Look): void {
  const context = canvas.getContext("2d");
  if (!context) return;
  const { width, height } = canvas;
  const scale = Math.min(width, height) / 2 / Math.tan(radians(fieldOfView / 2));
  const turn = seenFrom(angles);
  const [right, up, forward] = turn([0, 1, 0]);

  context.setTransform(1, 0, 0, 1, 0, 0);
  context.fillStyle = look.sky;
  context.fillRect(0, 0, width, height);
  context.translate(width / 2, height / 2);

  // Ground is where the ray (x, -y, scale) points down: one side of a line.
  const slope = Math.hypot(right, up);
  const far = 4 * (width + height);
  context.save();
  context.rotate(Math.atan2(right, up));
  const level = slope < 1e-6 ? -far * Math.sign(forward) : (forward * scale) / slope;
  const y = Math.max(-far, Math.min(far, level));
  context.fillStyle = look.ground;
  context.fillRect(-far, y, 2 * far, far * 2);
  context.strokeStyle = look.line;
  context.lineWidth = height / 120;
  context.strokeRect(-far, y, 2 * far, far * 2);
  context.restore();

  const place: Place = (direction) => {
    const [x, above, depth] = turn(direction);
    return depth < nearest ? null : [(x / depth) * scale, (-above / depth) * scale];
  };
  drawGround(context, place, look.field, height / 220);
  context.font = `${Math.round(height / 13)}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.lineCap = "round";
  for (let heading = -180; heading < 180; heading += 15) {
    const [east, north] = [Math.sin(radians(heading)), Math.cos(radians(heading))];
    const isTall = heading % 45 === 0;
    const foot = place([east, -0.05, north]);
    const head = place([east, isTall ? 0.12 : 0.05, north]);
    if (!foot || !head || Math.abs(foot[0]) > width || Math.abs(foot[1]) > 2 * height) continue;
    context.strokeStyle = look.post;
    context.lineWidth = height / (isTall ? 45 : 70);
    context.beginPath();
    context.moveTo(...foot);
    context.lineTo(...head);
    context.stroke();
    context.fillStyle = look.text;
    if (isTall) context.fillText(`${heading}°`, head[0], head[1] - height / 30);
  }

  const mark = height / 9;
  context.strokeStyle = look.mark;
  context.lineWidth = height / 90;
  context.beginPath();
  context.moveTo(-mark * 1.6, 0);
  context.lineTo(-mark * 0.5, 0);
  context.lineTo(0, mark * 0.4);
  context.lineTo(mark * 0.5, 0);
  context.lineTo(mark * 1.6, 0);
  context.stroke();
}

type Place = (direction: Direction) => [number, number] | null;

const directionOf = (heading: number, elevation: number): Direction => {
  const level = Math.cos(radians(elevation));
  const up = Math.sin(radians(elevation));
  return [level * Math.sin(radians(heading)), up, level * Math.cos(radians(heading))];
};

/** Rings around the camera, and lines from it to the horizon. */
function drawGround(
  context: CanvasRenderingContext2D,
  place: Place,
  color: string,
  width: number,
): void {
  context.strokeStyle = color;
  context.lineWidth = width;
  context.beginPath();
  const line = (directions: Direction[]): void => {
    let last: [number, number] | null = null;
    for (const direction of directions) {
      const next = place(direction);
      if (last && next) {
        context.moveTo(...last);
        context.lineTo(...next);
      }
      last = next;
    }
  };
  const headings = Array.from({ length: 49 }, (_, n) => n * 7.5);
  for (const elevation of ringElevations) line(headings.map((one) => directionOf(one, elevation)));
  for (let heading = 0; heading < 360; heading += 15) {
    line([-4, ...ringElevations].map((elevation) => directionOf(heading, elevation)));
  }
  context.stroke();
}

function Horizon({ title, of }: { title: string; of: "camera" | "frame" }) {
  const session = useSession();
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const target = canvas.current;
    if (!target) return;
    let look = lookOf(target);
    let labelDue = 0;
    const draw = (angles: Axes): void => {
      drawHorizon(target, angles, look);
      if (performance.now() < labelDue) return;
      labelDue = performance.now() + 1000 / labelsPerSecond;
      target.setAttribute("aria-label", `${title}: ${anglesWords(angles)}`);
    };
    const again = (): void => {
      look = lookOf(target);
      draw(session.view?.[of] ?? [0, 0, 0]);
    };
    const size = new ResizeObserver(() => {
      target.width = Math.round(target.clientWidth * Math.min(devicePixelRatio, 2));
      target.height = Math.round(target.clientHeight * Math.min(devicePixelRatio, 2));
      again();
    });
    size.observe(target);
    const endLook = onThemeChange(again);
    const endViews = session.draw(perSecond, (view) => draw(view[of]));
    return () => {
      size.disconnect();
      endLook();
      endViews();
    };
  }, [session]);
  return (
    <figure>
      <canvas ref={canvas} role="img" aria-label={title} />
      <figcaption>{title}</figcaption>
    </figure>
  );
}

export const Horizons = () => (
  <div class="horizons">
    <Horizon title="The camera sees" of="camera" />
    <Horizon title="Without a gimbal" of="frame" />
  </div>
);
