package org.hificamsim.placement.site;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.Texts;
import org.hificamsim.runs.cells.FieldCells;

/**
 * A connected part of a zone that no camera covers.
 *
 * @param area square metres
 * @param x of its middle, metres
 * @param y of its middle, metres
 */
public record BlindSpot(String zone, double area, double x, double y) {
  /** All of a plan, the largest first. */
  static List<BlindSpot> of(Demand demand, int[] counts) {
    List<BlindSpot> spots = new ArrayList<>();
    for (Demand.Watched zone : demand.zones()) {
      FieldCells cells = demand.cells();
      Map<Integer, Demand.Sample> blind = new HashMap<>(); // by cell
      BitSet left = new BitSet();
      for (int s = zone.first(); s < zone.end(); s++) {
        Demand.Sample sample = demand.samples().get(s);
        if (counts[s] == 0) {
          blind.put(cells.at(sample.x(), sample.y()), sample);
          left.set(cells.at(sample.x(), sample.y()));
        }
      }
      while (!left.isEmpty()) {
        List<Demand.Sample> part = part(left, cells.columns()).stream().map(blind::get).toList();
        spots.add(
            new BlindSpot(
                zone.name(),
                part.size() * cells.width() * cells.height(),
                part.stream().mapToDouble(Demand.Sample::x).average().orElseThrow(),
                part.stream().mapToDouble(Demand.Sample::y).average().orElseThrow()));
      }
    }
    spots.sort(Comparator.comparingDouble(spot -> -spot.area));
    return List.copyOf(spots);
  }

  /** Takes the first cell, and all that are connected with it, away. */
  private static List<Integer> part(BitSet left, int columns) {
    List<Integer> part = new ArrayList<>();
    Deque<Integer> waiting = new ArrayDeque<>(List.of(left.nextSetBit(0)));
    left.clear(waiting.peek());
    while (!waiting.isEmpty()) {
      int cell = waiting.pop();
      part.add(cell);
      int column = cell % columns;
      int[] next = {
        column > 0 ? cell - 1 : -1,
        column < columns - 1 ? cell + 1 : -1,
        cell - columns,
        cell + columns
      };
      for (int one : next) {
        if (one >= 0 && left.get(one)) {
          left.clear(one);
          waiting.push(one);
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
