package org.hificamsim.reproduction;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** A camera layout of Table 7.1 with its two scenarios. */
public enum Layout {
  LATTICE,
  RING,
  CLUSTER;

  /** The six scenarios in the order of Table 7.1; scenario n has index n - 1. */
  public static final List<String> SCENARIOS =
      Stream.concat(
              Arrays.stream(values()).map(Layout::random),
              Arrays.stream(values()).map(Layout::scripted))
          .toList();

  /** The name in files. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The scenario in which targets move at random. */
  public String random() {
    return label() + "-random";
  }

  /** The scenario in which targets follow a script. */
  public String scripted() {
    return label() + "-scripted";
  }

  /** Returns the names of both scenarios. */
  public List<String> scenarios() {
    return List.of(random(), scripted());
  }
}
