package org.hificamsim.agents.observation;

import java.util.Arrays;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.hificamsim.agents.voting.NearestCameras;
import org.hificamsim.core.detection.VerticalView;
import org.hificamsim.core.policy.NetworkView;

/**
 * The numbers of an observation that do not depend on targets: a row for each view of a camera,
 * with the numbers of the camera itself and the positions of its neighbours, and 0 for all others.
 * Valid until the revision of the network changes.
 */
final class ViewFeatures {
  private static final int GOAL_PAN = ObservationLayout.at("goal_pan");
  private static final int PAN = ObservationLayout.at("pan");
  private static final int BLIND = ObservationLayout.at("blind");

  /** The numbers of a view: pan, zoom and angle. */
  private static final int VIEW_NUMBERS = 3;

  /** The height that counts as 1, metres. */
  private static final double HEIGHT_SCALE = 10;

  /**
   * A scale for the positions of cameras: the centre of those that are online at the beginning is
   * at 0, and the outermost of them, in x or y, is at 1 or -1.
   */
  static final class Standpoints {
    private final double middleX;
    private final double middleY;
    private final double halfExtent;

    Standpoints(NetworkView network) {
      double left = least(network, network::cameraX);
      double right = -least(network, camera -> -network.cameraX(camera));
      double bottom = least(network, network::cameraY);
      double top = -least(network, camera -> -network.cameraY(camera));
      middleX = (left + right) / 2;
      middleY = (bottom + top) / 2;
      halfExtent = Math.max(Math.max(right - left, top - bottom) / 2, Double.MIN_NORMAL);
    }

    private static double least(NetworkView network, IntToDoubleFunction coordinate) {
      return IntStream.range(0, network.cameras())
          .filter(network::online)
          .mapToDouble(coordinate)
          .min()
          .orElse(0);
    }

    /** Returns an x coordinate on the scale. */
    float x(double metres) {
      return Bounds.signed((metres - middleX) / halfExtent);
    }

    /** Returns a y coordinate on the scale. */
    float y(double metres) {
      return Bounds.signed((metres - middleY) / halfExtent);
    }

    /** Returns a difference in x or y on half the scale, so that it is 1 between the outermost. */
    float difference(double metres) {
      return Bounds.signed(metres / halfExtent / 2);
    }
  }

  private final int size;

  /** The index of the tilt of the view through which a camera sees; 0 without heights. */
  private final int tiltIndex;

  private final int[] firstRow;
  private final float[] rows;
  private final double[] perReach;
  private final double[] perAngle;

  /** By link to a neighbour, the index of its last number in the observations of all cameras. */
  private final int[] copyTo;

  /** By link to a neighbour, the index of the neighbour's own numbers. */
  private final int[] copyFrom;

  ViewFeatures(
      NetworkView network,
      ObservationLayout layout,
      Standpoints standpoints,
      NearestCameras nearest) {
    size = layout.size();
    tiltIndex = layout.heights() ? layout.ownSize() - 1 : 0;
    firstRow = new int[network.cameras() + 1];
    int links = 0;
    for (int camera = 0; camera < network.cameras(); camera++) {
      firstRow[camera + 1] = firstRow[camera] + network.views(camera);
      links += nearest.count(camera);
    }
    copyTo = new int[links];
    copyFrom = new int[links];
    link(network, layout, nearest);
    rows = new float[firstRow[network.cameras()] * size];
    perReach = new double[firstRow[network.cameras()]];
    perAngle = new double[perReach.length];
    for (int camera = 0; camera < network.cameras(); camera++) {
      for (int view = 0; view < network.views(camera); view++) {
        fill(network, standpoints, camera, view);
        int row = (firstRow[camera] + view) * size;
        fillNeighbours(network, standpoints, nearest, camera, row + layout.ownSize());
      }
    }
  }

  private void link(NetworkView network, ObservationLayout layout, NearestCameras nearest) {
    int link = 0;
    for (int camera = 0; camera < network.cameras(); camera++) {
      for (int i = 0; i < nearest.count(camera); i++) {
        int last = layout.ownSize() + (i + 1) * ObservationLayout.NEIGHBOUR.size() - 1;
        copyTo[link] = camera * size + last;
        copyFrom[link] = nearest.neighbour(camera, i) * size;
        link++;
      }
    }
  }

  private void fill(NetworkView network, Standpoints standpoints, int camera, int view) {
    int row = firstRow[camera] + view;
    double angle = network.zoom(camera, view).viewingAngle();
    perReach[row] = 1 / network.reach(camera, view);
    perAngle[row] = 1 / angle;
    int zooms = network.zooms(camera);
    int at = row * size;
    rows[at] = 1;
    rows[at + 1] = standpoints.x(network.cameraX(camera));
    rows[at + 2] = standpoints.y(network.cameraY(camera));
    rows[at + 3] = Bounds.signed(Math.sin(network.cameraHeading(camera)));
    rows[at + 4] = Bounds.signed(Math.cos(network.cameraHeading(camera)));
    rows[at + PAN] = Bounds.signed(network.pan(camera, view) / Math.PI);
    rows[at + PAN + 1] =
        zooms == 1 ? 1 : Bounds.share(network.zoomOf(camera, view) / (zooms - 1.0));
    rows[at + PAN + 2] = Bounds.share(angle / (2 * Math.PI));
    System.arraycopy(rows, at + PAN, rows, at + GOAL_PAN, 2);
    if (tiltIndex > 0) {
      VerticalView vertical = network.zoom(camera, view).vertical();
      rows[at + tiltIndex - 2] = Bounds.share(vertical.z() / HEIGHT_SCALE);
      rows[at + tiltIndex - 1] = Bounds.signed(vertical.tilt() / (Math.PI / 2));
      rows[at + tiltIndex] = rows[at + tiltIndex - 1];
    }
  }

  private void fillNeighbours(
      NetworkView network, Standpoints standpoints, NearestCameras nearest, int camera, int first) {
    int at = first;
    for (int i = 0; i < nearest.count(camera); i++) {
      int neighbour = nearest.neighbour(camera, i);
      rows[at] = standpoints.difference(network.cameraX(neighbour) - network.cameraX(camera));
      rows[at + 1] = standpoints.difference(network.cameraY(neighbour) - network.cameraY(camera));
      at += ObservationLayout.NEIGHBOUR.size();
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
   * Returns the other object if its numbers are equal, else this one. Many worlds that share one
   * object keep it in the processor's cache.
   */
  ViewFeatures sharedWith(ViewFeatures others) {
    return equalsNumbers(others) ? others : this;
  }

  private boolean equalsNumbers(ViewFeatures others) {
    return size == others.size
        && Arrays.equals(firstRow, others.firstRow)
        && Arrays.equals(rows, others.rows)
        && Arrays.equals(perReach, others.perReach)
        && Arrays.equals(perAngle, others.perAngle)
        && Arrays.equals(copyTo, others.copyTo)
        && Arrays.equals(copyFrom, others.copyFrom);
  }
}
