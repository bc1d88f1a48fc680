// The serial ports that the visitor has allowed. The types of the browser's interface lack them.

import { useEffect, useState } from "preact/hooks";

export interface Port {
  getInfo(): { usbVendorId?: number; usbProductId?: number };
}
interface Ports extends EventTarget {
  getPorts(): Promise<Port[]>;
  requestPort(): Promise<Port>;
}

export const ports = (navigator as { serial?: Ports }).serial;

/** The serial number of the board that was last at a port. */
const boards = new Map<Port, string>();
export const noteBoard = (port: Port, serialNumber: string): void =>
  void boards.set(port, serialNumber);

const hex = (id: number): string => id.toString(16).padStart(4, "0");

/** "Port 2: USB 10c4:ea60, last with board 0A1B". Adapters of one kind differ by their number. */
export function nameOf(port: Port, index: number): string {
  const { usbVendorId: vendor, usbProductId: product } = port.getInfo();
  const kind = vendor === undefined ? "no USB" : `USB ${hex(vendor)}:${hex(product ?? 0)}`;
  const board = boards.get(port);
  return `Port ${index + 1}: ${kind}${board ? `, last with board ${board}` : ""}`;
}

/** The allowed ports, as they come and go, and a function that looks again. */
export function usePorts(): [Port[], () => Promise<Port[]>] {
  const [known, setKnown] = useState<Port[]>([]);
  const look = async (): Promise<Port[]> => {
    const now = (await ports?.getPorts()) ?? [];
    setKnown(now);
    return now;
  };
  useEffect(() => {
    const again = (): void => void look();
    again();
    for (const kind of ["connect", "disconnect"]) ports?.addEventListener(kind, again);
    return () => {
      for (const kind of ["connect", "disconnect"]) ports?.removeEventListener(kind, again);
    };
  }, []);
  return [known, look];
}
