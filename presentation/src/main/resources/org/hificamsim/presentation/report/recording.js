// Unpacks the runs of a recording. Its series of whole numbers are written as differences, in
// LEB128, compressed, in Base64.
import {inflate} from './inflate.js';
import {Run} from './run.js';

/** Reads series of numbers one after the other. */
export class SeriesReader {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }

  /** Reads a zigzag number, by arithmetic because shifts are limited to 32 bits. */
  number() {
    let code = 0;
    let factor = 1;
    for (;;) {
      const byte = this.bytes[this.at++];
      if (byte === undefined) throw new Error('The data of this run end early.');
      code += (byte & 127) * factor;
      if (byte < 128) return code % 2 ? -(code + 1) / 2 : code / 2;
      factor *= 128;
    }
  }

  /** Reads the next series and converts each of its numbers. */
  series(count, convert) {
    const numbers = new Array(count);
    let sum = 0;
    for (let i = 0; i < count; i++) {
      sum += this.number();
      numbers[i] = convert(sum);
    }
    return numbers;
  }
}

const plain = code => code;
const scaled = perUnit => code => code / perUnit;

/** Returns a function that decodes numbers that may be missing: 0 is NaN, others are zigzag + 1. */
export const optional = perUnit => code => {
  if (code === 0) return NaN;
  const zigzag = code - 1;
  return (zigzag % 2 ? -(zigzag + 1) / 2 : zigzag / 2) / perUnit;
};

const transposed = series => series[0].map((first, frame) => series.map(list => list[frame]));

/** Unpacks a record PackedRun into a Run. */
export async function unpack(setup, packed) {
  const run = new Run(setup, packed.estimated);
  const reader = new SeriesReader(await inflate(packed.data));
  const next = convert => reader.series(packed.frames, convert);
  run.step = next(plain);
  setup.cameras.forEach((camera, i) => {
    run.online[i] = next(plain);
    run.level[i] = next(plain);
    run.detected[i] = next(plain);
  });
  setup.targets.forEach((target, i) => {
    run.present[i] = next(plain);
    run.x[i] = next(scaled(packed.scale));
    run.y[i] = next(scaled(packed.scale));
    run.coverage[i] = next(plain);
  });
  if (packed.estimated) {
    run.estimates.forEach((views, i) =>
      views.forEach((list, j) => {
        views[j] = next(optional(packed.estimateScale));
        run.counts[i][j] = next(optional(1));
      }),
    );
  }
  run.seeing.forEach((list, i) => (run.seeing[i] = next(plain)));
  run.belief = packed.beliefs
    ? transposed(Array.from({length: packed.beliefs}, () => next(scaled(1000))))
    : [];
  run.holders.forEach((list, i) => (run.holders[i] = next(plain)));
  packed.moves.forEach(move => run.move(move));
  Object.assign(run, {
    every: packed.every,
    steps: packed.steps,
    seed: packed.seed,
    number: packed.run,
  });
  for (run.count = 0; run.count < packed.frames; run.count++) run.measure(run.count);
  return run;
}
