package org.hificamsim.core.scenario.declaration;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.obstacle.Point;

/**
 * The type of the values of an attribute, for files, messages and the schema.
 *
 * @param expected the expected values in words, for messages
 * @param schema the simple type in the schema: base and facets, as in {@code xs:int
 *     minInclusive=0}; a list has the type of its items in brackets; alternatives are separated by
 *     bars
 * @param parser parses a text; returns null for no value; throws an IllegalArgumentException if the
 *     text is not a value
 * @param writer writes a value so that the parser reads an equal one
 */
public record Type<T>(
    String expected, String schema, Function<String, T> parser, Function<T, String> writer) {
  private static final String STRING = "xs:string";
  private static final String DECIMAL = "[+\\-0-9.eE]+";
  private static final int MAX_NUMBERS = 1000;

  /** The least number that Java writes with an exponent. */
  private static final double FIRST_EXPONENT = 1e7;

  public static final Type<String> TEXT = text("a text");

  /** The name of an existing camera. */
  public static final Type<String> CAMERA = text("the name of a camera");

  public static final Type<Double> FINITE = number(Range.FINITE);
  public static final Type<Double> COORDINATE = withWriter(number(Range.COORDINATE), Type::plain);
  public static final Type<Double> LENGTH = number(Range.LENGTH);
  public static final Type<Double> POSITIVE_LENGTH = number(Range.POSITIVE_LENGTH);
  public static final Type<Double> POSITIVE = number(Range.POSITIVE);
  public static final Type<Double> PROPORTION = number(Range.PROPORTION);
  public static final Type<Double> OPENING = number(Range.OPENING);

  /** The speed of a target. CamSim reads negative speeds, which the schema refuses as senseless. */
  public static final Type<Double> SPEED =
      new Type<>(Range.SPEED.expected(), LENGTH.schema, Range.SPEED::parse, String::valueOf);

  /** The corners of a polygon. */
  public static final Type<List<Point>> POINTS =
      new Type<>(
          "corners as in 0,0 4,0 4,3; three or more, each coordinate "
              + Range.COORDINATE.expected(),
          STRING + " pattern=\\s*@,@(\\s+@,@){2,}\\s*".replace("@", DECIMAL),
          text -> items(text).map(Type::point).toList(),
          points ->
              listed(points.stream().map(point -> plain(point.x()) + "," + plain(point.y()))));

  /** Any number of points. */
  public static final Type<List<Point>> PLACES =
      new Type<>(
          "points as in 0,0 4,0 4,3; each coordinate " + Range.COORDINATE.expected(),
          STRING + " pattern=(\\s*@,@)*\\s*".replace("@", DECIMAL),
          text -> text.isBlank() ? List.of() : POINTS.parser.apply(text),
          POINTS.writer);

  /** The radii of zoom levels. */
  public static final Type<List<Double>> RADII =
      new Type<>(
          "rising radii above 0 and at most 1e9 (m), between spaces, 1 to " + MAX_NUMBERS,
          "[" + POSITIVE_LENGTH.schema + "] minLength=1 maxLength=" + MAX_NUMBERS,
          text -> {
            List<Double> radii = items(text).map(Range.POSITIVE_LENGTH::parse).toList();
            return require(radii.equals(rising(radii)) && radii.size() <= MAX_NUMBERS, radii);
          },
          radii -> listed(radii.stream().map(String::valueOf)));

  /** Any text, even an empty one. */
  public static Type<String> text(String expected) {
    return named(expected, text -> text, text -> text);
  }

  /** A value that is written by name. */
  public static <T> Type<T> named(
      String expected, Function<String, T> parser, Function<T, String> writer) {
    return new Type<>(expected, STRING, parser, writer);
  }

  /** A number. */
  public static Type<Double> number(Range range) {
    String least = range.min() == Range.ABOVE_0 ? "minExclusive=0" : "minInclusive=" + range.min();
    return new Type<>(
        range.expected(),
        "xs:double " + least + " maxInclusive=" + range.max(),
        range::parse,
        String::valueOf);
  }

  private static Type<Double> withWriter(Type<Double> type, Function<Double, String> writer) {
    return new Type<>(type.expected, type.schema, type.parser, writer);
  }

  /** Returns the text of a number, without an exponent if it is large. */
  private static String plain(double value) {
    return Math.abs(value) >= FIRST_EXPONENT && Double.isFinite(value)
        ? new BigDecimal(Double.toString(value)).toPlainString()
        : Double.toString(value);
  }

  /** The type with -1 as well, which stands for an unchanged value. */
  public static Type<Double> orUnchanged(Type<Double> type) {
    return new Type<>(
        type.expected + ", or -1 to leave it",
        type.schema + " | xs:double enumeration=-1",
        text -> Double.parseDouble(text) == -1 ? -1.0 : type.parser.apply(text),
        type.writer);
  }

  /** A whole number of at least {@code min}. */
  public static Type<Integer> whole(int min) {
    return whole("a whole number of " + min + " or more", min, Integer.MAX_VALUE);
  }

  /** A whole number from {@code min} to {@code max}. */
  public static Type<Integer> whole(int min, int max) {
    return whole("a whole number from " + min + " to " + max, min, max);
  }

  private static Type<Integer> whole(String expected, int min, int max) {
    return new Type<>(
        expected,
        "xs:int minInclusive=" + min + " maxInclusive=" + max,
        text -> {
          int value = Integer.parseInt(text);
          return require(value >= min && value <= max, value);
        },
        String::valueOf);
  }

  /** A constant, written in lower case with {@code -} for {@code _}. */
  public static <E extends Enum<E>> Type<E> choice(Class<E> type) {
    return new Type<>(
        "one of " + Spelling.all(type),
        words(Arrays.stream(type.getEnumConstants()).map(Spelling::of)),
        text -> Spelling.find(type, text).orElseThrow(IllegalArgumentException::new),
        Spelling::of);
  }

  /** Returns the type of an attribute that is one of several words. */
  public static Type<String> word(List<String> words) {
    return new Type<>(
        String.join(", ", words).replaceFirst(", (?=[^,]*$)", " or "),
        words(words.stream()),
        text -> require(words.contains(text), text),
        text -> text);
  }

  /** The type of one of these words in the schema. */
  public static String words(Stream<String> words) {
    return STRING + words.map(word -> " enumeration=" + word).collect(Collectors.joining());
  }

  /**
   * Returns the type of one or more different numbers in any order, separated by spaces or written
   * as {@code from:to:step}.
   */
  public static Type<List<Double>> numbers(Range range) {
    return new Type<>(
        "numbers between spaces, each once, or from:to:step; each " + range.expected(),
        STRING + " pattern=\\s*@(:@:@)?(\\s+@(:@:@)?)*\\s*".replace("@", DECIMAL),
        text -> rising(items(text).flatMap(item -> counted(item, range)).toList()),
        numbers -> listed(numbers.stream().map(String::valueOf)));
  }

  private static List<Double> rising(List<Double> numbers) {
    List<Double> rising = numbers.stream().distinct().sorted().toList();
    return require(rising.size() == numbers.size(), rising);
  }

  private static Stream<Double> counted(String item, Range range) {
    List<Double> parts = Arrays.stream(item.split(":", -1)).map(range::parse).toList();
    if (parts.size() == 1) {
      return parts.stream();
    }
    require(parts.size() == 3, parts);
    double step = parts.get(2);
    double steps = (parts.get(1) - parts.get(0)) / step;
    require(step > 0 && steps >= 0 && steps < MAX_NUMBERS, steps);
    return IntStream.rangeClosed(0, (int) Math.floor(steps + 1e-9))
        .mapToObj(i -> parts.get(0) + i * step);
  }

  private static Point point(String corner) {
    List<Double> parts = Arrays.stream(corner.split(",", -1)).map(Range.COORDINATE::parse).toList();
    require(parts.size() == 2, parts);
    return new Point(parts.get(0), parts.get(1));
  }

  private static <V> V require(boolean valid, V value) {
    if (!valid) {
      throw new IllegalArgumentException();
    }
    return value;
  }

  private static Stream<String> items(String text) {
    return Arrays.stream(text.strip().split("\\s+"));
  }

  private static String listed(Stream<String> items) {
    return items.collect(Collectors.joining(" "));
  }
}
