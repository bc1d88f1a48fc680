// A trial of parameters on an emulated board that has those of the real one.

import { EmulatedGimbal } from "./line.js";
import { SetupClient } from "./setup_client.js";
import type { BoardFacts, Trial } from "./setup_messages.js";
import type { Wasm } from "./wasm.js";

/** The motion that shows how the controllers behave. */
const motion = "handheld";

/** Measures the emulated board with the parameters of one backup, and then with those of another. */
export async function tryOut(
  modules: { gimbal: Wasm; setup: Wasm },
  facts: BoardFacts,
  present: string,
  wanted: string,
): Promise<Trial> {
  const { board, firmware } = facts;
  const client = new SetupClient(modules.setup);
  const gimbal = new EmulatedGimbal(modules.gimbal, { motion, board, firmware }, client);
  await gimbal.during(client.identified);
  await gimbal.during(client.act("motors on", gimbal.now));
  await gimbal.during(client.read());
  const findings = async (backup: string): Promise<string[]> => {
    const plan = client.planFile(backup, 1);
    const [problem] = plan.problems;
    if (problem) throw new Error(problem[1]);
    if (plan.changes.length > 0) {
      const written = await gimbal.during(client.write());
      if (!written.ok) throw new Error(written.text);
    }
    return (await gimbal.during(client.diagnose())).map(({ sentence }) => sentence);
  };
  return { before: await findings(present), after: await findings(wanted) };
}
