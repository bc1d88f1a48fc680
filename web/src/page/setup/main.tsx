// The page that sets up a real gimbal: its worker has the line, and the page shows what it says.

import { render } from "preact";

import { App } from "./app.js";
import { Setup } from "./setup_session.js";

/** `sbgc bridge --page` leaves its token in the address, where it does not stay. */
function takeToken(): string {
  const token = new URLSearchParams(location.hash.slice(1)).get("token") ?? "";
  if (token) history.replaceState(null, "", location.pathname + location.search);
  return token;
}

const token = takeToken();
const place = document.getElementById("application");
if (place) {
  const worker = new Worker(new URL("./setup_worker.js", import.meta.url), { type: "module" });
  render(<App session={new Setup(worker)} token={token} />, place);
}
