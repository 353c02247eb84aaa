package org.hificamsim.network.files;

import java.io.IOException;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Properties;
import java.util.TreeSet;
import java.util.function.DoublePredicate;
import org.hificamsim.core.InputException;
import org.hificamsim.network.auction.HistoricalParameters;
import org.hificamsim.network.bandit.BanditParameters;

/**
 * The parameters of {@code -p}: a Java properties file, keys in any case (behaviour 8.7; quirk Q2
 * mended). Keys that are not given keep CamSim's defaults.
 */
public final class ParameterFile {
  private static final List<String> KEYS =
      List.of(
          "PreInstantiationBidCoefficient",
          "OverstayBidCoefficient",
          "DebugHist",
          "ClassificationEnabled",
          "ObjectCategories",
          "HistPerCategoryEnabled",
          "HistEnabled",
          "Epsilon",
          "Alpha",
          "Beta",
          "Gamma",
          "Interval");

  private final String name;
  private final Map<String, String> values = new LinkedHashMap<>();

  private ParameterFile(String name) {
    this.name = name;
  }

  /** A file that sets nothing. */
  public static ParameterFile none() {
    return new ParameterFile("");
  }

  /**
   * Reads a file.
   *
   * @throws InputException when it is missing or malformed, or has an unknown key
   */
  public static ParameterFile read(Path path) {
    ParameterFile file = new ParameterFile(path.toString());
    Properties properties = new Properties();
    try (Reader reader = Files.newBufferedReader(path, StandardCharsets.UTF_8)) {
      properties.load(reader);
    } catch (IOException | IllegalArgumentException e) {
      throw new InputException(path + ": cannot be read as a properties file: " + e, e);
    }
    for (String key : new TreeSet<>(properties.stringPropertyNames())) {
      if (KEYS.stream().noneMatch(key::equalsIgnoreCase)) {
        throw new InputException(
            "%s: unknown key '%s', expected one of %s"
                .formatted(path, key, String.join(", ", KEYS)));
      }
      file.values.put(lower(key), properties.getProperty(key).strip());
    }
    return file;
  }

  /** What it says about the historical schedules. */
  public HistoricalParameters historical() {
    HistoricalParameters defaults = HistoricalParameters.DEFAULT;
    truth("DebugHist", false);
    return new HistoricalParameters(
        number("PreInstantiationBidCoefficient", defaults.preInstantiation(), "any", value -> true),
        number("OverstayBidCoefficient", defaults.overstay(), "any", value -> true),
        truth("ClassificationEnabled", defaults.classification()),
        whole("ObjectCategories", defaults.categories(), 360),
        truth("HistPerCategoryEnabled", defaults.perCategory()),
        truth("HistEnabled", defaults.history()));
  }

  /** What it says about the bandits. */
  public BanditParameters bandit() {
    BanditParameters defaults = BanditParameters.DEFAULT;
    return new BanditParameters(
        number("Epsilon", defaults.epsilon(), "above 0", value -> value > 0),
        number("Alpha", defaults.alpha(), "from 0 to 1", ParameterFile::isShare),
        number("Beta", defaults.beta(), "from 0 to 1", ParameterFile::isShare),
        number("Gamma", defaults.gamma(), "from 0 to 1", ParameterFile::isShare),
        whole("Interval", defaults.interval(), Integer.MAX_VALUE));
  }

  private static boolean isShare(double value) {
    return value >= 0 && value <= 1;
  }

  private double number(String key, double otherwise, String range, DoublePredicate valid) {
    String text = values.get(lower(key));
    if (text == null) {
      return otherwise;
    }
    try {
      double value = Double.parseDouble(text);
      if (Double.isFinite(value) && valid.test(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      // told below
    }
    throw invalid(key, text, "a number, " + range);
  }

  private int whole(String key, int otherwise, int most) {
    String text = values.get(lower(key));
    if (text == null) {
      return otherwise;
    }
    try {
      int value = Integer.parseInt(text);
      if (value >= 1 && value <= most) {
        return value;
      }
    } catch (NumberFormatException e) {
      // told below
    }
    throw invalid(key, text, "a whole number from 1 to " + most);
  }

  private boolean truth(String key, boolean otherwise) {
    String text = values.get(lower(key));
    if (text == null) {
      return otherwise;
    }
    return switch (lower(text)) {
      case "true" -> true;
      case "false" -> false;
      default -> throw invalid(key, text, "true or false");
    };
  }

  private InputException invalid(String key, String text, String expected) {
    return new InputException("%s: %s is '%s', expected %s".formatted(name, key, text, expected));
  }

  private static String lower(String text) {
    return text.toLowerCase(Locale.ROOT);
  }
}
