package org.hificamsim.placement.site;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.Texts;
import org.hificamsim.runs.cells.FieldCells;

/**
 * A connected part of a zone that is not seen as the zone demands. All blind spots of a zone are
 * together the share that is not met.
 *
 * @param area square metres; where some of several cameras see, a part of the area counts
 * @param x the x coordinate of its centre, in metres
 * @param y the y coordinate of its centre, in metres
 */
public record BlindSpot(String zone, double area, double x, double y) {
  private static final double LEAST_SHOWN_AREA = 0.05; // square metres

  /**
   * Returns all blind spots of a zone, the largest first.
   *
   * @param missing for each cell, the part of the demand that is not met, in [0, 1]
   */
  static List<BlindSpot> of(String zone, FieldCells cells, double[] missing) {
    BitSet blindCells = new BitSet();
    for (int cell = 0; cell < missing.length; cell++) {
      blindCells.set(cell, missing[cell] > 0);
    }
    List<BlindSpot> spots = new ArrayList<>();
    while (!blindCells.isEmpty()) {
      spots.add(spot(zone, cells, missing, removeFirstPart(blindCells, cells)));
    }
    return largestFirst(spots.stream());
  }

  /**
   * The blind spots that a text names, and the sum of the others.
   *
   * @param shown the largest spots, in their order; none whose area is 0.0 as it is shown
   * @param others the number of all other spots
   * @param otherArea the area of all other spots, in square metres
   */
  public record Listing(List<BlindSpot> shown, int others, double otherArea) {
    /**
     * Lists spots.
     *
     * @param spots the spots, the largest first
     * @param most the greatest number of spots to show
     */
    public static Listing of(List<BlindSpot> spots, int most) {
      List<BlindSpot> shown =
          spots.stream().filter(spot -> spot.area >= LEAST_SHOWN_AREA).limit(most).toList();
      List<BlindSpot> others = spots.subList(shown.size(), spots.size());
      return new Listing(shown, others.size(), others.stream().mapToDouble(BlindSpot::area).sum());
    }
  }

  static List<BlindSpot> largestFirst(Stream<BlindSpot> spots) {
    return spots.sorted(Comparator.comparingDouble(spot -> -spot.area)).toList();
  }

  private static BlindSpot spot(
      String zone, FieldCells cells, double[] missing, List<Integer> part) {
    return new BlindSpot(
        zone,
        part.stream().mapToDouble(cell -> missing[cell]).sum() * cells.width() * cells.height(),
        part.stream().mapToDouble(cells::x).average().orElseThrow(),
        part.stream().mapToDouble(cells::y).average().orElseThrow());
  }

  /** Removes the first cell and all that touch it, also at a corner, and returns them. */
  private static List<Integer> removeFirstPart(BitSet blindCells, FieldCells cells) {
    List<Integer> part = new ArrayList<>();
    Deque<Integer> waiting = new ArrayDeque<>(List.of(blindCells.nextSetBit(0)));
    blindCells.clear(waiting.peek());
    while (!waiting.isEmpty()) {
      int cell = waiting.pop();
      part.add(cell);
      for (int side = 0; side < 9; side++) {
        int column = cell % cells.columns() + side % 3 - 1;
        int neighbour = cell + (side / 3 - 1) * cells.columns() + side % 3 - 1;
        boolean isInRow = column >= 0 && column < cells.columns();
        if (isInRow && neighbour >= 0 && blindCells.get(neighbour)) {
          blindCells.clear(neighbour);
          waiting.push(neighbour);
        }
      }
    }
    return part;
  }

  @Override
  public String toString() {
    return Texts.format("%s: %.1f m2 around (%.1f, %.1f)", zone, area, x, y);
  }
}
