package org.hificamsim.cli;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.place.PlanScale;

/** Reads the value of {@code --scale}: metres, a scale on paper, or two points with a distance. */
final class ScaleText {
  private static final String NUMBER = "([-+]?[0-9]*\\.?[0-9]+(?:[eE][-+]?[0-9]+)?)";
  private static final Pattern METRES = Pattern.compile(NUMBER + "m?");
  private static final Pattern PAPER = Pattern.compile("1:" + NUMBER);
  private static final Pattern DISTANCE =
      Pattern.compile("%1$s(m|cm|mm)?=%1$s,%1$s:%1$s,%1$s".formatted(NUMBER));
  private static final double MAX = 1e9;

  private ScaleText() {}

  /**
   * Returns the scale.
   *
   * @throws InputException if the text has another form, or a number that is not above 0
   */
  static PlanScale parse(String text) {
    Matcher metres = METRES.matcher(text);
    if (metres.matches()) {
      return new PlanScale.PerUnit(positive(text, metres.group(1)));
    }
    Matcher paper = PAPER.matcher(text);
    if (paper.matches()) {
      return new PlanScale.Paper(positive(text, paper.group(1)));
    }
    Matcher distance = DISTANCE.matcher(text);
    if (distance.matches()) {
      return new PlanScale.PerUnit(metresPerUnit(text, distance));
    }
    throw malformed(text);
  }

  private static double metresPerUnit(String text, Matcher distance) {
    String unit = distance.group(2) == null ? "m" : distance.group(2);
    double metres =
        positive(text, distance.group(1)) * Spelling.require(Unit.class, "--scale", unit).metres();
    double[] ends = new double[4];
    for (int i = 0; i < ends.length; i++) {
      ends[i] = Double.parseDouble(distance.group(3 + i));
    }
    double scale = metres / Math.hypot(ends[2] - ends[0], ends[3] - ends[1]);
    if (!(scale > 0 && scale <= MAX)) {
      throw InputException.of("--scale is '%s', expected two points apart", text);
    }
    return scale;
  }

  private static double positive(String text, String number) {
    double value = Double.parseDouble(number);
    if (!(value > 0 && value <= MAX)) {
      throw malformed(text);
    }
    return value;
  }

  private static InputException malformed(String text) {
    return InputException.of(
        "--scale is '%s', expected the metres of a pixel or unit (0.02), a scale of paper (1:100)"
            + " or a distance between two points (12.5m=x1,y1:x2,y2)",
        text);
  }
}
