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
 * Records the repeats of a plan for {@code replay.json}: the first ones, as many as fit. Repeats
 * may run at the same time.
 */
public final class ReplayRecorder {
  private static final int MAX_RUNS = 50;
  private static final StepListener NOTHING = (network, coverage) -> {};

  /**
   * How much is kept.
   *
   * @param frames most frames of a run
   * @param numbers most numbers in all frames of a run together
   * @param bytes most bytes of all runs together, packed, and of the setup; frames are left out for
   *     it down to the first and the last one, whatever the cameras' poses take
   */
  record Limits(int frames, long numbers, int bytes) {
    /** A page of less than 5 MB, the memory of a small machine. */
    static final Limits USUAL = new Limits(20_000, 1 << 23, 4_400_000);

    /** The most frames of one run, 2 or more. */
    int frames(Setup setup, boolean believed) {
      long perFrame = setup.numbersPerFrame() + (believed ? BeliefFrame.length(setup) : 0);
      return (int) Math.max(2, Math.min(frames, numbers / (1 + perFrame)));
    }
  }

  private final Setup setup;
  private final Detection detection;
  private final int repeats;
  private final Limits limits;
  private final int mostBytes; // 0 with a large setup: one run of two frames is kept
  private final Map<Integer, Tape> tapes = new ConcurrentSkipListMap<>();

  /**
   * @param repeats how many there will be
   */
  public ReplayRecorder(Setup setup, Detection detection, int repeats) {
    this(setup, detection, repeats, Limits.USUAL);
  }

  ReplayRecorder(Setup setup, Detection detection, int repeats, Limits limits) {
    this.setup = setup;
    this.detection = detection;
    this.repeats = repeats;
    this.limits = limits;
    this.mostBytes = Math.max(0, limits.bytes() - ReplayJson.of(setup).length());
  }

  /** The listener that records one repeat. */
  public StepListener listener(int run) {
    if (run >= MAX_RUNS || full()) {
      return NOTHING;
    }
    Tape tape = new Tape(run);
    tapes.put(run, tape);
    return tape;
  }

  /** Whether the first repeats that have ended already fill the file: later ones are not kept. */
  private boolean full() {
    long bytes = 0;
    for (int run = 0; tapes.containsKey(run) && tapes.get(run).packed != null; run++) {
      bytes += tapes.get(run).packed.bytes();
    }
    return bytes > mostBytes;
  }

  /** Writes what was recorded. */
  public void write(OutputStream out) throws IOException {
    List<PackedRun> runs = new ArrayList<>();
    long bytes = 0;
    for (Tape tape : tapes.values()) {
      bytes += tape.packed.bytes();
      if (bytes <= mostBytes || runs.isEmpty()) {
        runs.add(tape.packed);
      }
    }
    ReplayJson.mapper().writeValue(out, new Replay(Replay.FORMAT, repeats, setup, runs));
  }

  /**
   * Records one run: every step as long as they fit, then every other one, every fourth, and so on.
   */
  private final class Tape implements StepListener {
    private final int run;
    private final List<Frame> frames = new ArrayList<>();
    private final List<Move> moves = new ArrayList<>();
    private Snapshots snapshots;
    private int mostFrames;
    private Frame last;
    private long every = 1;
    private volatile PackedRun packed; // null before the run has ended

    Tape(int run) {
      this.run = run;
    }

    @Override
    public void started(OracleView network, ZoomPolicy policy) {
      snapshots = new Snapshots(setup, detection, policy);
      mostFrames = limits.frames(setup, snapshots.believed(network));
    }

    /** Targets may move before the run ends, so that the last frame is taken here too. */
    @Override
    public void stepped(OracleView network, StepCoverage coverage) {
      moves.addAll(snapshots.moves(network));
      last = snapshots.take(network);
      if (last.step() % every == 0) {
        frames.add(last);
        if (frames.size() > mostFrames) {
          thin();
        }
      }
    }

    @Override
    public void ended(OracleView network) {
      PackedRun all = pack(snapshots.estimated(network));
      while (all.bytes() > mostBytes && frames.size() > 2) {
        thin();
        all = pack(all.estimated());
      }
      packed = all;
      frames.clear();
    }

    private void thin() {
      every *= 2;
      frames.removeIf(frame -> frame.step() % every != 0);
    }

    private PackedRun pack(String estimated) {
      List<Frame> all = new ArrayList<>(frames);
      if (last.step() % every != 0) {
        all.add(last);
      }
      return PackedRun.of(
          setup,
          new RecordedRun(
              run, setup.seed() + run, last.step() + 1, every, estimated, List.copyOf(moves), all));
    }
  }
}
