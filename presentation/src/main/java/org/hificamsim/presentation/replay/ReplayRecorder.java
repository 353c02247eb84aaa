package org.hificamsim.presentation.replay;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * Records the first repeats of a run, as many as fit into {@code replay.json}. Repeats may run at
 * the same time.
 */
public final class ReplayRecorder {
  private static final int MAX_RUNS = 50;
  private static final StepListener NO_RECORDING = (network, coverage) -> {};

  /**
   * The limits of a recording.
   *
   * @param frames the greatest number of frames of one run
   * @param numbers the greatest count of numbers in all frames of one run
   * @param bytes the greatest number of bytes of all packed runs and the setup. Frames are left out
   *     until they fit, but the first and the last frame always stay
   */
  record Limits(int frames, long numbers, int bytes) {
    /** Limits for a page of less than 5 MB and the memory of a small machine. */
    static final Limits DEFAULT = new Limits(20_000, 1 << 23, 4_400_000);

    /** Returns the greatest number of frames for a setup, 2 or more. */
    int frames(Setup setup, boolean hasBelief) {
      long perFrame = setup.numbersPerFrame() + (hasBelief ? BeliefFrame.length(setup) : 0);
      return (int) Math.max(2, Math.min(frames, numbers / (1 + perFrame)));
    }
  }

  private final Setup setup;
  private final Detection detection;
  private final int repeats;
  private final Limits limits;

  /** The greatest number of bytes of all runs. If it is 0, one run of two frames is still kept. */
  private final int maxBytes;

  private final Map<Integer, Tape> tapes = new ConcurrentSkipListMap<>();

  /**
   * @param repeats the number of repeats
   */
  public ReplayRecorder(Setup setup, Detection detection, int repeats) {
    this(setup, detection, repeats, Limits.DEFAULT);
  }

  ReplayRecorder(Setup setup, Detection detection, int repeats, Limits limits) {
    this.setup = setup;
    this.detection = detection;
    this.repeats = repeats;
    this.limits = limits;
    this.maxBytes = Math.max(0, limits.bytes() - ReplayJson.of(setup).length());
  }

  /** Returns the listener that records one repeat. */
  public StepListener listener(int run) {
    if (run >= MAX_RUNS || isFull()) {
      return NO_RECORDING;
    }
    Tape tape = new Tape(run);
    tapes.put(run, tape);
    return tape;
  }

  /** Whether the repeats that have ended fill the file, so that later ones are not recorded. */
  private boolean isFull() {
    long bytes = 0;
    for (int run = 0; tapes.containsKey(run) && tapes.get(run).packed != null; run++) {
      bytes += tapes.get(run).packed.bytes();
    }
    return bytes > maxBytes;
  }

  /** Writes the recording. */
  public void write(OutputStream out) throws IOException {
    List<PackedRun> runs = new ArrayList<>();
    long bytes = 0;
    for (Tape tape : tapes.values()) {
      bytes += tape.packed.bytes();
      if (bytes <= maxBytes || runs.isEmpty()) {
        runs.add(tape.packed);
      }
    }
    ReplayJson.mapper().writeValue(out, new Replay(Replay.FORMAT, repeats, setup, runs));
  }

  /**
   * Records one run. It keeps every step as long as all fit, then every other one, every fourth,
   * and so on.
   */
  private final class Tape implements StepListener {
    private final int run;
    private final List<Frame> frames = new ArrayList<>();
    private final List<Move> moves = new ArrayList<>();
    private Snapshots snapshots;
    private int maxFrames;
    private Frame last;
    private long every = 1;
    private volatile PackedRun packed; // null before the run has ended

    Tape(int run) {
      this.run = run;
    }

    @Override
    public void started(OracleView network, ZoomPolicy policy) {
      snapshots = new Snapshots(setup, detection, policy);
      maxFrames = limits.frames(setup, snapshots.hasBelief(network));
    }

    /** Takes each frame at once, because targets may move before the run ends. */
    @Override
    public void stepped(OracleView network, StepCoverage coverage) {
      moves.addAll(snapshots.moves(network));
      last = snapshots.take(network);
      if (last.step() % every == 0) {
        frames.add(last);
        if (frames.size() > maxFrames) {
          thin();
        }
      }
    }

    @Override
    public void ended(OracleView network) {
      PackedRun candidate = pack(snapshots.estimated(network));
      while (candidate.bytes() > maxBytes && frames.size() > 2) {
        thin();
        candidate = pack(candidate.estimated());
      }
      packed = candidate;
      frames.clear();
    }

    private void thin() {
      every *= 2;
      frames.removeIf(frame -> frame.step() % every != 0);
    }

    private PackedRun pack(String estimated) {
      List<Frame> kept = new ArrayList<>(frames);
      if (last.step() % every != 0) {
        kept.add(last);
      }
      return PackedRun.of(
          setup,
          new RecordedRun(
              run,
              setup.seed() + run,
              last.step() + 1,
              every,
              estimated,
              List.copyOf(moves),
              kept));
    }
  }
}
