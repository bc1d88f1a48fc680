// Recordings in the format of <sbgc/io/capture.hpp>, which `sbgc decode` reads.

import type { Direction } from "./messages.js";

const crcTable = Uint32Array.from({ length: 256 }, (_, byte) => {
  let crc = byte;
  for (let bit = 0; bit < 8; ++bit) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  return crc;
});

function crc32(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = (crcTable[(crc ^ byte) & 0xff] ?? 0) ^ (crc >>> 8);
  return ~crc >>> 0;
}

/** Bytes with a checksum at their end. */
function sealed(size: number, fill: (view: DataView, bytes: Uint8Array) => void): Uint8Array {
  const bytes = new Uint8Array(size + 4);
  const view = new DataView(bytes.buffer);
  fill(view, bytes);
  view.setUint32(size, crc32(bytes.subarray(0, size)), true);
  return bytes;
}

/** One session. Times are microseconds and do not decrease. */
export class Capture {
  readonly #parts: Uint8Array[];
  readonly #begin: number;

  constructor(now: number) {
    this.#begin = now;
    const magic = [0x89, 0x53, 0x42, 0x47, 0x43, 0x0d, 0x0a, 0x1a];
    this.#parts = [
      sealed(20, (view, bytes) => {
        bytes.set(magic);
        view.setUint16(8, 1, true);
        view.setBigUint64(12, BigInt(Date.now()) * 1000n, true);
      }),
    ];
  }

  add(from: Direction, data: Uint8Array, now: number): void {
    const record = sealed(12 + data.length, (view, bytes) => {
      bytes[0] = 0xa5;
      bytes[1] = from === "board" ? 1 : 2;
      view.setUint16(2, data.length, true);
      view.setBigUint64(4, BigInt(Math.floor(now - this.#begin)), true);
      bytes.set(data, 12);
    });
    this.#parts.push(record);
  }

  /** The content of the file. */
  bytes(): Uint8Array<ArrayBuffer> {
    const all = new Uint8Array(this.#parts.reduce((size, part) => size + part.length, 0));
    let at = 0;
    for (const part of this.#parts) {
      all.set(part, at);
      at += part.length;
    }
    return all;
  }
}
