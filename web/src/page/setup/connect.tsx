// Connects: by Web Serial, or to a bridge.

import { useId, useState } from "preact/hooks";

import type { Connected, LineSettings, Place } from "../../setup_messages.js";
import { Choice, NumberInput, Select } from "../inputs.js";
import { TaskState } from "./parts.js";
import { nameOf, noteBoard, ports, usePorts, type Port } from "./ports.js";
import { useBench, useTask } from "./setup_session.js";

const ways = [
  ["serial", "USB or serial"],
  ["bridge", "sbgc bridge"],
] as const;
const searches = [
  ["find", "Find"],
  ["given", "Given"],
] as const;
const rates = { least: 300, most: 4_000_000 };

interface Props {
  token: string;
  isReady: boolean;
  onConnected: (board: Connected) => void;
}

export function ConnectPanel({ token, isReady, onConnected }: Props) {
  const { session } = useBench();
  const [way, setWay] = useState<Place["kind"]>(ports && !token ? "serial" : "bridge");
  const task = useTask();
  const connect = async (place: Place, line: LineSettings | null, port?: Port): Promise<void> => {
    const board = await task.run((progress) => session.get("connect", { place, line }, progress));
    if (!board) return;
    if (port) noteBoard(port, board.serialNumber);
    onConnected(board);
  };
  const isPossible = isReady && !task.isBusy;
  return (
    <section aria-labelledby="connect-title" class="connect">
      <h2 id="connect-title">Connect</h2>
      {!ports && <NoSerial />}
      <Choice class="ways" legend="By" options={ways} value={way} onChange={setWay} />
      {way === "serial" ? (
        <SerialWay isPossible={isPossible} connect={connect} />
      ) : (
        <BridgeWay token={token} isPossible={isPossible} connect={connect} />
      )}
      <TaskState task={task} />
      {task.isBusy && (
        <button
          type="button"
          class="plain quiet small"
          onClick={() => void session.ask({ kind: "disconnect" })}
        >
          Give up
        </button>
      )}
    </section>
  );
}

const NoSerial = () => (
  <div class="note warn">
    <p>
      {isSecureContext
        ? "This browser has no Web Serial, as Safari and Firefox for Android. Chrome, Edge and Firefox on a desktop computer have it."
        : "This page came over plain http, where browsers keep serial ports from pages. From https or localhost, it can use them."}{" "}
      Or run <code>sbgc bridge --page</code> on the computer that has the gimbal, and open the
      address that it prints.
    </p>
  </div>
);

interface WayProps {
  isPossible: boolean;
  connect: (place: Place, line: LineSettings | null, port?: Port) => Promise<void>;
}

function SerialWay({ isPossible, connect }: WayProps) {
  const [known, look] = usePorts();
  const [search, setSearch] = useState<(typeof searches)[number][0]>("find");
  const [baudRate, setBaudRate] = useState(115_200);
  const [parity, setParity] = useState<LineSettings["parity"]>("none");
  const rate = useId();
  const open = (port: Port, index: number): void => {
    const { usbVendorId, usbProductId } = port.getInfo();
    const place: Place = {
      kind: "serial",
      index,
      vendor: usbVendorId ?? null,
      product: usbProductId ?? null,
    };
    void connect(place, search === "given" ? { baudRate, parity } : null, port);
  };
  const choose = async (): Promise<void> => {
    const port = await ports?.requestPort().catch(() => null); // null: the visitor has changed their mind
    if (port) open(port, (await look()).indexOf(port));
  };
  return (
    <>
      <div class="do">
        <Choice
          class="line-settings"
          legend="Baud rate and parity"
          options={searches}
          value={search}
          onChange={setSearch}
        />
        {search === "given" && (
          <span class="parts">
            <label class="hidden" for={rate}>
              Baud rate
            </label>
            <NumberInput id={rate} limits={rates} value={baudRate} onChange={setBaudRate} />
            <Select
              label="Parity"
              options={["none", "even"]}
              value={parity}
              onChange={(one) => setParity(one as LineSettings["parity"])}
            />
          </span>
        )}
      </div>
      <button
        type="button"
        class="plain"
        disabled={!isPossible || !ports}
        onClick={() => void choose()}
      >
        Connect by USB or serial
      </button>
      {known.length > 0 && (
        <ul class="ports" aria-label="Ports that this page may use">
          {known.map((port, index) => (
            <li key={index}>
              <span>{nameOf(port, index)}</span>
              <button
                type="button"
                class="plain quiet small"
                aria-label={`Connect to port ${index + 1}`}
                disabled={!isPossible}
                onClick={() => open(port, index)}
              >
                Connect
              </button>
            </li>
          ))}
        </ul>
      )}
    </>
  );
}

function BridgeWay({ token: given, isPossible, connect }: WayProps & { token: string }) {
  const [url, setUrl] = useState(given ? `ws://${location.host}/` : "ws://127.0.0.1:");
  const [token, setToken] = useState(given);
  const submit = (event: Event): void => {
    event.preventDefault();
    void connect({ kind: "bridge", url, token }, null);
  };
  return (
    <form class="bridge" onSubmit={submit}>
      <label>
        Address
        <input
          type="url"
          required
          spellcheck={false}
          value={url}
          onInput={(event) => setUrl(event.currentTarget.value)}
        />
      </label>
      <label>
        Token
        <input
          type="password"
          autocomplete="off"
          value={token}
          onInput={(event) => setToken(event.currentTarget.value)}
        />
      </label>
      <button type="submit" class="plain" disabled={!isPossible}>
        Connect to the bridge
      </button>
      <p class="muted">
        <code>sbgc bridge --ws PORT</code> prints both; the token stays in this page.
      </p>
    </form>
  );
}
