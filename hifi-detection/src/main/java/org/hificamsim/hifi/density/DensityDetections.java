package org.hificamsim.hifi.density;

import org.hificamsim.core.Spelling;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.hifi.model.PublishedModels;
import org.hificamsim.hifi.optics.Optics;

/** The models that count pixels, by name. */
public final class DensityDetections {
  private DensityDetections() {}

  /** Adds them to a registry. */
  public static void register(Registry<DetectionModel> registry) {
    registry
        .register(
            "dori-2014",
            "pixels per metre of EN 62676-4:2014",
            options ->
                standard(
                    "dori-2014",
                    options,
                    Dori.DETECT,
                    "detect 25, observe 62.5," + " recognise 125, identify 250 pixels per metre"))
        .register(
            "oodpcvs-2025",
            "pixels per metre of IEC 62676-4:2025, as a vendor reports them",
            options ->
                standard(
                    "oodpcvs-2025",
                    options,
                    Oodpcvs.OVERVIEW,
                    "overview 20, outline 40, discern 80, perceive 125, characterise 250, validate"
                        + " 500, scrutinise 1500"))
        .register(
            "ttpf",
            "probability of acquisition by pixels on target (Johnson's criteria)",
            DensityDetections::transferFunction);
  }

  private static <E extends Enum<E> & DemandedDensity> DetectionModel standard(
      String name, Options options, E standard, String meaning) {
    E level = options.choice("level", standard, meaning);
    return new StandardDetection(
        named(name, "level", level, standard), level.pixelsPerMetre(), optics());
  }

  private static DetectionModel transferFunction(Options options) {
    AcquisitionTask standard = AcquisitionTask.DETECT;
    AcquisitionTask task =
        options.choice(
            "task", standard, "cycles: detect 1.0, orient 1.4, recognise 4.0, identify 6.4");
    return new TransferFunctionDetection(
        named("ttpf", "task", task, standard), task.cycles(), optics());
  }

  /** The default goes without saying. */
  private static String named(String name, String key, Enum<?> chosen, Enum<?> standard) {
    return chosen == standard ? name : name + ":" + key + "=" + Spelling.of(chosen);
  }

  /** For scenarios that name no lens. */
  private static Optics optics() {
    return PublishedModels.published().optics();
  }
}
