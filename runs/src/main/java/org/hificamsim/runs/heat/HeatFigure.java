package org.hificamsim.runs.heat;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.hificamsim.runs.heat.HeatMap.Place;

/**
 * The figures of a cell that pictures and pages of a heat map can show. A cell whose figure is NaN
 * stays empty; 0 has a colour of its own.
 */
@SuppressWarnings("ImmutableEnumChecker") // functions
public enum HeatFigure {
  MEAN_K(
      "cameras that would detect there, mean", "no camera, at no step", Unit.CAMERAS, Place::meanK),
  COVERED(
      "steps with 1 or more cameras",
      "no camera, at no step",
      Unit.SHARE,
      place -> 1 - place.covered0()),
  COVERED_K("steps with 2 or more cameras", "never 2 cameras", Unit.SHARE, Place::coveredK),
  VISITS(
      "targets there, added up over the steps",
      "",
      Unit.COUNT,
      place -> place.visits() == 0 ? Double.NaN : place.visits()),
  VISITS_MEAN_K(
      "cameras that detected a target there, mean",
      "no camera, at no visit",
      Unit.CAMERAS,
      Place::visitsMeanK),
  VISITS_COVERED(
      "visits with 1 or more cameras",
      "no camera, at no visit",
      Unit.SHARE,
      place -> 1 - place.visitsCovered0());

  /** The unit of a figure, which decides its scale. */
  private enum Unit {
    CAMERAS,
    SHARE,
    COUNT
  }

  private static final int MAX_TICKS = 6;

  private final String label;
  private final String never;
  private final Unit unit;
  private final ToDoubleFunction<Place> figure;

  HeatFigure(String label, String never, Unit unit, ToDoubleFunction<Place> figure) {
    this.label = label;
    this.never = never;
    this.unit = unit;
    this.figure = figure;
  }

  /** The figure of a cell; NaN if it has none. */
  public double figureOf(Place place) {
    return figure.applyAsDouble(place);
  }

  /** The meaning, for a legend. */
  public String label() {
    return label;
  }

  /** The meaning of 0, for a legend. */
  public String never() {
    return never;
  }

  /** The end of the scale: a whole number of cameras, all steps or visits, or the largest count. */
  public double end(HeatMap map) {
    double most =
        map.places().stream()
            .mapToDouble(this::figureOf)
            .filter(value -> value > 0)
            .max()
            .orElse(1);
    return unit == Unit.SHARE ? 1 : Math.max(1, Math.ceil(most));
  }

  /**
   * The position of a figure on the scale, in [0, 1]. Counts are logarithmic, because a few cells
   * have most of them.
   */
  public double share(double figure, double end) {
    if (unit == Unit.COUNT) {
      return end > 1 ? Math.log(figure) / Math.log(end) : 1;
    }
    return figure / end;
  }

  /** Whether the scale is logarithmic. */
  public boolean isLogarithmic() {
    return unit == Unit.COUNT;
  }

  /** The numbers along the scale, in ascending order. */
  public List<Double> ticks(double end) {
    return switch (unit) {
      case SHARE -> List.of(0.0, 0.25, 0.5, 0.75, 1.0);
      case CAMERAS -> cameras(end);
      case COUNT -> powers(end);
    };
  }

  private static List<Double> cameras(double end) {
    double gap = end <= 2 ? end / 4 : Math.ceil(end / (MAX_TICKS - 1));
    return IntStream.rangeClosed(0, (int) (end / gap)).mapToObj(i -> i * gap).toList();
  }

  private static List<Double> powers(double end) {
    List<Double> ticks = new ArrayList<>();
    for (double tick = 1; 2 * tick <= end; tick *= 10) {
      ticks.add(tick);
    }
    ticks.add(end);
    return ticks;
  }

  /** A tick in words. */
  public String tick(double figure) {
    return switch (unit) {
      case SHARE -> Math.round(100 * figure) + " %";
      case CAMERAS -> Double.toString(figure).replaceFirst("\\.0$", "");
      case COUNT -> Long.toString((long) figure);
    };
  }
}
