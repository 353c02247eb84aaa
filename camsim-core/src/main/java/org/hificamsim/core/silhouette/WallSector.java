package org.hificamsim.core.silhouette;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** The pieces of walls in a sector of the directions from a camera, the nearest first. */
final class WallSector {
  /**
   * A piece in a sector.
   *
   * @param nearest the least distance of its part in the sector, in metres
   */
  private record Part(int piece, double nearest) {}

  private final int[] pieces;
  private final double[] nearest;

  private WallSector(List<Part> parts) {
    pieces = parts.stream().mapToInt(Part::piece).toArray();
    nearest = parts.stream().mapToDouble(Part::nearest).toArray();
  }

  /** Collects the pieces of a sector; leaves out what is behind a wall that closes it. */
  static final class Builder {
    private final List<Part> parts = new ArrayList<>();
    private double closedBeyond = Double.POSITIVE_INFINITY;

    void add(int piece, double nearest) {
      parts.add(new Part(piece, nearest));
    }

    /** Notes that nothing beyond a distance, in metres, is seen in this sector. */
    void close(double distance) {
      closedBeyond = Math.min(closedBeyond, distance);
    }

    WallSector build() {
      return new WallSector(
          parts.stream()
              .filter(part -> part.nearest <= closedBeyond)
              .sorted(Comparator.comparingDouble(Part::nearest))
              .toList());
    }
  }

  int count() {
    return pieces.length;
  }

  int piece(int rank) {
    return pieces[rank];
  }

  /** The least distance of the piece's part in the sector, in metres; rounded down. */
  double nearest(int rank) {
    return nearest[rank];
  }
}
