// The serial ports that the visitor has allowed.

import { useEffect, useState } from "preact/hooks";

import { useEvents } from "./events.js";

export const ports = (navigator as Partial<Navigator>).serial;

/** The serial number of the board that was last at a port. */
const boards = new Map<SerialPort, string>();
export const noteBoard = (port: SerialPort, serialNumber: string): void =>
  void boards.set(port, serialNumber);

const hex = (id = 0): string => id.toString(16).padStart(4, "0");

/** "Port 2: USB 10c4:ea60, last with board 0A1B". Adapters of one kind differ by their number. */
export function nameOf(port: SerialPort, index: number): string {
  const { usbVendorId: vendor, usbProductId: product } = port.getInfo();
  const kind = vendor === undefined ? "no USB" : `USB ${hex(vendor)}:${hex(product)}`;
  const board = boards.get(port);
  return `Port ${index + 1}: ${kind}${board ? `, last with board ${board}` : ""}`;
}

/** The allowed ports, as they come and go, and a function that looks again. */
export function usePorts(): [SerialPort[], () => Promise<SerialPort[]>] {
  const [known, setKnown] = useState<SerialPort[]>([]);
  const look = async (): Promise<SerialPort[]> => {
    const now = (await ports?.getPorts()) ?? [];
    setKnown(now);
    return now;
  };
  useEffect(() => void look(), []);
  useEvents(ports, ["connect", "disconnect"], look);
  return [known, look];
}
