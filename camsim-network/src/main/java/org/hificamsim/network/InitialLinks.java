package org.hificamsim.network;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.scenario.spec.VisionGraph;

/** The links that a scenario's vision graph gives cameras to start with (behaviour 3.6). */
final class InitialLinks {
  private final Map<String, Integer> numbers = new LinkedHashMap<>();
  private final Map<String, List<String>> neighbours;

  /**
   * Links between names.
   *
   * @param cameras all names of cameras, in their order
   */
  InitialLinks(List<String> cameras, Optional<VisionGraph> graph) {
    cameras.forEach(this::number);
    neighbours = graph.map(VisionGraph::neighbours).orElse(Map.of());
    neighbours.values().forEach(names -> names.forEach(this::number));
    neighbours.keySet().forEach(this::number);
  }

  /** The number of names: cameras, then names in the graph alone. */
  int names() {
    return numbers.size();
  }

  /**
   * The names that a camera is linked to.
   *
   * @param reverse whether the cameras that list this one count too
   */
  List<Integer> of(String camera, boolean reverse) {
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
