package org.hificamsim.network;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.scenario.spec.VisionGraph;

/** The links that the vision graph of a scenario gives cameras at the start (behaviour 3.6). */
final class InitialLinks {
  private final Map<String, Integer> numbers = new LinkedHashMap<>();
  private final Map<String, List<String>> neighbours;

  /**
   * Numbers the cameras, then the other names of the graph.
   *
   * @param cameras the names of all cameras, in order
   * @param graph the vision graph; empty for no links
   */
  InitialLinks(List<String> cameras, Optional<VisionGraph> graph) {
    cameras.forEach(this::number);
    neighbours = graph.map(VisionGraph::neighbours).orElse(Map.of());
    neighbours.values().forEach(names -> names.forEach(this::number));
    neighbours.keySet().forEach(this::number);
  }

  /** The number of names: cameras, then names that only the graph has. */
  int names() {
    return numbers.size();
  }

  /**
   * Returns the numbers of the names that a camera is linked to.
   *
   * @param reverse whether to include the cameras that list this one
   */
  List<Integer> links(String camera, boolean reverse) {
    List<Integer> links = new ArrayList<>();
    neighbours.getOrDefault(camera, List.of()).forEach(name -> links.add(numbers.get(name)));
    if (reverse) {
      neighbours.forEach(
          (node, names) -> {
            if (names.contains(camera)) {
              links.add(numbers.get(node));
            }
          });
    }
    return links;
  }

  private void number(String name) {
    numbers.putIfAbsent(name, numbers.size());
  }
}
