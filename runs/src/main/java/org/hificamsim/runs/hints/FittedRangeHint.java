package org.hificamsim.runs.hints;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.World;
import org.hificamsim.hifi.FittedOn;
import org.hificamsim.hifi.FittedOn.Span;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.boxes.BoxDetection;
import org.hificamsim.hifi.boxes.FittedBoxes;
import org.hificamsim.runs.ShortNumber;

/**
 * Warns if sizes of targets, focal lengths or radii of fields of view are outside the range that
 * the model was fitted on, where that is known.
 */
final class FittedRangeHint {
  /**
   * The least focal length of a lens, in metres; a smaller one stands for a camera without a lens.
   */
  private static final double MIN_FOCAL_LENGTH = 1e-6;

  private FittedRangeHint() {}

  static Optional<String> of(Scenario scenario, Detection detection) {
    if (detection.model() instanceof BoxDetection boxes) {
      return boxes.fitted().flatMap(fitted -> tooLow(scenario, detection.name(), boxes, fitted));
    }
    return detection.model() instanceof HiFiDetection model
        ? model.fitted().flatMap(fitted -> warning(scenario, detection.name(), model, fitted))
        : Optional.empty();
  }

  private static Optional<String> warning(
      Scenario scenario, String name, HiFiDetection model, FittedOn fitted) {
    List<ZoomLevel> zooms = World.zoomLevels(scenario);
    DoubleStream sizes = scenario.everyTarget().mapToDouble(TargetSpec::size);
    DoubleStream focalLengths =
        zooms.stream()
            .mapToDouble(model.optics()::focalLength)
            .filter(focalLength -> focalLength > MIN_FOCAL_LENGTH);
    // a target that is nearer than in any photo fills the image, and is detected
    Span distances = new Span(0, fitted.distance().most());
    List<String> outside = new ArrayList<>();
    addIfOutside(outside, "sizes", fitted.size(), sizes);
    addIfOutside(outside, "focal lengths", fitted.focalLength(), focalLengths);
    addIfOutside(outside, "distances", distances, zooms.stream().mapToDouble(ZoomLevel::radius));
    return outside.isEmpty()
        ? Optional.empty()
        : Optional.of(
            "'%s' was not fitted on what is asked of it: %s; expected photos of these, or a model whose f is the pinhole camera's"
                .formatted(name, String.join(", ", outside)));
  }

  /**
   * Warns if the lowest target at the far end of the widest view is lower than any labelled box.
   */
  private static Optional<String> tooLow(
      Scenario scenario, String name, BoxDetection model, FittedBoxes fitted) {
    double height = scenario.everyTarget().mapToDouble(TargetSpec::height).min().orElse(Double.NaN);
    double pixels =
        World.zoomLevels(scenario).stream()
            .mapToDouble(zoom -> model.pixels(height, zoom.radius(), zoom))
            .min()
            .orElse(Double.NaN);
    return pixels < fitted.height().least()
        ? Optional.of(
            "'%s' was fitted on people of %s pixels and more: at the far end of views targets have %s"
                .formatted(
                    name, Math.round(fitted.height().least()), ShortNumber.of(Math.rint(pixels))))
        : Optional.empty();
  }

  private static void addIfOutside(
      List<String> outside, String quantity, Span fitted, DoubleStream used) {
    double[] values = used.filter(Double::isFinite).toArray();
    if (values.length > 0) {
      Span span = Span.of(values);
      if (!fitted.contains(span.least()) || !fitted.contains(span.most())) {
        outside.add(quantity + " " + text(span) + " m (fitted on " + text(fitted) + ")");
      }
    }
  }

  private static String text(Span span) {
    String least = ShortNumber.of(span.least());
    return span.least() == span.most() ? least : least + " to " + ShortNumber.of(span.most());
  }
}
