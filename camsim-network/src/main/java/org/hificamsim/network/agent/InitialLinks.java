package org.hificamsim.network.agent;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.scenario.VisionGraph;

/** The links that a scenario's vision graph gives cameras to start with (behaviour 3.6). */
public final class InitialLinks {
  private final Map<String, Integer> numbers = new LinkedHashMap<>();
  private final Map<String, List<String>> neighbours;

  /**
   * @param cameras all names of cameras, in their order
   */
  public InitialLinks(List<String> cameras, Optional<VisionGraph> graph) {
    cameras.forEach(this::number);
    neighbours = graph.map(VisionGraph::neighbours).orElse(Map.of());
    neighbours.values().forEach(names -> names.forEach(this::number));
    neighbours.keySet().forEach(this::number);
  }

  /** How many names there are: cameras, then names in the graph alone. */
  public int names() {
    return numbers.size();
  }

  /**
   * The names that a camera is linked to.
   *
   * @param reverse whether the cameras that list this one count too
   */
  public List<Integer> of(String camera, boolean reverse) {
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
