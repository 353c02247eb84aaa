package org.hificamsim.core.scenario.file;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Range;
import org.hificamsim.core.scenario.declaration.Type;
import org.hificamsim.core.scenario.spec.AgentCheck;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.OpticsLaw;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.xml.XmlElement;

/** Reads cameras, from their own element or from an event that adds one. */
public final class CameraReader {
  private final Type<Double> xInField;
  private final Type<Double> yInField;
  private final Type<OpticsSpec> optics;
  private final OptionalDouble mountHeight;
  private final ObstacleCheck obstacleCheck;
  private final AgentCheck agents;
  private final Set<String> names = new HashSet<>();

  /**
   * @param field the field, in which cameras must stand
   * @param mountHeight the mount height of the scenario, in metres, if it has one
   * @param optics the optics of the file, by name
   */
  public CameraReader(
      Field field,
      OptionalDouble mountHeight,
      ObstacleCheck obstacleCheck,
      Map<String, OpticsSpec> optics,
      AgentCheck agents) {
    this.xInField = inField(field.minX(), field.maxX());
    this.yInField = inField(field.minY(), field.maxY());
    this.optics = oneOf(optics);
    this.mountHeight = mountHeight;
    this.obstacleCheck = obstacleCheck;
    this.agents = agents;
  }

  private static Type<Double> inField(double min, double max) {
    return Type.number(new Range("a number inside the field, " + min + " to " + max, min, max));
  }

  private static Type<OpticsSpec> oneOf(Map<String, OpticsSpec> optics) {
    List<String> names = optics.keySet().stream().sorted().toList();
    return Type.named(
        names.isEmpty() ? "none: the file has no <optics>" : "one of " + String.join(", ", names),
        name -> Optional.ofNullable(optics.get(name)).orElseThrow(IllegalArgumentException::new),
        OpticsSpec::name);
  }

  /** Reads a camera by the declaration of its element. */
  public CameraSpec camera(XmlElement xml, Element<CameraSpec> element) {
    Attributes<CameraSpec> attributes =
        new Attributes<>(xml, element)
            .narrow("x", xInField)
            .narrow("y", yInField)
            .narrow("optics", optics);
    CameraSpec camera = withView(attributes.read(), attributes);
    if (!names.add(camera.name())) {
      throw attributes.invalid(CameraSpec.NAME, "a camera name that is not taken");
    }
    checkHeights(camera, attributes);
    OptionalDouble z = camera.z().isPresent() ? camera.z() : mountHeight;
    obstacleCheck.requireFree(xml, camera.x(), camera.y(), z);
    agents.check(camera, element == CameraSpec.ADDED, xml::invalid);
    attributes.warnOfUnknown();
    return camera;
  }

  /**
   * Completes the view of a camera. With a lens, the angle is by default the widest, and the range
   * that of the lens.
   */
  private static CameraSpec withView(CameraSpec camera, Attributes<CameraSpec> attributes) {
    Optional<OpticsSpec> lens = camera.optics().filter(optics -> optics.law().hasAngles());
    if (lens.isEmpty()) {
      attributes.require(CameraSpec.VIEWING_ANGLE);
      attributes.require(CameraSpec.RANGE);
      return camera;
    }
    List<Double> angles = lens.get().anglesOfView();
    double widest = angles.get(angles.size() - 1);
    double reach = lens.get().reach().orElse(0);
    return camera
        .with(CameraSpec.VIEWING_ANGLE, camera.find(CameraSpec.VIEWING_ANGLE).orElse(widest))
        .with(CameraSpec.RANGE, camera.find(CameraSpec.RANGE).orElse(reach));
  }

  private void checkHeights(CameraSpec camera, Attributes<CameraSpec> attributes) {
    if (camera.z().isPresent()
        && mountHeight.isPresent()
        && camera.z().getAsDouble() != mountHeight.getAsDouble()) {
      throw attributes.invalid(
          CameraSpec.Z, "the scenario's mount_height, " + mountHeight.getAsDouble() + ", or none");
    }
    List<Double> tilts = camera.optics().map(OpticsSpec::tilts).orElse(List.of(0.0));
    if (camera.optics().filter(optics -> optics.law() == OpticsLaw.PINHOLE).isEmpty()) {
      attributes.refuse(CameraSpec.TILT, "none without optics that have law=\"pinhole\"");
    }
    if (!tilts.stream().allMatch(tilt -> Range.TILT.contains(camera.tilt() + tilt))) {
      throw attributes.invalid(
          CameraSpec.TILT,
          "with each tilt of its optics, " + tilts + ", a sum of " + Range.TILT.expected());
    }
  }

  /** Expects an event to keep the camera in the field. */
  void narrow(Attributes<?> change) {
    change.narrow("x", Type.orUnchanged(xInField)).narrow("y", Type.orUnchanged(yInField));
  }
}
