package org.hificamsim.presentation.picture;

import java.awt.image.BufferedImage;
import java.lang.reflect.Array;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.hificamsim.core.InputException;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.presentation.replay.CameraPose;
import org.hificamsim.presentation.replay.FloorPictures;
import org.hificamsim.presentation.replay.Frame;
import org.hificamsim.presentation.replay.Move;
import org.hificamsim.presentation.replay.RecordedRun;
import org.hificamsim.presentation.replay.Setup;

/** The frames of a recorded run, prepared for painting. This class is not thread-safe. */
public final class RunFrames {
  /** The number of frames of a trail, as in {@code path-layers.js}. */
  private static final int TRAIL_FRAMES = 40;

  private final Setup setup;
  private final RecordedRun recording;
  private final Look look;
  private final FieldScript script;
  private final BufferedImage[] floor;
  private final Optional<FrameScores> scores;
  private final double[] scoreByFrame;
  private final int mostTargets;

  public RunFrames(Setup setup, RecordedRun recording) {
    this(setup, recording, Look.DEFAULT, Optional.empty());
  }

  public RunFrames(Setup setup, RecordedRun recording, Look look, Optional<FrameScores> scores) {
    this.setup = setup;
    this.look = look;
    this.script = new FieldScript(setup);
    this.floor = setup.floor().stream().map(FloorPictures::image).toArray(BufferedImage[]::new);
    this.recording = recording;
    List<StepCoverage> coverages = recording.frames().stream().map(Frame::measure).toList();
    this.scores = scores;
    this.scoreByFrame =
        scores
            .map(
                known ->
                    recording.frames().stream()
                        .mapToDouble(frame -> known.byStep().get(frame.step())))
            .orElseGet(() -> coverages.stream().mapToDouble(StepCoverage::kMin))
            .toArray();
    this.mostTargets = coverages.stream().mapToInt(StepCoverage::targets).max().orElse(1);
  }

  Setup setup() {
    return setup;
  }

  /** The field of the run, in metres. */
  public Field field() {
    return setup.field();
  }

  Look look() {
    return look;
  }

  /** The pictures under the field. */
  BufferedImage[] floor() {
    return floor;
  }

  FieldScript script() {
    return script;
  }

  RecordedRun recording() {
    return recording;
  }

  Frame frame(int index) {
    return recording.frames().get(index);
  }

  /** The number of frames, 1 or more. */
  public int count() {
    return scoreByFrame.length;
  }

  /** The step of a frame. */
  public long step(int index) {
    return frame(index).step();
  }

  /** The number of steps from one frame to the next. */
  public long stepsApart() {
    return recording.every();
  }

  /** The last step. */
  public long last() {
    return recording.steps() - 1;
  }

  /** The score of a frame; its k_min if that is the objective. */
  double score(int index) {
    return scoreByFrame[index];
  }

  Optional<FrameScores> scores() {
    return scores;
  }

  /**
   * Returns the index of the frame of a step.
   *
   * @param option the option that gave the step, for messages
   * @throws InputException if the run has no such step or it was not recorded
   */
  public int indexOf(String option, long step) {
    if (step < 0 || step > last()) {
      throw InputException.of("%s is %s, expected a step from 0 to %s", option, step, last());
    }
    int index =
        (int) recording.frames().stream().skip(1).takeWhile(frame -> frame.step() <= step).count();
    if (step(index) != step) {
      throw InputException.of(
          "%s is %s, but the recording was thinned, expected a multiple of %s or %s;" + " maybe %s",
          option, step, recording.every(), last(), step(index));
    }
    return index;
  }

  /** The poses of all cameras in a frame. */
  List<CameraPose> poses(int index) {
    CameraPose[] poses =
        setup.cameras().stream().map(Setup.Camera::pose).toArray(CameraPose[]::new);
    for (Move move : recording.moves()) {
      if (move.step() <= step(index)) {
        poses[move.camera()] = move.pose();
      }
    }
    return List.of(poses);
  }

  /**
   * Returns the lists from which a picture is painted, by camera or target and by frame. They have
   * the frames of the trails that end at a frame, or all frames if tracks are shown.
   */
  Map<String, Object> columns(int index) {
    List<Frame> frames =
        look.tracks()
            ? recording.frames()
            : recording.frames().subList(Math.max(0, index - TRAIL_FRAMES), index + 1);
    Map<String, Object> columns = new HashMap<>();
    columns.put("step", frames.stream().mapToLong(Frame::step).toArray());
    columns.put("frame", look.tracks() ? index : frames.size() - 1);
    columns.put("mostTargets", Math.max(1, mostTargets));
    columns.put("online", lists(frames, Frame::online));
    columns.put("level", lists(frames, Frame::level));
    columns.put("seeing", lists(frames, Frame::seeing));
    columns.put("present", lists(frames, Frame::present));
    columns.put("coverage", lists(frames, Frame::coverage));
    columns.put("x", lists(frames, Frame::x));
    columns.put("y", lists(frames, Frame::y));
    return columns;
  }

  /** Transposes an array of each frame: returns an array by frame for each element. */
  private static Object[] lists(List<Frame> frames, Function<Frame, Object> arrayOf) {
    Object first = arrayOf.apply(frames.get(0));
    Object[] lists = new Object[Array.getLength(first)];
    for (int i = 0; i < lists.length; i++) {
      lists[i] = Array.newInstance(first.getClass().componentType(), frames.size());
      for (int frame = 0; frame < frames.size(); frame++) {
        System.arraycopy(arrayOf.apply(frames.get(frame)), i, lists[i], frame, 1);
      }
    }
    return lists;
  }
}
