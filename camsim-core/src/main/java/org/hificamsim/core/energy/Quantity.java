package org.hificamsim.core.energy;

import java.math.BigDecimal;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;

/** Reads numbers with units of energy or power, such as {@code 0.209uJ} or {@code 2 Wh}. */
final class Quantity {
  private static final Pattern NUMBER_AND_UNIT =
      Pattern.compile("(\\d+(?:\\.\\d*)?(?:[eE][-+]?\\d+)?|\\.\\d+)\\s*([a-zA-Z]+)");
  private static final Map<String, BigDecimal> JOULES =
      Map.of(
          "nJ", new BigDecimal("1e-9"),
          "uJ", new BigDecimal("1e-6"),
          "mJ", new BigDecimal("1e-3"),
          "J", BigDecimal.ONE,
          "kJ", new BigDecimal("1e3"),
          "MJ", new BigDecimal("1e6"),
          "mWh", new BigDecimal("3.6"),
          "Wh", new BigDecimal("3.6e3"),
          "kWh", new BigDecimal("3.6e6"));
  private static final Map<String, BigDecimal> WATTS =
      Map.of(
          "uW", new BigDecimal("1e-6"),
          "mW", new BigDecimal("1e-3"),
          "W", BigDecimal.ONE,
          "kW", new BigDecimal("1e3"));

  private Quantity() {}

  /** Returns joules. */
  static double joules(String name, String text) {
    return value(name, text, JOULES, "12 mJ; units are nJ, uJ, mJ, J, kJ, MJ, mWh, Wh, kWh");
  }

  /** Returns watts. */
  static double watts(String name, String text) {
    return value(name, text, WATTS, "300 mW; units are uW, mW, W, kW");
  }

  private static double value(
      String name, String text, Map<String, BigDecimal> units, String example) {
    Matcher matcher = NUMBER_AND_UNIT.matcher(text);
    BigDecimal unit = matcher.matches() ? units.get(matcher.group(2)) : null;
    // In decimals, so that 0.2088 uJ is what 2.088E-7 J is.
    double value =
        unit == null ? Double.NaN : new BigDecimal(matcher.group(1)).multiply(unit).doubleValue();
    if (!Double.isFinite(value)) {
      throw InputException.of(
          "energy: %s is '%s', expected 0 or a positive number with its unit, such as %s",
          name, text, example);
    }
    return value;
  }
}
