package org.hificamsim.tracks.place;

import java.awt.geom.AffineTransform;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;

/** Numbers and transforms as SVG writes them. */
final class SvgNumbers {
  static final String NUMBER = "[-+]?(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)(?:[eE][-+]?[0-9]+)?";

  private static final Pattern NUMBERS = Pattern.compile(NUMBER);
  private static final Pattern LIST =
      Pattern.compile("\\s*(?:" + NUMBER + "(?:\\s*,\\s*|\\s*))*", Pattern.DOTALL);
  private static final Pattern TRANSFORM =
      Pattern.compile("\\s*,?\\s*([a-zA-Z]+)\\s*\\(([^)]*)\\)\\s*");

  private SvgNumbers() {}

  /** The numbers of a list; none where it holds anything else. */
  static double[] all(String text) {
    return LIST.matcher(text).matches()
        ? Stream.of(text)
            .flatMap(one -> NUMBERS.matcher(one).results())
            .mapToDouble(one -> Double.parseDouble(one.group()))
            .toArray()
        : new double[0];
  }

  /** What {@code transform} says. */
  static AffineTransform transform(String text, Supplier<InputException> fault) {
    AffineTransform all = new AffineTransform();
    Matcher parts = TRANSFORM.matcher(text);
    int end = 0;
    while (parts.find() && parts.start() == end) {
      all.concatenate(one(parts.group(1), all(parts.group(2)), fault));
      end = parts.end();
    }
    if (!text.substring(end).isBlank()) {
      throw fault.get();
    }
    return all;
  }

  private static AffineTransform one(String name, double[] n, Supplier<InputException> fault) {
    return switch (name + n.length) {
      case "matrix6" -> new AffineTransform(n);
      case "translate1" -> AffineTransform.getTranslateInstance(n[0], 0);
      case "translate2" -> AffineTransform.getTranslateInstance(n[0], n[1]);
      case "scale1" -> AffineTransform.getScaleInstance(n[0], n[0]);
      case "scale2" -> AffineTransform.getScaleInstance(n[0], n[1]);
      case "rotate1" -> AffineTransform.getRotateInstance(Math.toRadians(n[0]));
      case "rotate3" -> AffineTransform.getRotateInstance(Math.toRadians(n[0]), n[1], n[2]);
      case "skewX1" -> AffineTransform.getShearInstance(Math.tan(Math.toRadians(n[0])), 0);
      case "skewY1" -> AffineTransform.getShearInstance(0, Math.tan(Math.toRadians(n[0])));
      default -> throw fault.get();
    };
  }
}
