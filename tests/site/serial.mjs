// Serial ports for pages and their workers, with `sbgc emulate` at the other end. A line works only with
// the settings of the board; a cable can be pulled and plugged in.

import { spawn } from "node:child_process";
import fs from "node:fs";
import net from "node:net";
import path from "node:path";
import { createInterface } from "node:readline";
import { WebSocketServer } from "ws";

import { sbgc, site } from "./support.mjs";

/** Starts `sbgc` with these arguments; `line` matches the first line to wait for. */
export async function start(args, line) {
  const child = spawn(sbgc, args, { stdio: ["ignore", "pipe", "inherit"] });
  const lines = createInterface({ input: child.stdout });
  const found = await new Promise((resolve, reject) => {
    child.once("exit", (code) => reject(new Error(`sbgc ${args.join(" ")} has ended with ${code}`)));
    lines.on("line", (text) => line.test(text) && resolve(text.match(line)));
  });
  child.removeAllListeners("exit");
  process.once("exit", () => child.kill());
  return { found, child, stop: () => child.kill() };
}

/** An emulated gimbal on TCP. */
export async function gimbal(...args) {
  const started = await start(["emulate", "--tcp", "0", ...args], /127\.0\.0\.1:(\d+)/);
  return { ...started, port: Number(started.found[1]) };
}

/** The other ends of two ports of the same kind, of which the second has the gimbal. */
export async function cables(board, { baudRate = 115200, parity = "none" } = {}) {
  const server = new WebSocketServer({ port: 0, host: "127.0.0.1" });
  await new Promise((resolve) => server.on("listening", resolve));
  const cable = { isIn: true, opened: [], writes: [], pull, plug: () => (cable.isIn = true) };
  const sockets = new Set();
  function pull() {
    cable.isIn = false;
    for (const socket of sockets) socket.terminate();
  }
  server.on("connection", (socket, request) => {
    const { searchParams } = new URL(request.url, "ws://line");
    const settings = { index: searchParams.get("index"), baudRate: Number(searchParams.get("baud")), parity: searchParams.get("parity") };
    cable.opened.push(settings);
    if (!cable.isIn) return socket.terminate();
    sockets.add(socket);
    const fits = settings.index === "1" && settings.baudRate === baudRate && settings.parity === parity;
    const line = fits ? net.connect(board.port, "127.0.0.1") : null;
    line?.setNoDelay();
    line?.on("data", (bytes) => socket.send(bytes));
    line?.on("error", () => socket.terminate());
    socket.on("message", (bytes) => {
      cable.writes.push({ at: performance.now(), bytes: Buffer.from(bytes) });
      line?.write(bytes);
    });
    socket.on("close", () => {
      sockets.delete(socket);
      line?.destroy();
    });
  });
  return { ...{ cable, url: `ws://127.0.0.1:${server.address().port}` }, close: () => (pull(), server.close()) };
}

/** The Web Serial of a page or worker with two such ports, as a script. */
export const webSerial = (url) => `(${function (address) {
  class Port extends EventTarget {
    constructor(index) {
      super();
      this.index = index;
    }
    getInfo() {
      return { usbVendorId: 0x10c4, usbProductId: 0xea60 };
    }
    async open({ baudRate, parity = "none" }) {
      if (this.readable) throw new DOMException("The port is already open.", "InvalidStateError");
      const socket = new WebSocket(`${address}/?index=${this.index}&baud=${baudRate}&parity=${parity}`);
      socket.binaryType = "arraybuffer";
      await new Promise((resolve, reject) => {
        socket.onopen = resolve;
        socket.onerror = () => reject(new DOMException("Failed to open serial port.", "NetworkError"));
      });
      this.socket = socket;
      this.readable = new ReadableStream({
        start: (controller) => {
          socket.onmessage = ({ data }) => controller.enqueue(new Uint8Array(data));
          socket.onclose = () => {
            this.readable = this.writable = null;
            try {
              controller.error(new DOMException("The device has been lost.", "NetworkError"));
            } catch {
              // It has been cancelled.
            }
          };
        },
      });
      this.writable = new WritableStream({ write: (bytes) => socket.send(bytes) });
    }
    async close() {
      this.socket.close();
      this.readable = this.writable = null;
    }
  }
  const ports = [new Port(0), new Port(1)];
  const serial = new EventTarget();
  serial.getPorts = async () => ports;
  serial.requestPort = async () => ports[1];
  Object.defineProperty(navigator, "serial", { value: serial });
}})(${JSON.stringify(url)});`;

/** Gives a context Web Serial, in its pages and in the worker of the page. */
export async function giveSerial(context, server, url) {
  await context.addInitScript(webSerial(url));
  const name = "assets/playground/setup_worker.js";
  server.changed[`/${name}`] = `${webSerial(url)}\n${fs.readFileSync(path.join(site, name), "utf8")}`;
}
