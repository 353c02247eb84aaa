package org.hificamsim.hifi.density;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.Seen;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.hifi.OpticalDetection;
import org.hificamsim.hifi.model.PublishedModels;
import org.hificamsim.hifi.optics.Optics;

/** Registers the detection models that are based on pixel density. */
public final class DensityDetections {
  private DensityDetections() {}

  /** Adds the models to a registry. */
  public static void register(Registry<DetectionModel> registry) {
    registry
        .register("dori-2014", "pixels per metre of EN 62676-4:2014", DensityDetections::dori)
        .register(
            "oodpcvs-2025",
            "pixels per metre of IEC 62676-4:2025, as a vendor reports them",
            DensityDetections::oodpcvs)
        .register(
            "ttpf",
            "probability of acquisition by pixels on target (Johnson's criteria)",
            DensityDetections::acquisition);
  }

  /**
   * Returns the detections for all levels of a detection's standard, the least demanding first;
   * empty if the model follows no standard.
   */
  public static List<String> levels(String detection) {
    String standard = detection.replaceFirst("[:@].*", "");
    Enum<?>[] levels =
        standard.equals("dori-2014")
            ? Dori.values()
            : standard.equals("oodpcvs-2025") ? Oodpcvs.values() : new Dori[0];
    return Arrays.stream(levels).map(level -> standard + ":level=" + Spelling.of(level)).toList();
  }

  /**
   * Returns the level that a detection asks for, with the name that a level of the same density had
   * in EN 62676-4:2014; or the detection itself if it follows no standard.
   */
  public static String levelName(String detection) {
    List<String> levels = levels(detection);
    if (levels.isEmpty()) {
      return detection;
    }
    String named = detection.contains("level=") ? detection : levels.get(0);
    String level = named.replaceFirst(".*level=", "").replaceFirst("[@,].*", "");
    return detection.startsWith("oodpcvs")
        ? level + formerName(Spelling.require(Oodpcvs.class, "level", level).pixelsPerMetre)
        : level;
  }

  private static String formerName(double pixelsPerMetre) {
    return Arrays.stream(Dori.values())
        .filter(former -> former.pixelsPerMetre == pixelsPerMetre)
        .map(former -> " (formerly " + Spelling.of(former) + ")")
        .findFirst()
        .orElse("");
  }

  /** The tasks of EN 62676-4:2014, Annex B. */
  private enum Dori {
    DETECT(25),
    OBSERVE(62.5),
    RECOGNISE(125),
    IDENTIFY(250);

    private final double pixelsPerMetre;

    Dori(double pixelsPerMetre) {
      this.pixelsPerMetre = pixelsPerMetre;
    }
  }

  private static DetectionModel dori(Options options) {
    String meaning = "detect 25, observe 62.5, recognise 125, identify 250 pixels per metre";
    Dori level = options.choice("level", Dori.DETECT, meaning);
    String name = qualified("dori-2014", "level", level, Dori.DETECT);
    return new Standard(name, level.pixelsPerMetre, optics());
  }

  /** The levels of IEC 62676-4:2025, as a vendor reports them. */
  private enum Oodpcvs {
    OVERVIEW(20),
    OUTLINE(40),
    DISCERN(80),
    PERCEIVE(125),
    CHARACTERISE(250),
    VALIDATE(500),
    SCRUTINISE(1500);

    private final double pixelsPerMetre;

    Oodpcvs(double pixelsPerMetre) {
      this.pixelsPerMetre = pixelsPerMetre;
    }
  }

  private static DetectionModel oodpcvs(Options options) {
    String meaning =
        "overview 20, outline 40, discern 80, perceive 125, characterise 250, validate 500,"
            + " scrutinise 1500";
    Oodpcvs level = options.choice("level", Oodpcvs.OVERVIEW, meaning);
    String name = qualified("oodpcvs-2025", "level", level, Oodpcvs.OVERVIEW);
    return new Standard(name, level.pixelsPerMetre, optics());
  }

  /**
   * Johnson's criteria in the NVESD model: the cycles on target for a probability of one half, N50.
   */
  private enum AcquisitionTask {
    DETECT(1.0),
    ORIENT(1.4),
    RECOGNISE(4.0),
    IDENTIFY(6.4);

    private final double cycles;

    AcquisitionTask(double cycles) {
      this.cycles = cycles;
    }
  }

  private static DetectionModel acquisition(Options options) {
    String meaning = "cycles: detect 1.0, orient 1.4, recognise 4.0, identify 6.4";
    AcquisitionTask task = options.choice("task", AcquisitionTask.DETECT, meaning);
    String name = qualified("ttpf", "task", task, AcquisitionTask.DETECT);
    return new Acquisition(name, task.cycles, optics());
  }

  /** Returns the name of a model; the default choice is left out. */
  private static String qualified(String name, String key, Enum<?> chosen, Enum<?> defaultChoice) {
    return chosen == defaultChoice ? name : name + ":" + key + "=" + Spelling.of(chosen);
  }

  /** Returns the optics for scenarios that name no lens. */
  private static Optics optics() {
    return PublishedModels.published().optics();
  }

  /**
   * Detects a target if the picture has the pixels per metre that a standard demands at the
   * target's distance, regardless of its size. The confidence is the share of the demanded density,
   * at most 1; the threshold is 1.
   *
   * @param demandedDensity pixels per metre, above 0
   */
  private record Standard(String name, double demandedDensity, Optics optics)
      implements OpticalDetection {
    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return Math.min(1, optics.pixelsPerMetre(zoom, distance) / demandedDensity);
    }

    @Override
    public double defaultThreshold() {
      return 1;
    }

    @Override
    public Seen seen() {
      return demandedDensity >= Dori.RECOGNISE.pixelsPerMetre ? Seen.HEAD : Seen.WHOLE;
    }
  }

  /**
   * The target transfer probability function of night vision models: with N cycles (two pixels
   * each) on a target and r = N / N50, the target is acquired with probability {@code r^E / (1 +
   * r^E)}, where E = 2.7 + 0.7 r. Its successor is the TTP metric (Optical Engineering 43(11),
   * 2004).
   *
   * @param halfCycles N50, the cycles on target for a probability of one half, above 0
   */
  private record Acquisition(String name, double halfCycles, Optics optics)
      implements OpticalDetection {
    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return probability(size * optics.pixelsPerMetre(zoom, distance) / 2 / halfCycles);
    }

    @Override
    public Seen seen() {
      return halfCycles >= AcquisitionTask.RECOGNISE.cycles ? Seen.HEAD : Seen.WHOLE;
    }
  }

  /** Computes 1 / (1 + r^-E), which is a number for any ratio r of 0 or more. */
  static double probability(double ratio) {
    return 1 / (1 + Math.pow(ratio, -(2.7 + 0.7 * ratio)));
  }
}
