package org.hificamsim.reproduction.ladder;

import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;

/**
 * The rungs of the world, from round views to a scenario as it is ({@code docs/ladder.md}). All
 * detect alike. Each is made by taking away from the rung above it.
 */
public final class WorldRungs {
  /** What is detected by unless asked otherwise. */
  public static final String DETECTION = "dori-2014:level=recognise";

  private final List<Rung> all;

  /**
   * @param detection of every rung, as users name it
   */
  public WorldRungs(String detection) {
    all =
        List.of(
            new Rung(
                "round",
                "all-round views, a radius for each level",
                detection,
                Simplifications::lenses),
            new Rung("optics", "lenses: angle against reach", detection, Simplifications::pan),
            new Rung("pan", "turning, at once", detection, Simplifications::time),
            new Rung(
                "time",
                "the time that turning and zooming take",
                detection,
                Simplifications::walls),
            new Rung("walls", "obstacles", detection, Simplifications::occlusion),
            new Rung(
                "occlusion",
                "targets hide targets, each of its own size",
                detection,
                UnaryOperator.identity()));
  }

  /** Every rung, the top one last. */
  public List<Rung> all() {
    return all;
  }

  /**
   * The rung of this name.
   *
   * @throws InputException when there is none
   */
  public Rung named(String name) {
    return all.stream()
        .filter(rung -> rung.name().equals(name))
        .findFirst()
        .orElseThrow(
            () -> new InputException("unknown rung '" + name + "', expected one of " + names()));
  }

  private String names() {
    return all.stream().map(Rung::name).collect(Collectors.joining(", "));
  }
}
