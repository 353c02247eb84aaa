package org.hificamsim.core.scenario.file;

import static org.hificamsim.core.scenario.spec.OpticsSpec.ANGLES_OF_VIEW;
import static org.hificamsim.core.scenario.spec.OpticsSpec.ASPECT;
import static org.hificamsim.core.scenario.spec.OpticsSpec.FOCAL_LENGTHS;
import static org.hificamsim.core.scenario.spec.OpticsSpec.REACH;
import static org.hificamsim.core.scenario.spec.OpticsSpec.SENSOR_WIDTH;
import static org.hificamsim.core.scenario.spec.OpticsSpec.TILTS;
import static org.hificamsim.core.scenario.spec.OpticsSpec.VERTICAL_ANGLES;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.declaration.Range;
import org.hificamsim.core.scenario.declaration.Type;
import org.hificamsim.core.scenario.spec.OpticsLaw;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.xml.XmlElement;

/** Reads the optics that cameras name. */
public final class OpticsReader {
  private static final int MAX_VIEWS = 10_000;

  private final Map<String, OpticsSpec> known = new HashMap<>();

  /** Reads all of a file, by name. */
  public Map<String, OpticsSpec> all(List<XmlElement> elements, Faults faults) {
    elements.forEach(xml -> faults.check(() -> read(xml)));
    return known;
  }

  private void read(XmlElement xml) {
    Attributes<OpticsSpec> attributes = new Attributes<>(xml, OpticsSpec.ELEMENT);
    String name = attributes.get(OpticsSpec.NAME);
    if (known.containsKey(name)) {
      throw attributes.invalid(OpticsSpec.NAME, "a name that no other optics have");
    }
    // In place of optics that have a fault, so that cameras that name them have none.
    known.put(name, new OpticsSpec(name).with(ANGLES_OF_VIEW, List.of(1.0)));
    checkLaw(attributes);
    checkHeights(attributes);
    OpticsSpec optics = withAngles(attributes.read());
    long directions = (long) optics.pans().size() * optics.tilts().size();
    if (directions * Math.max(1, optics.anglesOfView().size()) > MAX_VIEWS) {
      throw attributes.invalid(
          OpticsSpec.PANS, "at most " + MAX_VIEWS + " views, angles times levels");
    }
    if (attributes.has(SENSOR_WIDTH) && !attributes.has(FOCAL_LENGTHS)) {
      xml.warn("sensor_width of <optics> is of no effect without focal_length");
    }
    attributes.warnOfUnknown();
    known.put(name, optics);
  }

  /** Checks the vertical attributes, which only optics with a lens have. */
  private static void checkHeights(Attributes<OpticsSpec> attributes) {
    OpticsLaw law = attributes.get(OpticsSpec.LAW);
    if (law != OpticsLaw.PINHOLE) {
      for (Property<OpticsSpec, ?> property : List.of(VERTICAL_ANGLES, ASPECT, TILTS)) {
        attributes.refuse(
            property, "none with law=\"" + Spelling.of(law) + "\", which has no lens");
      }
    }
    if (attributes.has(VERTICAL_ANGLES)) {
      attributes.refuse(ASPECT, "none together with vfov");
      int levels =
          Math.max(
              attributes.get(ANGLES_OF_VIEW).size(),
              Optional.ofNullable(attributes.get(FOCAL_LENGTHS)).map(List::size).orElse(0));
      if (attributes.get(VERTICAL_ANGLES).size() != levels) {
        throw attributes.invalid(VERTICAL_ANGLES, "one for each level, " + levels);
      }
    }
  }

  private static void checkLaw(Attributes<OpticsSpec> attributes) {
    OpticsLaw law = attributes.get(OpticsSpec.LAW);
    if (!law.hasAngles()) {
      String none = "none with law=\"round\"";
      attributes.refuse(ANGLES_OF_VIEW, none + ", whose levels are the zoom list's radii");
      attributes.refuse(FOCAL_LENGTHS, none);
      attributes.refuse(REACH, none + ", whose levels have their radii");
      return;
    }
    if (law.widest() < 180) {
      attributes.narrow("hfov", Type.numbers(Range.BELOW_180));
    }
    if (law.needsReach()) {
      attributes.require(REACH);
    }
    if (attributes.has(FOCAL_LENGTHS)) {
      attributes.refuse(ANGLES_OF_VIEW, "none together with focal_length");
      attributes.require(SENSOR_WIDTH);
    } else {
      attributes.require(ANGLES_OF_VIEW);
    }
  }

  /** Computes the angles of view from focal lengths and the width of the sensor (Eq 3.1). */
  private static OpticsSpec withAngles(OpticsSpec optics) {
    OpticsSpec rest = optics.without(FOCAL_LENGTHS).without(SENSOR_WIDTH);
    return optics
        .find(FOCAL_LENGTHS)
        .map(lengths -> rest.with(ANGLES_OF_VIEW, angles(lengths, optics.get(SENSOR_WIDTH))))
        .orElse(rest);
  }

  private static List<Double> angles(List<Double> lengths, double width) {
    return lengths.stream().map(length -> OpticsSpec.angleOfView(width, length)).sorted().toList();
  }
}
