package org.hificamsim.reproduction.ladder;

import java.util.List;

/** The rungs, one line each, from the least realism to the most ({@code docs/ladder.md}). */
public final class Rungs {
  private static final List<Rung> ALL =
      List.of(
          new Rung("geometric", "the field of view alone"),
          new Rung("camsim-standard", "the zoom (Eq 6.2)"),
          new Rung("camsim-range", "the distance (the coverage study's formula)"),
          new Rung("hifi:orb-pinhole", "the target's size, through an ideal lens"),
          new Rung("hifi:orb-power", "a power law for the real lens"),
          new Rung("hifi:orb-svr-lin", "a fit to photos: R2 0.74, the line of measured sizes"),
          new Rung("hifi:orb-sr", "a fit to photos: R2 0.73, a line of its own"),
          new Rung("hifi:orb-lin", "a fit to photos: R2 0.86, a line of its own"),
          new Rung("hifi:orb-sr@chance", "the scatter of the detector: rmse 0.059"),
          new Rung("hifi:orb-lin@chance", "the scatter of the detector: rmse 0.052"));

  private Rungs() {}

  /** Every rung, the top one last. */
  public static List<Rung> all() {
    return ALL;
  }

  /** The rung of this name; one of this detection where there is none. */
  public static Rung named(String name) {
    return ALL.stream()
        .filter(rung -> rung.name().equals(name))
        .findFirst()
        .orElseGet(() -> new Rung(name, ""));
  }
}
