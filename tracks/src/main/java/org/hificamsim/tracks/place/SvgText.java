package org.hificamsim.tracks.place;

import java.awt.geom.AffineTransform;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Point;

/** Numbers, transforms and paths as SVG writes them. */
final class SvgText {
  static final String NUMBER = "[-+]?(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)(?:[eE][-+]?[0-9]+)?";

  private static final Pattern NUMBERS = Pattern.compile(NUMBER);
  private static final Pattern LIST =
      Pattern.compile("\\s*(?:" + NUMBER + "(?:\\s*,\\s*|\\s*))*", Pattern.DOTALL);
  private static final Pattern TRANSFORM =
      Pattern.compile("\\s*,?\\s*([a-zA-Z]+)\\s*\\(([^)]*)\\)\\s*");

  private SvgText() {}

  /** The numbers of a list; none where it holds anything else, or one above 1e9 in size. */
  static double[] numbers(String text) {
    if (!LIST.matcher(text).matches()) {
      return new double[0];
    }
    double[] numbers =
        NUMBERS
            .matcher(text)
            .results()
            .mapToDouble(one -> Double.parseDouble(one.group()))
            .toArray();
    return Arrays.stream(numbers).allMatch(n -> Math.abs(n) <= 1e9) ? numbers : new double[0];
  }

  /** What {@code transform} says. */
  static AffineTransform transform(String text, Supplier<InputException> fault) {
    AffineTransform all = new AffineTransform();
    Matcher parts = TRANSFORM.matcher(text);
    int end = 0;
    while (parts.find() && parts.start() == end) {
      all.concatenate(one(parts.group(1), numbers(parts.group(2)), fault));
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

  /** A path of straight parts, as the attribute {@code d} writes it. */
  static final class SvgPath {
    private static final Pattern COMMAND =
        Pattern.compile("\\s*,?\\s*([a-zA-Z])([^a-df-zA-DF-Z]*)");

    private final List<List<Point>> parts = new ArrayList<>();
    private List<Point> part = new ArrayList<>();
    private double x;
    private double y;

    /**
     * @param fault of a command that is not straight, or has not the right numbers
     */
    SvgPath(String d, Function<String, InputException> fault) {
      Matcher commands = COMMAND.matcher(d);
      int end = 0;
      while (commands.find() && commands.start() == end) {
        command(commands.group(1), commands.group(2), fault);
        end = commands.end();
      }
      if (!d.substring(end).isBlank()) {
        throw fault.apply(d.substring(end, end + 1));
      }
      endPart();
    }

    /** The parts, each in one go. */
    List<List<Point>> parts() {
      return parts;
    }

    private void command(String letter, String text, Function<String, InputException> fault) {
      double[] n = numbers(text);
      boolean relative = Character.isLowerCase(letter.charAt(0));
      String upper = String.valueOf(Character.toUpperCase(letter.charAt(0)));
      int size = "HV".contains(upper) ? 1 : 2;
      boolean closes = upper.equals("Z");
      if (!"MLHVZ".contains(upper) || n.length % size != 0 || closes != (n.length == 0)) {
        throw fault.apply(letter);
      }
      if (closes) {
        close();
      }
      for (int i = 0; i < n.length; i += size) {
        if (upper.equals("M") && i == 0) {
          endPart();
        }
        step(upper, n, i, relative);
      }
    }

    private void step(String upper, double[] n, int i, boolean relative) {
      double fromX = relative ? x : 0;
      double fromY = relative ? y : 0;
      x = upper.equals("V") ? x : fromX + n[i];
      y = upper.equals("H") ? y : fromY + n[upper.equals("V") ? i : i + 1];
      part.add(new Point(x, y));
    }

    private void close() {
      if (!part.isEmpty()) {
        Point first = part.get(0);
        part.add(first);
        x = first.x();
        y = first.y();
        endPart();
        part.add(first);
      }
    }

    private void endPart() {
      if (part.size() > 1) {
        parts.add(part);
      }
      part = new ArrayList<>();
    }
  }
}
