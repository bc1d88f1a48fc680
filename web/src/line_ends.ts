// The lines to a real gimbal: Web Serial, and the WebSocket of `sbgc bridge`.

import { sentenceOf } from "./answers.js";
import type { LineSettings } from "./client.js";
import { type LineEnd, type LineHandlers, usualLine } from "./connection.js";
import type { Place } from "./setup_messages.js";

type SerialPlace = Extract<Place, { kind: "serial" }>;

/** Opens the line. `settings` are those of a serial port. */
export async function open(
  place: Place,
  settings: LineSettings,
  handlers: LineHandlers,
): Promise<LineEnd> {
  if (place.kind === "bridge") return openBridge(place.url, place.token, handlers);
  const line = new SerialLine(await portAt(place), handlers);
  await line.set(settings);
  return line;
}

/** The port at a place: adapters of one kind are told apart by their order. */
async function portAt(place: SerialPlace): Promise<SerialPort> {
  if (!("serial" in navigator)) throw new Error("this browser has no Web Serial");
  const same = (port: SerialPort): boolean => {
    const { usbVendorId = null, usbProductId = null } = port.getInfo();
    return usbVendorId === place.vendor && usbProductId === place.product;
  };
  const ports = await navigator.serial.getPorts();
  const chosen = ports[place.index];
  const port = chosen && same(chosen) ? chosen : ports.find(same);
  if (!port) throw new Error("the port is not there: is the cable plugged in?");
  return port;
}

class SerialLine implements LineEnd {
  #reader: ReadableStreamDefaultReader<Uint8Array> | undefined;
  #writer: WritableStreamDefaultWriter<Uint8Array> | undefined;
  #reading: Promise<void> = Promise.resolve();
  #isClosing = false;
  #settings: LineSettings | undefined;

  constructor(
    readonly port: SerialPort,
    readonly handlers: LineHandlers,
  ) {}

  async set(settings: LineSettings): Promise<void> {
    const { baudRate, parity } = this.#settings ?? {};
    if (settings.baudRate === baudRate && settings.parity === parity) return;
    if (this.#settings) await this.close();
    this.#settings = settings;
    this.#isClosing = false;
    try {
      await this.port.open({ ...settings, bufferSize: 4096 });
    } catch (error) {
      throw new Error(`the port does not open; does another program or page use it? (${sentenceOf(error)})`);
    }
    this.#writer = this.port.writable?.getWriter();
    this.#reading = this.#read();
  }

  async #read(): Promise<void> {
    // An error of the line, such as a break, ends one stream; the next one goes on.
    while (this.port.readable && !this.#isClosing) {
      this.#reader = this.port.readable.getReader();
      try {
        for (;;) {
          const { value, done } = await this.#reader.read();
          if (done) break;
          this.handlers.received(value);
        }
      } catch {
        // port.readable says whether the port is lost.
      } finally {
        this.#reader.releaseLock();
      }
    }
    if (!this.#isClosing) this.handlers.lost("the port is gone: the cable was pulled, or the board has no power");
  }

  async write(bytes: Uint8Array): Promise<void> {
    const begin = performance.now();
    await this.#writer?.write(bytes);
    // The driver takes bytes before they are on the wire.
    const { baudRate, parity } = this.#settings ?? usualLine;
    const bitsPerByte = parity === "none" ? 10 : 11;
    const due = begin + (bytes.length * bitsPerByte * 1000) / baudRate;
    const left = due - performance.now();
    if (left > 0) await new Promise((resolve) => setTimeout(resolve, left));
  }

  async close(): Promise<void> {
    this.#isClosing = true;
    await this.#reader?.cancel().catch(() => {});
    await this.#reading;
    this.#writer?.releaseLock();
    await this.port.close().catch(() => {});
  }
}

function openBridge(url: string, token: string, handlers: LineHandlers): Promise<LineEnd> {
  const socket = new WebSocket(url, ["sbgc", `token.${token}`]);
  socket.binaryType = "arraybuffer";
  let isClosing = false;
  const line: LineEnd = {
    write: async (bytes) => socket.send(bytes as Uint8Array<ArrayBuffer>),
    set: async () => {},
    close: async () => {
      isClosing = true;
      socket.close();
    },
  };
  return new Promise((resolve, reject) => {
    socket.onopen = () => resolve(line);
    socket.onerror = () => reject(new Error("the bridge does not answer, or refuses the token"));
    socket.onmessage = ({ data }) => handlers.received(new Uint8Array(data as ArrayBuffer));
    socket.onclose = ({ reason }) => {
      const text = reason || "the bridge has closed the connection";
      reject(new Error(text));
      if (!isClosing) handlers.lost(text);
    };
  });
}
