// The playground: an emulated gimbal in a worker, and a page around it.

import { render } from "preact";

import { App } from "./app.js";
import { Session } from "./session.js";

const place = document.getElementById("application");
if (place) {
  const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
  render(<App session={new Session(worker)} />, place);
}
