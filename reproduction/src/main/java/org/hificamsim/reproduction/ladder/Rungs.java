package org.hificamsim.reproduction.ladder;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;

/** The rungs of realism, from the least to the most realistic ({@code docs/ladder.md}). */
public final class Rungs {
  /** The detection of the rungs of the world if neither the user nor the scenario names one. */
  public static final String WORLD_DETECTION = "oodpcvs-2025:level=perceive";

  private static final List<Rung> DETECTION_RUNGS =
      List.of(
          new Rung("geometric", "the field of view alone"),
          new Rung("camsim-standard", "the zoom (Eq 6.2)"),
          new Rung("camsim-range", "the distance (the coverage study's formula)"),
          new Rung("hifi:orb-pinhole", "the target's size, through an ideal lens"),
          new Rung("hifi:orb-power", "a power law for the real lens"),
          new Rung("hifi:orb-svr-lin", "a fit to photos: R2 0.74, the line of measured sizes"),
          new Rung("hifi:orb-sr", "a fit to photos: R2 0.73, a line of its own"),
          new Rung("hifi:orb-lin", "a fit to photos: R2 0.86, a line of its own"),
          new Rung("hifi:orb-sr@chance", "the scatter of the detector: rmse 0.059"),
          new Rung("hifi:orb-lin@chance:alpha=0.001", "a detector with a high threshold"),
          new Rung("hifi:orb-lin@chance:alpha=0.01", "a detector with a threshold in between"),
          new Rung("hifi:orb-lin@chance", "the scatter of the detector: rmse 0.052"));

  private Rungs() {}

  /** All rungs of detection, the top rung last. */
  public static List<Rung> ofDetection() {
    return DETECTION_RUNGS;
  }

  /** The rung of detection of a name; a new one for a detection that has no rung here. */
  public static Rung ofDetection(String name) {
    return find(DETECTION_RUNGS, name).orElseGet(() -> new Rung(name, ""));
  }

  /**
   * The rungs of the world, from round views to the unchanged scenario. Each rung lacks one thing
   * that the rung above it has.
   *
   * @param detection detection of all rungs, as users name it; empty for that of each scenario
   */
  public static List<Rung> ofWorld(Optional<String> detection) {
    return List.of(
        new Rung(
            "round",
            "all-round views, a radius for each level",
            detection,
            Simplifications::lenses),
        new Rung("optics", "lenses: angle against reach", detection, Simplifications::pan),
        new Rung("pan", "turning, at once", detection, Simplifications::time),
        new Rung(
            "time", "the time that turning and zooming take", detection, Simplifications::walls),
        new Rung("walls", "obstacles", detection, Simplifications::occlusion),
        new Rung(
            "occlusion",
            "targets hide targets, each of its own size",
            detection,
            UnaryOperator.identity()));
  }

  /**
   * The rung of the world of a name.
   *
   * @throws InputException when there is no such rung
   */
  public static Rung ofWorld(Optional<String> detection, String name) {
    List<Rung> rungs = ofWorld(detection);
    String names = rungs.stream().map(Rung::name).collect(Collectors.joining(", "));
    return find(rungs, name)
        .orElseThrow(
            () -> new InputException("unknown rung '" + name + "', expected one of " + names));
  }

  private static Optional<Rung> find(List<Rung> rungs, String name) {
    return rungs.stream().filter(rung -> rung.name().equals(name)).findFirst();
  }

  /**
   * A degree of realism: how it simplifies a scenario, and how targets are detected.
   *
   * @param name name in files, different from those of the other rungs of a ladder
   * @param adds the realism that the rungs below lack, in a few words
   * @param detection detection as users name it; empty for that of the scenario
   * @param world simplifies a scenario and gives it another name; or returns it unchanged
   */
  public record Rung(
      String name, String adds, Optional<String> detection, UnaryOperator<Scenario> world) {
    /** A rung that leaves scenarios unchanged and has the name of its detection. */
    Rung(String detection, String adds) {
      this(detection, adds, Optional.of(detection), UnaryOperator.identity());
    }

    /** The settings with the detection of this rung. */
    Settings with(Settings settings) {
      return detection
          .map(name -> settings.with(Setting.DETECTION, name))
          .orElseGet(() -> settings.orElse(Setting.DETECTION, WORLD_DETECTION));
    }

    /**
     * The detection of this rung. Without a rule in its name it is by the model's own rule,
     * regardless of the scenario: a rung is the same in all scenarios.
     *
     * @throws org.hificamsim.core.InputException when there is no such detection
     */
    public Detection detection(
        Settings settings, Scenario scenario, Function<String, DetectionModel> models) {
      Settings rungSettings = with(settings);
      DetectionSpec spec =
          DetectionSpec.parse(rungSettings.value(Setting.DETECTION, scenario), models);
      return spec.or(spec.model().defaultRule()).detection(rungSettings, scenario);
    }
  }
}
