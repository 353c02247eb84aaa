package org.hificamsim.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioEvent;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.core.world.World;
import org.hificamsim.hifi.FittedOn;
import org.hificamsim.hifi.FittedOn.Span;
import org.hificamsim.hifi.HiFiDetection;

/** Where a scenario asks a model for what nobody has photographed. */
final class Extrapolation {
  private Extrapolation() {}

  /**
   * A warning where sizes of targets, focal lengths or radii of fields of view lie outside what the
   * model was fitted on; none where that is not known.
   */
  static Optional<String> warning(Scenario scenario, Detection detection) {
    return detection.model() instanceof HiFiDetection model
        ? model.fitted().flatMap(on -> warning(scenario, detection.name(), model, on))
        : Optional.empty();
  }

  private static Optional<String> warning(
      Scenario scenario, String name, HiFiDetection model, FittedOn on) {
    List<ZoomLevel> zooms = World.zoomLevels(scenario);
    List<String> outside = new ArrayList<>();
    add(outside, "sizes", on.size(), sizes(scenario));
    add(
        outside,
        "focal lengths",
        on.focalLength(),
        zooms.stream().mapToDouble(model.optics()::focalLength));
    add(outside, "distances", upTo(on.distance()), zooms.stream().mapToDouble(ZoomLevel::radius));
    return outside.isEmpty()
        ? Optional.empty()
        : Optional.of(
            "'"
                + name
                + "' was not fitted on what is asked of it: "
                + String.join(", ", outside)
                + "; expected photos of these, or a model whose f is the pinhole camera's");
  }

  /** What is nearer than any photo fills the image, and is detected. */
  private static Span upTo(Span distances) {
    return new Span(0, distances.most());
  }

  private static void add(List<String> outside, String what, Span fitted, DoubleStream asked) {
    double[] values = asked.filter(Double::isFinite).toArray();
    if (values.length > 0) {
      Span span = Span.of(values);
      if (!fitted.contains(span.least()) || !fitted.contains(span.most())) {
        outside.add(what + " " + shown(span) + " m (fitted on " + shown(fitted) + ")");
      }
    }
  }

  private static DoubleStream sizes(Scenario scenario) {
    Stream<TargetSpec> added =
        scenario.events().stream()
            .filter(ScenarioEvent.AddTarget.class::isInstance)
            .map(event -> ((ScenarioEvent.AddTarget) event).target());
    return Stream.concat(scenario.targets().stream(), added).mapToDouble(TargetSpec::size);
  }

  private static String shown(Span span) {
    return Numbers.plain(span.least())
        + (span.least() == span.most() ? "" : " to " + Numbers.plain(span.most()));
  }
}
