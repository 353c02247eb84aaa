package org.hificamsim.agents.observation;

import java.util.Arrays;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.hificamsim.agents.voting.NearestCameras;
import org.hificamsim.core.detection.VerticalView;
import org.hificamsim.core.policy.NetworkView;

/**
 * What an observation has of a camera in each of its views wherever targets are: a row for each,
 * with the numbers of the camera itself, where its neighbours stand, and 0 for all else. Good until
 * the network's revision changes.
 */
final class ViewFeatures {
  private static final int GOAL = ObservationLayout.at("goal_pan");
  private static final int SEEING = ObservationLayout.at("pan");
  private static final int BLIND = ObservationLayout.at("blind");
  private static final int OF_A_VIEW = 3; // pan, zoom and angle
  private static final double HIGH = 10; // metres

  /**
   * A scale for where cameras stand: the middle of those that are online at first is 0, and the
   * outermost of them, in x or y, is at 1 or -1.
   */
  static final class Standpoints {
    private final double middleX;
    private final double middleY;
    private final double half;

    Standpoints(NetworkView network) {
      double left = least(network, network::cameraX);
      double right = -least(network, camera -> -network.cameraX(camera));
      double bottom = least(network, network::cameraY);
      double top = -least(network, camera -> -network.cameraY(camera));
      middleX = (left + right) / 2;
      middleY = (bottom + top) / 2;
      half = Math.max(Math.max(right - left, top - bottom) / 2, Double.MIN_NORMAL);
    }

    private static double least(NetworkView network, IntToDoubleFunction of) {
      return IntStream.range(0, network.cameras())
          .filter(network::online)
          .mapToDouble(of)
          .min()
          .orElse(0);
    }

    float x(double metres) {
      return Bounds.signed((metres - middleX) / half);
    }

    float y(double metres) {
      return Bounds.signed((metres - middleY) / half);
    }

    /** A distance in x or y: half the scale, so that the outermost are at 1 from each other. */
    float between(double metres) {
      return Bounds.signed(metres / half / 2);
    }
  }

  private final int size;
  private final int tilt; // where that of the view is that a camera sees through; 0: nowhere
  private final int[] firstRow;
  private final float[] rows;
  private final double[] perReach;
  private final double[] perAngle;
  private final int[] copyTo; // where each neighbour's last number is, in the observations of all
  private final int[] copyFrom; // where that neighbour's own numbers begin

  ViewFeatures(
      NetworkView network,
      ObservationLayout layout,
      Standpoints standpoints,
      NearestCameras nearest) {
    size = layout.size();
    tilt = layout.heights() ? layout.ownSize() - 1 : 0;
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
    rows[at + SEEING] = Bounds.signed(network.pan(camera, view) / Math.PI);
    rows[at + SEEING + 1] =
        zooms == 1 ? 1 : Bounds.share(network.zoomOf(camera, view) / (zooms - 1.0));
    rows[at + SEEING + 2] = Bounds.share(angle / (2 * Math.PI));
    System.arraycopy(rows, at + SEEING, rows, at + GOAL, 2);
    if (tilt > 0) {
      VerticalView vertical = network.zoom(camera, view).vertical();
      rows[at + tilt - 2] = Bounds.share(vertical.z() / HIGH);
      rows[at + tilt - 1] = Bounds.signed(vertical.tilt() / (Math.PI / 2));
      rows[at + tilt] = rows[at + tilt - 1];
    }
  }

  private void fillNeighbours(
      NetworkView network, Standpoints standpoints, NearestCameras nearest, int camera, int first) {
    int at = first;
    for (int i = 0; i < nearest.count(camera); i++) {
      int other = nearest.neighbour(camera, i);
      rows[at] = standpoints.between(network.cameraX(other) - network.cameraX(camera));
      rows[at + 1] = standpoints.between(network.cameraY(other) - network.cameraY(camera));
      at += ObservationLayout.NEIGHBOUR.size();
    }
  }

  /**
   * Writes them.
   *
   * @param goal the view that the camera chose last
   * @param seeing the view that it sees through, -1 while it sees nothing
   */
  void write(int camera, int goal, int seeing, float[] out, int at) {
    System.arraycopy(rows, (firstRow[camera] + goal) * size, out, at, size);
    if (seeing < 0) {
      Arrays.fill(out, at + SEEING, at + SEEING + OF_A_VIEW, 0);
      out[at + BLIND] = 1;
    } else if (seeing != goal) {
      int from = (firstRow[camera] + seeing) * size;
      System.arraycopy(rows, from + SEEING, out, at + SEEING, OF_A_VIEW);
    }
    if (tilt > 0) {
      out[at + tilt] = seeing < 0 ? 0 : rows[(firstRow[camera] + seeing) * size + tilt];
    }
  }

  /**
   * Copies a number of each camera to the last one that others have of it as their neighbour.
   *
   * @param out the observations of all cameras
   * @param which of the camera's own numbers
   */
  void copyToNeighbours(float[] out, int which) {
    for (int link = 0; link < copyTo.length; link++) {
      out[copyTo[link]] = out[copyFrom[link] + which];
    }
  }

  /** One by the distance beyond which the camera detects nothing in a view, per metre. */
  double perReach(int camera, int view) {
    return perReach[firstRow[camera] + view];
  }

  /** One by the opening angle of a view, per radian. */
  double perAngle(int camera, int view) {
    return perAngle[firstRow[camera] + view];
  }

  /** Others, if they are the same numbers: kept once for many worlds, they stay near. */
  ViewFeatures or(ViewFeatures others) {
    return isLike(others) ? others : this;
  }

  private boolean isLike(ViewFeatures others) {
    return size == others.size
        && Arrays.equals(firstRow, others.firstRow)
        && Arrays.equals(rows, others.rows)
        && Arrays.equals(perReach, others.perReach)
        && Arrays.equals(perAngle, others.perAngle)
        && Arrays.equals(copyTo, others.copyTo)
        && Arrays.equals(copyFrom, others.copyFrom);
  }
}
