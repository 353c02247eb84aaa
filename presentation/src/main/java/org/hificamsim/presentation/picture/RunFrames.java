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

/** A recorded run by frames, ready to be painted. For one thread at a time. */
public final class RunFrames {
  private static final int TRAIL = 40; // frames, as in scene.js

  private final Setup setup;
  private final RecordedRun recording;
  private final Look look;
  private final FieldScript script;
  private final BufferedImage[] floor;
  private final Optional<FrameScores> scores;
  private final double[] course;
  private final int most;

  public RunFrames(Setup setup, RecordedRun recording) {
    this(setup, recording, Look.USUAL, Optional.empty());
  }

  public RunFrames(Setup setup, RecordedRun recording, Look look, Optional<FrameScores> scores) {
    this.setup = setup;
    this.look = look;
    this.script = new FieldScript(setup);
    this.floor = setup.floor().stream().map(FloorPictures::image).toArray(BufferedImage[]::new);
    this.recording = recording;
    List<StepCoverage> measured = recording.frames().stream().map(Frame::measure).toList();
    this.scores = scores;
    this.course =
        scores
            .map(of -> recording.frames().stream().mapToDouble(f -> of.byStep().get(f.step())))
            .orElseGet(() -> measured.stream().mapToDouble(StepCoverage::kMin))
            .toArray();
    this.most = measured.stream().mapToInt(StepCoverage::targets).max().orElse(1);
  }

  Setup setup() {
    return setup;
  }

  /** What the run was in, metres. */
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

  /** How many frames there are, 1 or more. */
  public int count() {
    return course.length;
  }

  /** The step of a frame. */
  public long step(int index) {
    return frame(index).step();
  }

  /** How many steps lie between two frames. */
  public long stepsApart() {
    return recording.every();
  }

  /** The last step. */
  public long last() {
    return recording.steps() - 1;
  }

  /** The score of a frame, or its k_min where that is the objective. */
  double course(int index) {
    return course[index];
  }

  Optional<FrameScores> scores() {
    return scores;
  }

  /**
   * The frame of a step.
   *
   * @param option that gave the step, for error lines
   * @throws InputException when the run has no such step or it was not recorded
   */
  public int at(String option, long step) {
    if (step < 0 || step > last()) {
      throw InputException.of("%s is %s, expected a step from 0 to %s", option, step, last());
    }
    int index = (int) recording.frames().stream().skip(1).takeWhile(f -> f.step() <= step).count();
    if (step(index) != step) {
      throw InputException.of(
          "%s is %s, but the recording was thinned, expected a multiple of %s or %s;" + " maybe %s",
          option, step, recording.every(), last(), step(index));
    }
    return index;
  }

  /** Where every camera is in a frame. */
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
   * The lists of a run that its picture is painted of, by camera or target and by frame: those up
   * to a frame that leave a trail, or all where tracks are shown.
   */
  Map<String, Object> columns(int index) {
    List<Frame> frames =
        look.tracks()
            ? recording.frames()
            : recording.frames().subList(Math.max(0, index - TRAIL), index + 1);
    Map<String, Object> columns = new HashMap<>();
    columns.put("step", frames.stream().mapToLong(Frame::step).toArray());
    columns.put("frame", look.tracks() ? index : frames.size() - 1);
    columns.put("mostTargets", Math.max(1, most));
    columns.put("online", lists(frames, Frame::online));
    columns.put("level", lists(frames, Frame::level));
    columns.put("seeing", lists(frames, Frame::seeing));
    columns.put("present", lists(frames, Frame::present));
    columns.put("coverage", lists(frames, Frame::coverage));
    columns.put("x", lists(frames, Frame::x));
    columns.put("y", lists(frames, Frame::y));
    return columns;
  }

  /** An array of each frame as an array by frame of each of its elements. */
  private static Object[] lists(List<Frame> frames, Function<Frame, Object> part) {
    Object first = part.apply(frames.get(0));
    Object[] lists = new Object[Array.getLength(first)];
    for (int i = 0; i < lists.length; i++) {
      lists[i] = Array.newInstance(first.getClass().componentType(), frames.size());
      for (int frame = 0; frame < frames.size(); frame++) {
        System.arraycopy(part.apply(frames.get(frame)), i, lists[i], frame, 1);
      }
    }
    return lists;
  }
}
