// Frames and long tasks of the playground in Chromium with software WebGL: `node playground.mjs`, with
// build/site. The frame moves, the camera turns, and the log is open. The figures are for report.py.

import { launch, serve } from "../../tests/site/support.mjs";

const seconds = 10;

const browser = await launch(["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]);
const server = await serve();
const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
await page.goto(`${server.address}playground.html#motion=drone`);
const click = (name) => page.getByRole("button", { name, exact: true }).click();
await click("Motors on");
await page.locator(".outcome", { hasText: "Motors on: done" }).waitFor();
await page.waitForFunction(() => globalThis.sbgcPlayground.opticalAxis());

async function measure() {
  await click("Turn");
  return page.evaluate(async (time) => {
    const tasks = [];
    const observer = new PerformanceObserver((list) => tasks.push(...list.getEntries()));
    observer.observe({ type: "longtask" });
    let frames = 0;
    const begin = performance.now();
    while (performance.now() - begin < time * 1000) {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      ++frames;
    }
    observer.disconnect();
    const longest = Math.max(0, ...tasks.map(({ duration }) => duration));
    return { frames: frames / time, tasks: tasks.length, longest };
  }, seconds);
}

const benchmarks = [];
for (const [name, prepare] of [
  ["playground/view", null],
  ["playground/view_and_log", "Show the log"],
]) {
  if (prepare) await click(prepare);
  const { frames, tasks, longest } = await measure();
  const times = { real_time: 1000 / frames, cpu_time: 1000 / frames, time_unit: "ms" };
  benchmarks.push({ name, run_type: "iteration", ...times, frames_per_second: frames, long_tasks: tasks, longest_ms: longest });
}
console.log(JSON.stringify({ benchmarks }));
await browser.close();
server.close();
