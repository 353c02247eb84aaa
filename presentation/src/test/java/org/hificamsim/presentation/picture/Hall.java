package org.hificamsim.presentation.picture;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.presentation.replay.Frame;
import org.hificamsim.presentation.replay.Setup;

/** A hall of 30 by 20 metres for tests of pictures. */
final class Hall {
  static final Field FIELD = new Field(0, 30, 0, 20);

  private Hall() {}

  /**
   * Returns a setup of cameras and targets in the hall.
   *
   * @param slow the numbers of cameras that need time to turn
   */
  static Setup setup(
      List<Setup.Camera> cameras,
      List<Setup.Target> targets,
      List<Double> widths,
      List<Integer> slow,
      List<Obstacle> obstacles,
      List<Setup.Floor> floor) {
    return new Setup(
        "hall",
        FIELD,
        "coverage",
        "model",
        0.5,
        "policy",
        0,
        0.5,
        false,
        cameras,
        targets,
        widths,
        slow,
        obstacles,
        floor,
        List.of(),
        false);
  }

  /**
   * Returns a frame of the hall.
   *
   * @param seeing for each camera, the view that it has, -1 while it turns
   * @param present whether the targets are there
   */
  static Frame frame(int step, int[] seeing, boolean present, double[] x, double[] y) {
    boolean[] online = new boolean[seeing.length];
    int[] level = new int[seeing.length];
    for (int camera = 0; camera < seeing.length; camera++) {
      online[camera] = true;
      level[camera] = Math.max(0, seeing[camera]);
    }
    boolean[] targetsPresent = new boolean[x.length];
    Arrays.fill(targetsPresent, present);
    return new Frame(
        step,
        online,
        level,
        new int[seeing.length],
        targetsPresent,
        x,
        y,
        new int[x.length],
        new double[0][],
        new double[0][],
        seeing,
        new double[0],
        new int[0]);
  }
}
