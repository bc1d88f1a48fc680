// Connects: by Web Serial, with the ports that the visitor has allowed, or to a bridge.

import { useEffect, useState } from "preact/hooks";

import type { Connected, LineSettings, Place } from "../../setup_messages.js";
import { Button, Choice, Select, SmallButton, TextInput } from "../inputs.js";
import { useTask } from "../session.js";
import { TaskState, useEvents } from "./parts.js";
import { useBench } from "./setup_session.js";

const ways = [
  ["serial", "USB or serial"],
  ["bridge", "sbgc bridge"],
] as const;

interface Way {
  place: Place;
  line: LineSettings | null;
  port?: SerialPort;
}
interface WayProps {
  isPossible: boolean;
  /** Connects in the way that `choose` gives, if it gives one. */
  connect: (choose: () => Promise<Way | null>) => Promise<unknown>;
}
interface Props {
  token: string;
  isReady: boolean;
  onConnected: (board: Connected) => void;
}

export function ConnectPanel({ token, isReady, onConnected }: Props) {
  const { session } = useBench();
  const [way, setWay] = useState<Place["kind"]>(ports && !token ? "serial" : "bridge");
  const task = useTask();
  const connect: WayProps["connect"] = (choose) =>
    task.run(async (progress) => {
      const chosen = await choose();
      if (!chosen) return;
      const board = await session.do("connect", [chosen.place, chosen.line], progress);
      if (chosen.port) boards.set(chosen.port, board.serialNumber);
      onConnected(board);
    });
  const isPossible = isReady && !task.isBusy;
  return (
    <section aria-labelledby="connect-title">
      <h2 id="connect-title">Connect</h2>
      {!ports && <NoSerial />}
      <Choice class="ways" legend="By" options={ways} value={way} onChange={setWay} />
      {way === "serial" ? (
        <SerialWay isPossible={isPossible} connect={connect} />
      ) : (
        <BridgeWay token={token} isPossible={isPossible} connect={connect} />
      )}
      <p class="muted small says">The page finds the settings of the line, and asks the board what it is.</p>
      <TaskState task={task} onCancel={() => session.end("disconnect")} />
    </section>
  );
}

const NoSerial = () => (
  <div class="note warn">
    <p>
      {isSecureContext
        ? "This browser has no Web Serial: Safari and Firefox for Android lack it. Chrome, Edge and a recent Firefox on a desktop computer have it."
        : "This page came over plain http, where browsers keep serial ports from pages. From https or localhost, it can use them."}{" "}
      Or run <code>sbgc bridge --page</code> on the computer that has the gimbal, and open the
      address that it prints.
    </p>
  </div>
);

function SerialWay({ isPossible, connect }: WayProps) {
  const [known, look] = usePorts();
  const [rate, setRate] = useState("");
  const [parity, setParity] = useState<LineSettings["parity"]>("none");
  const wayTo = (port: SerialPort, index: number): Way => {
    const { usbVendorId: vendor = null, usbProductId: product = null } = port.getInfo();
    const line = rate === "" ? null : { baudRate: Number(rate), parity };
    return { place: { kind: "serial", index, vendor, product }, line, port };
  };
  const choose = async (): Promise<Way | null> => {
    const port = await ports?.requestPort().catch(() => null); // null: the visitor chose none
    return port ? wayTo(port, (await look()).indexOf(port)) : null;
  };
  return (
    <>
      <div class="flow row">
        <TextInput
          label="Baud rate"
          type="number"
          placeholder="find"
          value={rate}
          onChange={setRate}
        />
        <label>
          Parity{" "}
          <Select
            label="Parity"
            options={rate ? ["none", "even"] : ["find"]}
            value={rate ? parity : "find"}
            onChange={(one) => setParity(one as LineSettings["parity"])}
          />
        </label>
      </div>
      <Button disabled={!isPossible || !ports} onClick={() => connect(choose)}>
        Connect by USB or serial
      </Button>
      <ul class="ports" aria-label="Ports that this page may use">
        {known.map((port, index) => (
          <li key={index} class="flow row">
            <span>{nameOf(port, index)}</span>
            <SmallButton
              label={`Connect to port ${index + 1}`}
              disabled={!isPossible}
              onClick={() => connect(async () => wayTo(port, index))}
            >
              Connect
            </SmallButton>
          </li>
        ))}
      </ul>
    </>
  );
}

function BridgeWay({ token: given, isPossible, connect }: WayProps & { token: string }) {
  const [url, setUrl] = useState(given ? `ws://${location.host}/` : "ws://127.0.0.1:");
  const [token, setToken] = useState(given);
  const submit = (event: Event): void => {
    event.preventDefault();
    void connect(async () => ({ place: { kind: "bridge", url, token }, line: null }));
  };
  return (
    <form onSubmit={submit}>
      <div class="flow row">
        <TextInput label="Address" type="url" value={url} onChange={setUrl} />
        <TextInput label="Token" type="password" value={token} onChange={setToken} />
      </div>
      <button type="submit" class="plain" disabled={!isPossible}>
        Connect to the bridge
      </button>
      <p class="muted small says">
        <code>sbgc bridge --ws PORT</code> prints both. The token stays in this page.
      </p>
    </form>
  );
}

const ports = (navigator as Partial<Navigator>).serial;

/** The serial number of the board that was last at a port. */
const boards = new Map<SerialPort, string>();

const hex = (id = 0): string => id.toString(16).padStart(4, "0");

/** "Port 2: USB 10c4:ea60, last with board 0A1B". Adapters of one kind differ by their number. */
function nameOf(port: SerialPort, index: number): string {
  const { usbVendorId: vendor, usbProductId: product } = port.getInfo();
  const kind = vendor === undefined ? "no USB" : `USB ${hex(vendor)}:${hex(product)}`;
  const board = boards.get(port);
  return `Port ${index + 1}: ${kind}${board ? `, last with board ${board}` : ""}`;
}

/** The allowed ports, as they come and go, and a function that looks again. */
function usePorts(): [SerialPort[], () => Promise<SerialPort[]>] {
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
