package org.hificamsim.presentation.replay;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;

/**
 * Records the repeats of a plan for {@code replay.json}: the first ones, as many as fit. Repeats
 * may run at the same time.
 */
public final class ReplayRecorder {
  private static final int MAX_RUNS = 50;
  private static final StepListener NOTHING = (network, coverage) -> {};

  private final Setup setup;
  private final Detection detection;
  private final int repeats;
  private final RecordingLimits limits;
  private final Map<Integer, FrameRecorder> tapes = new ConcurrentSkipListMap<>();

  /**
   * @param repeats how many there will be
   */
  public ReplayRecorder(Setup setup, Detection detection, int repeats) {
    this(setup, detection, repeats, RecordingLimits.USUAL);
  }

  ReplayRecorder(Setup setup, Detection detection, int repeats, RecordingLimits limits) {
    this.setup = setup;
    this.detection = detection;
    this.repeats = repeats;
    this.limits = limits.beside(setup);
  }

  /** The listener that records one repeat. */
  public StepListener listener(int run) {
    if (run >= MAX_RUNS || full()) {
      return NOTHING;
    }
    FrameRecorder tape = new FrameRecorder(setup, detection, run, limits);
    tapes.put(run, tape);
    return tape;
  }

  /** Whether the first repeats that have ended already fill the file: later ones are not kept. */
  private boolean full() {
    long bytes = 0;
    for (int run = 0; tapes.containsKey(run) && tapes.get(run).packed() != null; run++) {
      bytes += tapes.get(run).packed().bytes();
    }
    return bytes > limits.bytes();
  }

  /** Writes what was recorded. */
  public void write(OutputStream out) throws IOException {
    ReplayJson.mapper().writeValue(out, replay());
  }

  private Replay replay() {
    List<PackedRun> runs = new ArrayList<>();
    long bytes = 0;
    for (FrameRecorder tape : tapes.values()) {
      bytes += tape.packed().bytes();
      if (bytes > limits.bytes() && !runs.isEmpty()) {
        break;
      }
      runs.add(tape.packed());
    }
    return new Replay(Replay.FORMAT, repeats, setup, runs);
  }
}
