package org.hificamsim.agents.observation;

import java.util.Arrays;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.hificamsim.agents.voting.NearestCameras;
import org.hificamsim.core.detection.VerticalView;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.policy.NetworkView;

/**
 * Makes the rows of {@link ViewFeatures} for a network, one view after the other, and finds the
 * neighbours whose numbers its cameras observe.
 */
final class ViewRows {
  private static final int GOAL_PAN = ObservationLayout.at("goal_pan");
  private static final int PAN = ObservationLayout.at("pan");

  /** The height that counts as 1, in metres. */
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

  private final ObservationLayout layout;
  private final Standpoints standpoints;
  private final NearestCameras nearest;

  ViewRows(NetworkView network, ObservationLayout layout) {
    this.layout = layout;
    standpoints = new Standpoints(network);
    nearest = new NearestCameras(network, layout.neighbours());
  }

  /** Finds the neighbours again if cameras were added, moved or switched. */
  void update(NetworkView network) {
    nearest.update(network);
  }

  /** The number of numbers of a row. */
  int size() {
    return layout.size();
  }

  /** The index of the tilt of the view through which a camera sees; 0 without heights. */
  int tiltIndex() {
    return layout.heights() ? layout.ownSize() - 1 : 0;
  }

  /** Fills a row with the numbers that all views of a camera have. */
  void fillCamera(NetworkView network, int camera, float[] row) {
    Arrays.fill(row, 0);
    row[0] = 1;
    row[1] = standpoints.x(network.cameraX(camera));
    row[2] = standpoints.y(network.cameraY(camera));
    row[3] = Bounds.signed(Math.sin(network.cameraHeading(camera)));
    row[4] = Bounds.signed(Math.cos(network.cameraHeading(camera)));
    int at = layout.ownSize();
    for (int i = 0; i < nearest.count(camera); i++) {
      int neighbour = nearest.neighbour(camera, i);
      row[at] = standpoints.difference(network.cameraX(neighbour) - network.cameraX(camera));
      row[at + 1] = standpoints.difference(network.cameraY(neighbour) - network.cameraY(camera));
      at += ObservationLayout.NEIGHBOUR.size();
    }
  }

  /** Fills the numbers of a view into a row of its camera. */
  void fillView(NetworkView network, int camera, int view, float[] row) {
    int zooms = network.zooms(camera);
    ZoomLevel zoom = network.zoom(camera, view);
    row[PAN] = Bounds.signed(network.pan(camera, view) / Math.PI);
    row[PAN + 1] = zooms == 1 ? 1 : Bounds.share(network.zoomOf(camera, view) / (zooms - 1.0));
    row[PAN + 2] = Bounds.share(zoom.viewingAngle() / (2 * Math.PI));
    System.arraycopy(row, PAN, row, GOAL_PAN, 2);
    int tilt = tiltIndex();
    if (tilt > 0) {
      VerticalView vertical = zoom.vertical();
      row[tilt - 2] = Bounds.share(vertical.z() / HEIGHT_SCALE);
      row[tilt - 1] = Bounds.signed(vertical.tilt() / (Math.PI / 2));
      row[tilt] = row[tilt - 1];
    }
  }

  /**
   * Returns for each link to a neighbour the index of its last number in the observations of all
   * cameras.
   */
  int[] lastNumbersOfLinks(NetworkView network) {
    int length = ObservationLayout.NEIGHBOUR.size();
    return cameras(network)
        .flatMap(
            camera ->
                IntStream.rangeClosed(1, nearest.count(camera))
                    .map(i -> camera * size() + layout.ownSize() + i * length - 1))
        .toArray();
  }

  /** Returns for each link to a neighbour the index of the neighbour's own numbers. */
  int[] neighboursOfLinks(NetworkView network) {
    return cameras(network)
        .flatMap(
            camera ->
                IntStream.range(0, nearest.count(camera))
                    .map(i -> nearest.neighbour(camera, i) * size()))
        .toArray();
  }

  private static IntStream cameras(NetworkView network) {
    return IntStream.range(0, network.cameras());
  }
}
