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

/** The models that count pixels, by name. */
public final class DensityDetections {
  /** The width of a picture where the scenario does not say: full high definition. */
  private static final int DEFAULT_PIXELS = 1920;

  private DensityDetections() {}

  /** Adds them to a registry. */
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

  /** All levels of the standard that a detection is of, the least first; none of other models. */
  public static List<String> levels(String detection) {
    String standard = detection.replaceFirst("[:@].*", "");
    Enum<?>[] levels =
        standard.equals("dori-2014")
            ? Dori.values()
            : standard.equals("oodpcvs-2025") ? Oodpcvs.values() : new Dori[0];
    return Arrays.stream(levels).map(one -> standard + ":level=" + Spelling.of(one)).toList();
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
    String name = named("dori-2014", "level", level, Dori.DETECT);
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
    String name = named("oodpcvs-2025", "level", level, Oodpcvs.OVERVIEW);
    return new Standard(name, level.pixelsPerMetre, optics());
  }

  /** Johnson's criteria as the NVESD model has them: cycles on target for an even chance, N50. */
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
    String name = named("ttpf", "task", task, AcquisitionTask.DETECT);
    return new Acquisition(name, task.cycles, optics());
  }

  /** The default goes without saying. */
  private static String named(String name, String key, Enum<?> chosen, Enum<?> standard) {
    return chosen == standard ? name : name + ":" + key + "=" + Spelling.of(chosen);
  }

  /** For scenarios that name no lens. */
  private static Optics optics() {
    return PublishedModels.published().optics();
  }

  /**
   * What a standard demands for a task: a target is detected where its place has this many pixels
   * per metre, whatever its size. The value is the share of the demanded density that is there, at
   * most 1, which is the threshold.
   *
   * @param demanded pixels per metre, above 0
   */
  private record Standard(String name, double demanded, Optics optics) implements OpticalDetection {
    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return Math.min(1, density(zoom, optics, distance) / demanded);
    }

    @Override
    public double defaultThreshold() {
      return 1;
    }

    @Override
    public Seen seen() {
      return demanded >= Dori.RECOGNISE.pixelsPerMetre ? Seen.HEAD : Seen.WHOLE;
    }
  }

  /**
   * The target transfer probability function of night vision models: with N cycles on a target, two
   * pixels each, and r = N / N50, it is acquired with probability {@code r^E / (1 + r^E)}, where E
   * = 2.7 + 0.7 r. Its successor is the TTP metric (Optical Engineering 43(11), 2004).
   *
   * @param halfCycles N50, cycles on target for an even chance, above 0
   */
  private record Acquisition(String name, double halfCycles, Optics optics)
      implements OpticalDetection {
    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return probability(size * density(zoom, optics, distance) / 2 / halfCycles);
    }

    @Override
    public Seen seen() {
      return halfCycles >= AcquisitionTask.RECOGNISE.cycles ? Seen.HEAD : Seen.WHOLE;
    }
  }

  /** As 1 / (1 + r^-E), which stays a number for any ratio r of 0 or more. */
  static double probability(double ratio) {
    return 1 / (1 + Math.pow(ratio, -(2.7 + 0.7 * ratio)));
  }

  /**
   * Pixels per metre across, W / (2 d tan(theta / 2)); infinite at distance 0.
   *
   * @param optics give the angle of view where the scenario names no lens
   * @param distance metres
   */
  private static double density(ZoomLevel zoom, Optics optics, double distance) {
    int pixels = zoom.pixels() > 0 ? zoom.pixels() : DEFAULT_PIXELS;
    double angle =
        zoom.hasLens() ? zoom.angleOfView() : optics.angleOfView(optics.focalLength(zoom));
    return pixels / (2 * distance * StrictMath.tan(angle / 2));
  }
}
