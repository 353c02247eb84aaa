package org.hificamsim.core.registry;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.file.Fields;

/**
 * The {@code key=value,...} part of {@code name:key=value,...}.
 *
 * <p>Each getter declares one option: its key, default, range and meaning. A value that is missing
 * takes the default; one that is malformed or out of range is an {@link InputException}. After all
 * getters have been called, {@link #rejectUnknown} refuses undeclared options and lists what is
 * valid. A token without {@code =} continues the list before it, or, at the start, belongs to the
 * option that is read with {@link #integers}: {@code fixed:0,1,2} equals {@code
 * fixed:levels=0,1,2}.
 */
public final class Options {
  /** One declared option: its key, its default as text, and what it means. */
  public record Declared(String key, String defaultValue, String meaning) {}

  private static final String POSITIONAL = "";

  private final String owner;
  private final Map<String, String> values = new LinkedHashMap<>();
  private final Map<String, Declared> declared = new LinkedHashMap<>();
  private boolean listDeclared;

  private Options(String owner) {
    this.owner = owner;
  }

  /** Creates empty options for {@code owner}: every getter returns its default. */
  public static Options none(String owner) {
    return new Options(owner);
  }

  /**
   * Splits a list such as {@code P,Q:key=value,key=value,R} into names with their options. A part
   * between commas begins a new name, unless it is a {@code key=value} or a number, which belongs
   * to the name before it.
   *
   * @param isName whether a part that looks like an option is a name
   */
  public static List<String> splitNames(String list, Predicate<String> isName) {
    List<String> names = new ArrayList<>();
    for (String part : list.split(",", -1)) {
      String text = part.strip();
      int last = names.size() - 1;
      if (last >= 0 && text.matches("[^:]*=.*|\\d+") && !isName.test(text)) {
        names.set(last, names.get(last) + "," + text);
      } else {
        names.add(text);
      }
    }
    return names;
  }

  /**
   * Parses {@code key=value,key=value}.
   *
   * @throws InputException if a key is given twice or is empty
   */
  public static Options parse(String owner, String text) {
    Options options = new Options(owner);
    String key = POSITIONAL;
    for (String token : text.split(",", -1)) {
      int equals = token.indexOf('=');
      if (equals < 0) {
        options.values.merge(key, token.strip(), (list, item) -> list + "," + item);
        continue;
      }
      key = token.substring(0, equals).strip();
      if (key.isEmpty() || options.values.containsKey(key)) {
        throw InputException.of(
            "%s: option '%s', expected key=value with each key once", owner, token);
      }
      options.values.put(key, token.substring(equals + 1).strip());
    }
    return options;
  }

  /** Reads a finite number in [{@code min}, {@code max}]. */
  public double number(String key, double defaultValue, double min, double max, String meaning) {
    String text = take(key, Double.toString(defaultValue), meaning);
    if (text == null) {
      return defaultValue;
    }
    double value = Fields.value(text);
    if (!(Double.isFinite(value) && value >= min && value <= max)) {
      throw invalid(key, text, "a number " + range(min, max));
    }
    return value;
  }

  /** Reads a whole number in [{@code min}, {@code max}]. */
  public int integer(String key, int defaultValue, int min, int max, String meaning) {
    String text = take(key, Integer.toString(defaultValue), meaning);
    return text == null ? defaultValue : integer(key, text, min, max);
  }

  /**
   * Reads a comma-separated list of whole numbers; the first list that is declared may be given
   * without its key.
   */
  public List<Integer> integers(
      String key, List<Integer> defaultValue, int min, int max, String meaning) {
    String text =
        take(
            key,
            defaultValue.stream().map(String::valueOf).collect(Collectors.joining(",")),
            meaning);
    if (text == null && !listDeclared) {
      text = values.remove(POSITIONAL);
    }
    listDeclared = true;
    if (text == null) {
      return defaultValue;
    }
    List<Integer> list = new ArrayList<>();
    for (String item : text.split(",", -1)) {
      list.add(integer(key, item.strip(), min, max));
    }
    return List.copyOf(list);
  }

  /** Reads an enumeration constant, written in lower case with {@code -} for {@code _}. */
  public <E extends Enum<E>> E choice(String key, E defaultValue, String meaning) {
    String text = take(key, Spelling.of(defaultValue), meaning);
    if (text == null) {
      return defaultValue;
    }
    Class<E> type = defaultValue.getDeclaringClass();
    return Spelling.find(type, text)
        .orElseThrow(() -> invalid(key, text, "one of " + Spelling.all(type)));
  }

  /** Reads a text. */
  public String text(String key, String defaultValue, String meaning) {
    String text = take(key, defaultValue, meaning);
    return text == null ? defaultValue : text;
  }

  /**
   * Reads a text that may be given without its key, as {@code onnx:policy.onnx}; with a key it may
   * contain an equals sign.
   */
  public String mainText(String key, String defaultValue, String meaning) {
    String text = text(key, defaultValue, meaning);
    return text.equals(defaultValue) && values.containsKey(POSITIONAL)
        ? values.remove(POSITIONAL)
        : text;
  }

  /** The options that the getters called so far have declared, in that order. */
  public List<Declared> declared() {
    return List.copyOf(declared.values());
  }

  /**
   * Refuses options that no getter declared.
   *
   * @throws InputException that names the first one and lists the valid ones
   */
  public void rejectUnknown() {
    for (Map.Entry<String, String> entry : values.entrySet()) {
      if (entry.getKey().isEmpty() && declared.containsKey(entry.getValue())) {
        throw new InputException(
            owner
                + ": option '%1$s' has no value, expected %1$s=VALUE".formatted(entry.getValue()));
      }
      String given =
          entry.getKey().isEmpty() ? entry.getValue() : entry.getKey() + "=" + entry.getValue();
      throw InputException.of(
          "%s: unknown option '%s', expected %s",
          owner,
          given,
          declared.isEmpty() ? "no options" : "one of " + String.join(", ", declared.keySet()));
    }
  }

  private String take(String key, String defaultValue, String meaning) {
    declared.put(key, new Declared(key, defaultValue, meaning));
    return values.remove(key);
  }

  private int integer(String key, String text, int min, int max) {
    try {
      int value = Integer.parseInt(text);
      if (value >= min && value <= max) {
        return value;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw invalid(key, text, "a whole number from " + min + " to " + max);
  }

  /** Writes a range for messages; the smallest number above 0 is written as "above 0". */
  private static String range(double min, double max) {
    return min == Double.MIN_VALUE
        ? "above 0 and at most " + BigDecimal.valueOf(max).stripTrailingZeros().toPlainString()
        : "from " + min + " to " + max;
  }

  private InputException invalid(String key, String text, String expected) {
    return new InputException(owner + ": " + key + " is '" + text + "', expected " + expected);
  }
}
