// What cameras believe, and which messages they sent, in a frame: the numbers of the record BeliefFrame, of which old recordings have no messages.

/** Parts of the field along each side. */
export const PARTS = 20;

const WORD = 32; // cameras in a number

/** Where the numbers of the field's parts begin. */
export const partsFrom = run => 4 * run.setup.targets.length;

/** How many messages a camera sent, and the cameras that received them; nothing where that is not known. */
export function told(run, frame, camera) {
  const belief = run.belief[frame];
  const from = partsFrom(run) + PARTS * PARTS;
  if (!belief || belief.length <= from) return null;
  const cameras = run.setup.cameras.map((one, i) => i);
  const first = from + cameras.length + camera * Math.ceil(cameras.length / WORD);
  const hearers = cameras.filter(
    i => Math.floor(belief[first + Math.floor(i / WORD)] / 2 ** (i % WORD)) % 2,
  );
  return {messages: belief[from + camera], hearers};
}
