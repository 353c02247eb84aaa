package org.hificamsim.network.rules;

import static java.util.Locale.ROOT;

import java.util.List;
import java.util.Random;

/** Random scenarios in the pattern of the recorded ones, with options for BanditSolverZoom. */
public final class RandomZoomScenario {
  public static final int STEPS = 300;
  private static final List<String> BANDITS =
      List.of("SoftMax", "SoftMax", "UCB1", "EpsilonGreedy");
  private static final List<Double> ANGLES = List.of(60.0, 75.5, 90.0, 120.0, 200.0, 360.0);
  private static final List<String> MOVES = List.of("Brownian", "DirectedBrownian");

  private final Random random;
  private final int halfWidth;
  private final int halfHeight;
  private final int cameras;
  private final int objects;

  public RandomZoomScenario(long seed) {
    random = new Random(seed);
    halfWidth = 20 + 5 * random.nextInt(3);
    halfHeight = 15 + 5 * random.nextInt(2);
    cameras = 2 + random.nextInt(8);
    objects = 2 + random.nextInt(10);
  }

  /** The options before the file. */
  public String options() {
    String options =
        text(
            "-t %d -s %d -a epics.ai.dynamicZoom.BanditSolverZoom -c 0 -b epics.bandits.%s",
            STEPS, random.nextInt(10), pick(BANDITS));
    if (random.nextInt(3) == 0) {
      options += text(" -e %d -r %d", random.nextInt(6), 10 * random.nextInt(10));
    }
    return random.nextInt(3) == 0 ? options + " -v " + random.nextInt(3) : options;
  }

  /** The scenario file. */
  public String xml() {
    StringBuilder xml =
        new StringBuilder(
            text(
                "<root><simulation min_x=\"%d\" max_x=\"%d\" min_y=\"%d\" max_y=\"%d\">%n",
                -halfWidth, halfWidth, -halfHeight, halfHeight));
    for (int camera = 0; camera < cameras; camera++) {
      xml.append(text("<camera name=\"K%02d\" %s/>%n", camera, mounting("comm=\"0\" ")));
    }
    for (int object = 0; object < objects; object++) {
      xml.append(object(text("%.2f", 0.5 + 1.01 * object)));
    }
    for (int event = 0; event < 2 + random.nextInt(6); event++) {
      xml.append(event(event));
    }
    return xml.append("</simulation></root>").toString();
  }

  private String mounting(String further) {
    return text(
        "%s%s heading=\"%.1f\" viewing_angle=\"%s\" range=\"%.1f\"",
        further,
        position(),
        360 * random.nextDouble() - 180,
        pick(ANGLES),
        7 + 11 * random.nextDouble());
  }

  private String position() {
    return text(
        "x=\"%.2f\" y=\"%.2f\"",
        halfWidth * (2 * random.nextDouble() - 1), halfHeight * (2 * random.nextDouble() - 1));
  }

  private String walk() {
    return text(
        "%s heading=\"%.1f\" speed=\"%.2f\"",
        position(), 360 * random.nextDouble(), 0.3 + 1.3 * random.nextDouble());
  }

  private String object(String name) {
    if (random.nextInt(4) == 0) {
      return text(
          "<object_with_waypoints features=\"%s\" speed=\"1\">%s</object_with_waypoints>%n",
          name, path());
    }
    String move =
        random.nextInt(3) == 0
            ? text(
                " move=\"epics.movement.%s\" mean=\"%.2f\" std=\"%.2f\"",
                pick(MOVES), 0.06 * random.nextDouble() - 0.03, 0.6 * random.nextDouble())
            : "";
    return text("<object features=\"%s\" %s%s/>%n", name, walk(), move);
  }

  private String path() {
    StringBuilder path = new StringBuilder();
    for (int waypoint = 0; waypoint < 2 + random.nextInt(3); waypoint++) {
      path.append(text("<waypoint %s/>", position()));
    }
    return path.toString();
  }

  private String event(int number) {
    int step = random.nextInt(STEPS / 2);
    return switch (random.nextInt(6)) {
      case 0 -> event(step, "object", "add", text("%.1f", 20.3 + number), walk(), "");
      case 1 -> event(step, "object", "add", text("%.1f", 20.3 + number), walk(), path());
      case 2 -> event(step, "object", "error", 0.5 + 1.01 * random.nextInt(objects) + "", "", "");
      case 3 -> event(step, "camera", "error", anyCamera(), "duration=\"7\"", "");
      case 4 -> event(step, "camera", "add", "L0" + number, mounting("comm=\"0\" "), "");
      default -> event(step, "camera", "change", anyCamera(), mounting(""), "");
    };
  }

  private static String event(
      int step, String participant, String kind, String name, String attributes, String path) {
    return text(
        "<event timestep=\"%d\" participant=\"%s\" event=\"%s\" name=\"%s\" %s>%s</event>%n",
        step, participant, kind, name, attributes, path);
  }

  private static String text(String format, Object... values) {
    return String.format(ROOT, format, values);
  }

  private String anyCamera() {
    return text("K%02d", random.nextInt(cameras));
  }

  private <T> T pick(List<T> values) {
    return values.get(random.nextInt(values.size()));
  }
}
