package org.hificamsim.core.energy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;

/**
 * The energy that cameras take for each {@link EnergyFigure}, and the charge of their batteries:
 * the setting {@code energy} ({@code docs/energy.md}). A {@code EnergyMeter} applies it in a run.
 */
public final class EnergyModel {
  /** The model in which nothing takes energy and nothing is measured. */
  public static final EnergyModel NONE = new EnergyModel(new LinkedHashMap<>());

  /** An example for help. */
  public static final String EXAMPLE = "cc2420,idle=300mW,sense=12mJ,battery=5kJ";

  private static final String BATTERY = "battery";

  /** The profiles that come with the simulator; docs/energy.md has their sources. */
  private static final Map<String, String> PROFILES =
      new TreeMap<>(
          Map.of(
              "cc2420", "send=0.2088uJ,receive=0.2256uJ",
              "nrf24l01", "send=16.95nJ,receive=20.25nJ"));

  private final Map<EnergyFigure, Double> figures = new EnumMap<>(EnergyFigure.class);
  private final double battery;

  private EnergyModel(Map<String, String> values) {
    for (EnergyFigure figure : EnergyFigure.values()) {
      String text = values.remove(figure.key());
      figures.put(figure, text == null ? 0 : figure.parse(text));
    }
    String text = values.remove(BATTERY);
    battery = text == null ? Double.POSITIVE_INFINITY : Quantity.joules(BATTERY, text);
    if (battery == 0) {
      throw InputException.of("energy: battery is '%s', expected more than 0", text);
    }
    if (!values.isEmpty()) {
      throw InputException.of(
          "energy: unknown figure '%s', expected one of %s, %s",
          values.keySet().iterator().next(), EnergyFigure.keys(), BATTERY);
    }
  }

  /**
   * Parses {@code none}, a profile's name, figures as {@code key=value,...}, or a name with figures
   * that replace its own.
   *
   * @throws InputException if a name, figure or unit is unknown or out of range
   */
  public static EnergyModel parse(String text) {
    return text.equals("none") ? NONE : of(List.of(text.split(",", -1)));
  }

  /**
   * Parses a text like {@link #parse}, or reads a file with a name or figure in each line and
   * comments after {@code #}.
   */
  public static EnergyModel parseOrRead(String text) {
    Path file = Path.of(text);
    return Files.isRegularFile(file) ? read(file) : parse(text);
  }

  private static EnergyModel read(Path file) {
    try {
      List<String> items = new ArrayList<>();
      int number = 0;
      for (String line : Files.readAllLines(file)) {
        number++;
        String item = line.replaceFirst("#.*", "").strip();
        if (!item.isEmpty()) {
          requireValid(file, number, item);
          items.add(item);
        }
      }
      return of(items);
    } catch (IOException e) {
      throw InputException.of("%s: cannot be read as text in UTF-8", file);
    }
  }

  private static void requireValid(Path file, int line, String item) {
    try {
      of(List.of(item));
    } catch (InputException e) {
      throw InputException.of("%s:%s: %s", file, line, e.getMessage());
    }
  }

  /** Creates a model from a profile's name, if the first item is one, and figures. */
  private static EnergyModel of(List<String> items) {
    boolean named = !items.isEmpty() && !items.get(0).contains("=");
    Map<String, String> values = new LinkedHashMap<>();
    if (named) {
      values.putAll(figures(List.of(profile(items.get(0).strip()).split(","))));
    }
    values.putAll(figures(items.subList(named ? 1 : 0, items.size())));
    return new EnergyModel(values);
  }

  private static String profile(String name) {
    if (!PROFILES.containsKey(name)) {
      throw InputException.of(
          "energy: unknown profile '%s', expected none, one of %s, a file, or key=value,...",
          name, String.join(", ", PROFILES.keySet()));
    }
    return PROFILES.get(name);
  }

  private static Map<String, String> figures(List<String> items) {
    Map<String, String> values = new LinkedHashMap<>();
    for (String item : items) {
      int equals = item.indexOf('=');
      String key = item.substring(0, Math.max(0, equals)).strip();
      if (key.isEmpty() || values.put(key, item.substring(equals + 1).strip()) != null) {
        throw InputException.of(
            "energy: '%s', expected key=value with each key once, such as sense=12mJ", item);
      }
    }
    return values;
  }

  /** The model as users write it, with the figures that are not 0. */
  public String text() {
    String given =
        Stream.concat(
                Arrays.stream(EnergyFigure.values())
                    .filter(figure -> figure(figure) > 0)
                    .map(figure -> figure.text(figure(figure))),
                hasBatteries() ? Stream.of(BATTERY + "=" + battery + "J") : Stream.empty())
            .collect(Collectors.joining(","));
    return given.isEmpty() ? "none" : given;
  }

  /** Whether nothing takes energy. */
  public boolean isNone() {
    return figures.values().stream().allMatch(value -> value == 0);
  }

  /** A figure, in the SI unit that {@link EnergyFigure} gives. */
  public double figure(EnergyFigure figure) {
    return figures.get(figure);
  }

  /** Whether batteries can run empty. */
  public boolean hasBatteries() {
    return Double.isFinite(battery);
  }

  /** The charge of a camera's battery at the start, in joules; infinite without batteries. */
  public double battery() {
    return battery;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof EnergyModel model && text().equals(model.text());
  }

  @Override
  public int hashCode() {
    return text().hashCode();
  }
}
