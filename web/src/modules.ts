// The input and output of the WebAssembly modules.

/** The options of an emulated board, as for `sbgc emulate`; all have defaults. */
export interface EmulatorOptions {
  seed?: number;
  /** Raw versions: 30 is 3.0, 2590 is 2.59b0. */
  board?: number;
  firmware?: number;
  /** The motion of the frame that carries the gimbal. */
  motion?: "rest" | "handheld" | "drone" | "vehicle";
  /** A factor of the motion, 0 to 100. */
  strength?: number;
  /** As for `sbgc emulate --fault`: "low-battery", "resonance=37Hz:2:pitch". */
  faults?: string[];
  /** Shares of the line, 0 to 1. */
  bitErrors?: number;
  lostBytes?: number;
  duplicatedBytes?: number;
  delayedBytes?: number;
}

/** A finding of `sbgc doctor`. */
export interface Finding {
  id: string;
  /** 0 roll, 1 pitch, 2 yaw; -1: none. */
  axis: number;
  sentence: string;
  advice: string;
  command: string;
}
