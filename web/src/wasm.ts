// A WebAssembly module with the exchange of web/modules/exchange.hpp: it gives a buffer for the input of
// its functions, and has an output.

type Exported = (...numbers: number[]) => number;

/** Where the bytes of a module come from: an address to fetch, the bytes, or a compiled module. */
export type Source = string | URL | BufferSource | WebAssembly.Module;

async function compile(source: Source): Promise<WebAssembly.Module> {
  if (source instanceof WebAssembly.Module) return source;
  if (typeof source !== "string" && !(source instanceof URL)) return WebAssembly.compile(source);
  const url = new URL(source, import.meta.url);
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url.pathname}: ${response.status} ${response.statusText}`);
  return WebAssembly.compile(await response.arrayBuffer());
}

/** One instance of a module, with its own memory. */
export class Wasm {
  readonly #exports: Record<string, Exported>;
  readonly #memory: WebAssembly.Memory;

  private constructor(readonly module: WebAssembly.Module, instance: WebAssembly.Instance) {
    this.#exports = instance.exports as unknown as Record<string, Exported>;
    this.#memory = instance.exports.memory as WebAssembly.Memory;
    this.#exports._initialize?.();
  }

  static async load(source: Source): Promise<Wasm> {
    const module = await compile(source);
    // The C library refers to files and to the end of the program; there are none.
    const noFile = () => 8;
    const imports = WebAssembly.Module.imports(module).map(({ name }) => [name, noFile]);
    const files = Object.fromEntries(imports) as Record<string, () => number>;
    files.proc_exit = () => {
      throw new Error("the module has failed");
    };
    return new Wasm(module, await WebAssembly.instantiate(module, { wasi_snapshot_preview1: files }));
  }

  /** Calls a function with numbers. */
  call(name: string, ...numbers: number[]): number {
    const exported = this.#exports[name];
    if (exported === undefined) throw new Error(`the module has no function ${name}`);
    return exported(...numbers);
  }

  /** Calls a function with an input, and returns its output, valid until the next call. */
  bytes(name: string, input: Uint8Array | null, ...numbers: number[]): Uint8Array {
    if (input !== null) {
      if (!ArrayBuffer.isView(input) || input.BYTES_PER_ELEMENT !== 1) {
        throw new TypeError("bytes are needed, in a Uint8Array");
      }
      const pointer = this.call("input", input.length);
      new Uint8Array(this.#memory.buffer, pointer, input.length).set(input);
    }
    this.call(name, ...numbers);
    return new Uint8Array(this.#memory.buffer, this.call("output"), this.call("output_size"));
  }

  /** The same with text. */
  text(name: string, input: string | null, ...numbers: number[]): string {
    const bytes = input === null ? null : new TextEncoder().encode(input);
    return new TextDecoder().decode(this.bytes(name, bytes, ...numbers));
  }

  /** Returns numbers in the memory. */
  numbers(pointer: number, count: number): Float64Array {
    return new Float64Array(this.#memory.buffer, pointer, count);
  }
}

/** The members of an argument that are set. */
export function membersOf(values: object): [string, unknown][] {
  if (values === null || typeof values !== "object") throw new TypeError("an object is needed");
  return Object.entries(values).filter(([, value]) => value !== undefined);
}

/** Values as lines NAME=VALUE, which the modules read. */
export const settingLines = (values: object): string =>
  membersOf(values)
    .map(([name, value]) => `${name}=${String(value).replaceAll("\n", " ")}\n`)
    .join("");

export const hexOf = (bytes: Uint8Array): string =>
  Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");

export function bytesOf(hex: string): Uint8Array {
  if (!/^([0-9a-f]{2})*$/i.test(hex)) throw new Error("not bytes in hex digits");
  return Uint8Array.from(hex.match(/../g) ?? [], (digits) => parseInt(digits, 16));
}
