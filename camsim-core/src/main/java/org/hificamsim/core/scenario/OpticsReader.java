package org.hificamsim.core.scenario;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.Consumer;

/** Reads the optics that cameras name. */
final class OpticsReader {
  private static final int MAX_PIXELS = 100_000;
  private static final int MAX_VIEWS = 10_000;
  private static final Range BELOW_180 =
      new Range("degrees above 0 and below 180", value -> value > 0 && value < 180);
  private static final Range UP_TO_180 =
      new Range("degrees above 0 and at most 180", value -> value > 0 && value <= 180);
  private static final Range TURN = new Range("degrees from -360 to 360", v -> Math.abs(v) <= 360);
  private static final Range ABOVE_0 =
      new Range("a number above 0 and at most 1e9", value -> value > 0 && value <= 1e9);
  private static final Range TIME =
      new Range("a number from 0 to 1e9 (s)", value -> value >= 0 && value <= 1e9);

  /** Stands for optics that had a fault, so that their cameras are not at fault as well. */
  private static final OpticsSpec FAULTY =
      new OpticsSpec(
          "",
          OpticsLaw.PINHOLE,
          OptionalInt.empty(),
          List.of(1.0),
          OptionalDouble.empty(),
          List.of(0.0),
          OptionalDouble.empty(),
          0,
          Moving.BLIND);

  private final Consumer<String> warnings;
  private final Map<String, OpticsSpec> known = new HashMap<>();

  OpticsReader(Consumer<String> warnings) {
    this.warnings = warnings;
  }

  /** Reads one and remembers it by its name. */
  OpticsSpec optics(XmlElement element) {
    Attributes attributes = new Attributes(element);
    String name = attributes.text("name", "a name that no other optics have");
    if (known.containsKey(name)) {
      throw attributes.invalid("name", "a name that no other optics have");
    }
    known.put(name, FAULTY);
    OpticsSpec optics = optics(name, attributes);
    if ((long) optics.pans().size() * Math.max(1, optics.anglesOfView().size()) > MAX_VIEWS) {
      throw attributes.invalid("pan", "at most " + MAX_VIEWS + " views, angles times levels");
    }
    attributes.leftOver(warnings);
    known.put(name, optics);
    return optics;
  }

  /** The optics that a camera names. */
  Optional<OpticsSpec> named(Attributes camera) {
    Optional<String> name = camera.optionalText("optics");
    if (name.isPresent() && !known.containsKey(name.get())) {
      throw camera.invalid("optics", expected());
    }
    return name.map(known::get);
  }

  private String expected() {
    return known.isEmpty()
        ? "none: the file has no <optics>"
        : "one of " + String.join(", ", known.keySet().stream().sorted().toList());
  }

  private OpticsSpec optics(String name, Attributes attributes) {
    OpticsLaw law = attributes.choice("law", OpticsLaw.PINHOLE);
    List<Double> angles = angles(law, attributes);
    return new OpticsSpec(
        name,
        law,
        attributes.optionalInteger("pixels", 1, MAX_PIXELS),
        angles,
        reach(law, attributes),
        new NumberList(attributes, "pan", TURN).rising(List.of(0.0)),
        attributes.optionalNumber("pan_speed", ABOVE_0),
        attributes.optionalNumber("zoom_time", TIME).orElse(0),
        attributes.choice("moving", Moving.BLIND));
  }

  /** Rising; from focal lengths and the sensor's width by Eq 3.1 where the file gives those. */
  private static List<Double> angles(OpticsLaw law, Attributes attributes) {
    if (!law.hasAngles()) {
      attributes.refuse("hfov", "none with law=\"round\", whose levels are the zoom list's radii");
      attributes.refuse("focal_length", "none with law=\"round\"");
      return List.of();
    }
    Range range = law.widest() < 180 ? BELOW_180 : UP_TO_180;
    if (!attributes.has("focal_length")) {
      return new NumberList(attributes, "hfov", range).sorted();
    }
    attributes.refuse("hfov", "none beside focal_length");
    double width = attributes.number("sensor_width", ABOVE_0);
    return new NumberList(attributes, "focal_length", ABOVE_0)
        .sorted().stream()
            .map(length -> 2 * Math.toDegrees(StrictMath.atan(width / (2 * length))))
            .sorted()
            .toList();
  }

  private static OptionalDouble reach(OpticsLaw law, Attributes attributes) {
    if (!law.hasAngles()) {
      attributes.refuse("reach", "none with law=\"round\", whose levels have their radii");
    }
    return law.needsReach()
        ? OptionalDouble.of(attributes.number("reach", Range.POSITIVE_LENGTH))
        : attributes.optionalNumber("reach", Range.POSITIVE_LENGTH);
  }
}
