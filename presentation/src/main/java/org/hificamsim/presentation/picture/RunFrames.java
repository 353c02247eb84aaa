package org.hificamsim.presentation.picture;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.presentation.replay.CameraPose;
import org.hificamsim.presentation.replay.CameraSetup;
import org.hificamsim.presentation.replay.FloorPictures;
import org.hificamsim.presentation.replay.Frame;
import org.hificamsim.presentation.replay.Move;
import org.hificamsim.presentation.replay.Recording;
import org.hificamsim.presentation.replay.Setup;

/** A recorded run by frames, ready to be painted. */
public final class RunFrames {
  private final Setup setup;
  private final Recording recording;
  private final Look look;
  private final double[] prominence;
  private final List<BufferedImage> floor;
  private final long[] steps;
  private final int[] kMin;

  public RunFrames(Setup setup, Recording recording) {
    this(setup, recording, Look.USUAL);
  }

  public RunFrames(Setup setup, Recording recording, Look look) {
    this.setup = setup;
    this.look = look;
    this.prominence = prominence(setup);
    this.floor = setup.floor().stream().map(FloorPictures::image).toList();
    this.recording = recording;
    this.steps = recording.frames().stream().mapToLong(Frame::step).toArray();
    this.kMin = recording.frames().stream().mapToInt(frame -> frame.measure().kMin()).toArray();
  }

  Setup setup() {
    return setup;
  }

  /** What the run was in, metres. */
  public Field field() {
    return setup.field();
  }

  private static double[] prominence(Setup setup) {
    double[] widths =
        IntStream.range(0, setup.targets().size()).mapToDouble(setup::width).toArray();
    boolean alike = Arrays.stream(widths).distinct().count() < 2;
    return Arrays.stream(widths)
        .map(width -> alike ? 1 : Math.max(0.6, Math.min(2, width / setup.targetSize())))
        .toArray();
  }

  /**
   * How large a target is drawn where its own size would be too small: its width over the usual
   * size, in [0.6, 2]; 1 where all are alike.
   */
  double prominence(int target) {
    return prominence[target];
  }

  Look look() {
    return look;
  }

  /** The pictures under the field. */
  List<BufferedImage> floor() {
    return floor;
  }

  Recording recording() {
    return recording;
  }

  Frame frame(int index) {
    return recording.frames().get(index);
  }

  /** How many frames there are, 1 or more. */
  public int count() {
    return kMin.length;
  }

  /** The step of a frame. */
  public long step(int index) {
    return steps[index];
  }

  /** How many steps lie between two frames. */
  public long stepsApart() {
    return recording.every();
  }

  /** The last step. */
  public long last() {
    return recording.steps() - 1;
  }

  int kMin(int index) {
    return kMin[index];
  }

  /**
   * The frame of a step.
   *
   * @param option that gave the step, for error lines
   * @throws InputException when the run has no such step or it was not recorded
   */
  public int at(String option, long step) {
    if (step < 0 || step > last()) {
      throw new InputException(
          "%s is %s, expected a step from 0 to %s".formatted(option, step, last()));
    }
    int index = before(step);
    if (step(index) != step) {
      throw new InputException(
          "%s is %s, but the recording was thinned, expected a multiple of %s or %s; maybe %s"
              .formatted(option, step, recording.every(), last(), step(index)));
    }
    return index;
  }

  /** The frame of a step, or the last one before it. */
  private int before(long step) {
    int found = Arrays.binarySearch(steps, step);
    return Math.max(0, found < 0 ? -found - 2 : found);
  }

  /** Where every camera is in a frame. */
  List<CameraPose> poses(int index) {
    CameraPose[] poses = setup.cameras().stream().map(CameraSetup::pose).toArray(CameraPose[]::new);
    for (Move move : recording.moves()) {
      if (move.step() <= step(index)) {
        poses[move.camera()] = move.pose();
      }
    }
    return List.of(poses);
  }
}
