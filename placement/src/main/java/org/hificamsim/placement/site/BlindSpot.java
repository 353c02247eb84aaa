package org.hificamsim.placement.site;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import org.hificamsim.core.Texts;
import org.hificamsim.placement.site.Demand.DemandPoint;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.runs.cells.FieldCells;

/**
 * A connected part of a zone that no camera covers.
 *
 * @param area square metres
 * @param x of its centre, metres
 * @param y of its centre, metres
 */
public record BlindSpot(String zone, double area, double x, double y) {
  /** Returns all blind spots, the largest first. */
  static List<BlindSpot> of(Demand demand, int[] counts) {
    List<BlindSpot> spots = new ArrayList<>();
    for (ZoneDemand zone : demand.zones()) {
      addSpots(demand, counts, zone, spots);
    }
    spots.sort(Comparator.comparingDouble(spot -> -spot.area));
    return List.copyOf(spots);
  }

  private static void addSpots(
      Demand demand, int[] counts, ZoneDemand zone, List<BlindSpot> spots) {
    FieldCells cells = demand.cells(zone);
    int[] pointsByCell = demand.pointsByCell(zone, cells);
    BitSet blindCells = new BitSet();
    for (int cell = 0; cell < pointsByCell.length; cell++) {
      blindCells.set(cell, pointsByCell[cell] >= 0 && counts[pointsByCell[cell]] == 0);
    }
    while (!blindCells.isEmpty()) {
      List<DemandPoint> points =
          removeFirstPart(blindCells, cells.columns()).stream()
              .map(cell -> demand.points().get(pointsByCell[cell]))
              .toList();
      spots.add(
          new BlindSpot(
              zone.name(),
              points.size() * cells.width() * cells.height(),
              points.stream().mapToDouble(DemandPoint::x).average().orElseThrow(),
              points.stream().mapToDouble(DemandPoint::y).average().orElseThrow()));
    }
  }

  /** Removes the first cell and all that are connected with it, and returns them. */
  private static List<Integer> removeFirstPart(BitSet cells, int columns) {
    List<Integer> part = new ArrayList<>();
    Deque<Integer> waiting = new ArrayDeque<>(List.of(cells.nextSetBit(0)));
    cells.clear(waiting.peek());
    while (!waiting.isEmpty()) {
      int cell = waiting.pop();
      part.add(cell);
      int column = cell % columns;
      int[] neighbours = {
        column > 0 ? cell - 1 : -1,
        column < columns - 1 ? cell + 1 : -1,
        cell - columns,
        cell + columns
      };
      for (int neighbour : neighbours) {
        if (neighbour >= 0 && cells.get(neighbour)) {
          cells.clear(neighbour);
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
