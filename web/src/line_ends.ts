// The lines to a real gimbal: Web Serial, and the WebSocket of `sbgc bridge`.

import { sentenceOf } from "./answers.js";
import type { LineSettings } from "./client.js";
import type { LineEnd, LineHandlers } from "./connection.js";
import type { Place } from "./setup_messages.js";

/** Opens the line. `settings` are those of a serial port. */
export function open(place: Place, settings: LineSettings, handlers: LineHandlers): Promise<LineEnd> {
  return place.kind === "serial"
    ? SerialLine.open(place, settings, handlers)
    : BridgeLine.open(place.url, place.token, handlers);
}

const bitsPerByte = (settings: LineSettings): number => (settings.parity === "none" ? 10 : 11);

/** The port at a place: adapters of one kind are told apart by their order. */
async function portAt(place: Extract<Place, { kind: "serial" }>): Promise<SerialPort> {
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

  private constructor(
    readonly port: SerialPort,
    readonly handlers: LineHandlers,
    private settings: LineSettings,
  ) {}

  static async open(
    place: Extract<Place, { kind: "serial" }>,
    settings: LineSettings,
    handlers: LineHandlers,
  ): Promise<SerialLine> {
    const line = new SerialLine(await portAt(place), handlers, settings);
    await line.#begin(settings);
    return line;
  }

  async #begin(settings: LineSettings): Promise<void> {
    this.settings = settings;
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
    const { baudRate } = this.settings;
    const due = begin + (bytes.length * bitsPerByte(this.settings) * 1000) / baudRate;
    const left = due - performance.now();
    if (left > 0) await new Promise((resolve) => setTimeout(resolve, left));
  }

  async set(settings: LineSettings): Promise<void> {
    const { baudRate, parity } = this.settings;
    if (settings.baudRate === baudRate && settings.parity === parity) return;
    await this.close();
    await this.#begin(settings);
  }

  async close(): Promise<void> {
    this.#isClosing = true;
    await this.#reader?.cancel().catch(() => {});
    await this.#reading;
    this.#writer?.releaseLock();
    await this.port.close().catch(() => {});
  }
}

class BridgeLine implements LineEnd {
  #isClosing = false;

  private constructor(readonly socket: WebSocket) {}

  static open(url: string, token: string, handlers: LineHandlers): Promise<BridgeLine> {
    const socket = new WebSocket(url, ["sbgc", `token.${token}`]);
    socket.binaryType = "arraybuffer";
    const line = new BridgeLine(socket);
    return new Promise((resolve, reject) => {
      socket.onopen = () => resolve(line);
      socket.onerror = () => reject(new Error("the bridge does not answer, or refuses the token"));
      socket.onmessage = ({ data }) => handlers.received(new Uint8Array(data as ArrayBuffer));
      socket.onclose = ({ reason }) => {
        reject(new Error(reason || "the bridge has closed the connection"));
        if (!line.#isClosing) handlers.lost(reason || "the bridge has closed the connection");
      };
    });
  }

  async write(bytes: Uint8Array): Promise<void> {
    this.socket.send(bytes as Uint8Array<ArrayBuffer>);
  }

  async set(): Promise<void> {}

  async close(): Promise<void> {
    this.#isClosing = true;
    this.socket.close();
  }
}
