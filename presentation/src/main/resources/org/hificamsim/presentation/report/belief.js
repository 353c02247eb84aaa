// Reads the record BeliefFrame: what cameras believe in a frame, and the messages that they sent.
// Recordings of older versions have no messages. Rhino runs this file too: see scene.js.

/** The number of parts of the field along each side. */
export const PARTS_PER_SIDE = 20;

/** How many numbers describe a target: x, y, weight and spread. */
export const TARGET_NUMBERS = 4;

/** How many receivers one number has as its bits. */
const CAMERAS_PER_NUMBER = 32;

/** The index of the first number of the field's parts. */
export const partsOffset = run => TARGET_NUMBERS * run.setup.targets.length;

/**
 * Returns how many messages a camera sent in a frame and which cameras received them, {messages,
 * receivers}; null if the recording does not say.
 */
export function sentMessages(run, frame, camera) {
  const belief = run.belief[frame];
  const offset = partsOffset(run) + PARTS_PER_SIDE * PARTS_PER_SIDE;
  if (!belief || belief.length <= offset) return null;
  const cameras = run.setup.cameras.map((spec, i) => i);
  const numbersPerSender = Math.ceil(cameras.length / CAMERAS_PER_NUMBER);
  const first = offset + cameras.length + camera * numbersPerSender;
  const receivers = cameras.filter(i => {
    const bits = belief[first + Math.floor(i / CAMERAS_PER_NUMBER)];
    return Math.floor(bits / 2 ** (i % CAMERAS_PER_NUMBER)) % 2;
  });
  return {messages: belief[offset + camera], receivers};
}
