package org.hificamsim.runs.compare;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Collectors;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.output.ManifestFile;

/**
 * What a run's result depends on, as a digest: two runs with the same key give the same result.
 *
 * <p>A detection model is known by its values on a fixed grid at the scenario's mount height, so
 * that an edited model file, or a user's changed jar, is another model. A policy is known by its
 * name and options alone.
 */
public final class RunKey {
  private RunKey() {}

  /** The key of a plan's repeats, but for their seed. */
  public static String of(RunPlan plan) {
    String all =
        String.join(
            "\n",
            ManifestFile.version(),
            plan.scenario().name(),
            ScenarioWriter.write(plan.scenario()),
            plan.policy(),
            String.valueOf(plan.steps()),
            values(plan.detection(), plan.scenario().mountHeight().orElse(Double.NaN)));
    return digest(all);
  }

  /** The key of all runs of a sweep. */
  static String of(List<RunPlan> plans) {
    return digest(
        plans.stream()
            .map(plan -> of(plan) + " " + plan.seed() + " " + plan.repeats())
            .collect(Collectors.joining("\n")));
  }

  private static String digest(String text) {
    return HexFormat.of().formatHex(digest().digest(text.getBytes(StandardCharsets.UTF_8)));
  }

  private static String values(Detection detection, double mountHeight) {
    StringBuilder values = new StringBuilder(detection.model().name());
    values.append(' ').append(detection.threshold());
    for (double radius = 1; radius <= 16; radius *= 2) {
      ZoomLevel zoom = new ZoomLevel(radius, 1, 16, mountHeight, 2 * Math.PI);
      for (double distance = 0; distance <= radius; distance += radius / 8) {
        values.append(' ').append(detection.model().confidence(0.5, distance, 0.25, zoom));
      }
    }
    return values.toString();
  }

  private static MessageDigest digest() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java platform has SHA-256", e);
    }
  }
}
