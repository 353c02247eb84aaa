package org.hificamsim.network.files;

import java.io.IOException;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Properties;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.core.registry.Options;
import org.hificamsim.network.agent.HistoricalParameters;
import org.hificamsim.network.bandit.BanditParameters;

/**
 * The parameters in the file of option {@code -p}, a Java properties file (behaviour 8.7; quirk Q2
 * is fixed). The case of keys is ignored; missing keys have CamSim's defaults.
 */
public record ParameterFile(HistoricalParameters historical, BanditParameters bandit) {
  /** The parameters of an empty file. */
  public static final ParameterFile DEFAULT =
      new ParameterFile(HistoricalParameters.DEFAULT, BanditParameters.DEFAULT);

  private static final double MAX_NUMBER = 1e9;
  private static final int MAX_CATEGORIES = 360;

  private enum Truth {
    FALSE,
    TRUE
  }

  /**
   * Reads a file.
   *
   * @throws InputException if the file is missing or malformed, or has an unknown key
   */
  public static ParameterFile read(Path path) {
    Properties properties = new Properties();
    try (Reader reader = Files.newBufferedReader(path, StandardCharsets.UTF_8)) {
      properties.load(reader);
    } catch (IOException | IllegalArgumentException e) {
      throw new InputException(path + ": cannot be read, expected a properties file: " + e, e);
    }
    Options options =
        properties.isEmpty()
            ? Options.none(path.toString())
            : Options.parse(path.toString(), text(properties));
    ParameterFile file = new ParameterFile(historical(options), bandit(options));
    options.rejectUnknown();
    return file;
  }

  private static String text(Properties properties) {
    return new TreeSet<>(properties.stringPropertyNames())
        .stream()
            .map(
                key ->
                    declaredKey(key) + "=" + properties.getProperty(key).toLowerCase(Locale.ROOT))
            .collect(Collectors.joining(","));
  }

  private static String declaredKey(String key) {
    Options none = Options.none("");
    historical(none);
    bandit(none);
    return none.declared().stream()
        .map(Options.Declared::key)
        .filter(key::equalsIgnoreCase)
        .findFirst()
        .orElse(key);
  }

  private static HistoricalParameters historical(Options options) {
    HistoricalParameters defaults = HistoricalParameters.DEFAULT;
    readBoolean(options, "DebugHist", false);
    return new HistoricalParameters(
        options.number(
            "PreInstantiationBidCoefficient",
            defaults.preInstantiation(),
            -MAX_NUMBER,
            MAX_NUMBER,
            ""),
        options.number("OverstayBidCoefficient", defaults.overstay(), -MAX_NUMBER, MAX_NUMBER, ""),
        readBoolean(options, "ClassificationEnabled", defaults.classification()),
        options.integer("ObjectCategories", defaults.categories(), 1, MAX_CATEGORIES, ""),
        readBoolean(options, "HistPerCategoryEnabled", defaults.perCategory()),
        readBoolean(options, "HistEnabled", defaults.history()));
  }

  private static BanditParameters bandit(Options options) {
    BanditParameters defaults = BanditParameters.DEFAULT;
    return new BanditParameters(
        options.number("Epsilon", defaults.epsilon(), Double.MIN_VALUE, MAX_NUMBER, ""),
        options.number("Alpha", defaults.alpha(), 0, 1, ""),
        options.number("Beta", defaults.beta(), 0, 1, ""),
        options.number("Gamma", defaults.gamma(), 0, 1, ""),
        options.integer("Interval", defaults.interval(), 1, Integer.MAX_VALUE, ""));
  }

  private static boolean readBoolean(Options options, String key, boolean defaultValue) {
    return options.choice(key, defaultValue ? Truth.TRUE : Truth.FALSE, "") == Truth.TRUE;
  }
}
