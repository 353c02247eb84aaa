package org.hificamsim.presentation.replay;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * Records one run: every step as long as they fit, then every other one, every fourth, and so on.
 */
final class FrameRecorder implements StepListener {
  private final Setup setup;
  private final Detection detection;
  private final int run;
  private final RecordingLimits limits;
  private final List<Frame> frames = new ArrayList<>();
  private final List<Move> moves = new ArrayList<>();
  private Snapshots snapshots;
  private Frame last;
  private long every = 1;
  private volatile PackedRun packed;

  FrameRecorder(Setup setup, Detection detection, int run, RecordingLimits limits) {
    this.setup = setup;
    this.detection = detection;
    this.run = run;
    this.limits = limits;
  }

  @Override
  public void started(NetworkView network, ZoomPolicy policy) {
    snapshots = new Snapshots(setup, detection, policy);
  }

  /** Targets may move before the run ends, so that the last frame is taken here too. */
  @Override
  public void stepped(NetworkView network, StepCoverage coverage) {
    moves.addAll(snapshots.moves(network));
    last = snapshots.take(network);
    if (last.step() % every == 0) {
      frames.add(last);
      if (frames.size() > limits.frames(setup)) {
        thin();
      }
    }
  }

  @Override
  public void ended(NetworkView network) {
    packed = pack(snapshots.estimated(network));
    while (packed.bytes() > limits.bytes() && frames.size() > 2) {
      thin();
      packed = pack(packed.estimated());
    }
    frames.clear();
  }

  /** The run; null before it has ended. */
  PackedRun packed() {
    return packed;
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
