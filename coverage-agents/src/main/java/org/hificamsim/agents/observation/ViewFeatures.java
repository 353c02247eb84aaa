package org.hificamsim.agents.observation;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/**
 * The numbers of an observation that do not depend on targets: a row for each view of a camera,
 * with the numbers of the camera itself and the positions of its neighbours, and 0 for all others.
 * Valid until the revision of the network changes.
 */
final class ViewFeatures {
  private static final int PAN = ObservationLayout.at("pan");
  private static final int BLIND = ObservationLayout.at("blind");

  /** The numbers of a view: pan, zoom and angle. */
  private static final int VIEW_NUMBERS = 3;

  private final int size;

  /** The index of the tilt of the view through which a camera sees; 0 without heights. */
  private final int tiltIndex;

  private final int[] firstRow;
  private final float[] rows;
  private final double[] perReach;
  private final double[] perAngle;

  /**
   * The index of the link's last number in the observations of all cameras, by link to a neighbour.
   */
  private final int[] copyTo;

  /** The index of the neighbour's own numbers, by link to a neighbour. */
  private final int[] copyFrom;

  ViewFeatures(NetworkView network, ViewRows source) {
    size = source.size();
    tiltIndex = source.tiltIndex();
    firstRow = new int[network.cameras() + 1];
    for (int camera = 0; camera < network.cameras(); camera++) {
      firstRow[camera + 1] = firstRow[camera] + network.views(camera);
    }
    copyTo = source.lastNumbersOfLinks(network);
    copyFrom = source.neighboursOfLinks(network);
    rows = new float[firstRow[network.cameras()] * size];
    perReach = new double[firstRow[network.cameras()]];
    perAngle = new double[perReach.length];
    float[] row = new float[size];
    for (int camera = 0; camera < network.cameras(); camera++) {
      source.fillCamera(network, camera, row);
      for (int view = 0; view < network.views(camera); view++) {
        int number = firstRow[camera] + view;
        source.fillView(network, camera, view, row);
        System.arraycopy(row, 0, rows, number * size, size);
        perReach[number] = 1 / network.reach(camera, view);
        perAngle[number] = 1 / network.zoom(camera, view).viewingAngle();
      }
    }
  }

  /**
   * Writes the numbers of a camera.
   *
   * @param goal the view that the camera chose last
   * @param seeing the view through which it sees, or -1 while it sees nothing
   */
  void write(int camera, int goal, int seeing, float[] out, int at) {
    System.arraycopy(rows, (firstRow[camera] + goal) * size, out, at, size);
    if (seeing < 0) {
      Arrays.fill(out, at + PAN, at + PAN + VIEW_NUMBERS, 0);
      out[at + BLIND] = 1;
    } else if (seeing != goal) {
      int from = (firstRow[camera] + seeing) * size;
      System.arraycopy(rows, from + PAN, out, at + PAN, VIEW_NUMBERS);
    }
    if (tiltIndex > 0) {
      out[at + tiltIndex] = seeing < 0 ? 0 : rows[(firstRow[camera] + seeing) * size + tiltIndex];
    }
  }

  /**
   * Copies a number of each camera to the observations of the cameras that have it as a neighbour,
   * as its last number there.
   *
   * @param out the observations of all cameras
   * @param index index of the number in the camera's observation
   */
  void copyToNeighbours(float[] out, int index) {
    for (int link = 0; link < copyTo.length; link++) {
      out[copyTo[link]] = out[copyFrom[link] + index];
    }
  }

  /** The inverse of the reach of a view, beyond which nothing is detected, per metre. */
  double perReach(int camera, int view) {
    return perReach[firstRow[camera] + view];
  }

  /** The inverse of the opening angle of a view, per radian. */
  double perAngle(int camera, int view) {
    return perAngle[firstRow[camera] + view];
  }

  /**
   * Whether a network has these numbers, too. Worlds that share one object keep it in the
   * processor's cache.
   */
  boolean areOf(NetworkView network, ViewRows source) {
    boolean same =
        size == source.size()
            && firstRow.length == network.cameras() + 1
            && Arrays.equals(copyTo, source.lastNumbersOfLinks(network))
            && Arrays.equals(copyFrom, source.neighboursOfLinks(network));
    float[] row = new float[size];
    for (int camera = 0; same && camera < network.cameras(); camera++) {
      same = firstRow[camera] + network.views(camera) == firstRow[camera + 1];
      source.fillCamera(network, camera, row);
      for (int view = 0; same && view < network.views(camera); view++) {
        int number = firstRow[camera] + view;
        source.fillView(network, camera, view, row);
        same =
            Arrays.equals(row, 0, size, rows, number * size, (number + 1) * size)
                && perReach[number] == 1 / network.reach(camera, view)
                && perAngle[number] == 1 / network.zoom(camera, view).viewingAngle();
      }
    }
    return same;
  }
}
