package org.hificamsim.hifi.model;

import java.util.Locale;
import java.util.Optional;
import org.hificamsim.core.Texts;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.LiteralDetection;
import org.hificamsim.hifi.Provenance;

/**
 * Registers the high-fidelity models: {@code hifi:<detector>-<f>} uses the line of Table 6.1 that
 * was fitted on f's own predictions, {@code hifi:<detector>-<f>-gt} the line fitted on measured
 * PIP. If Table 6.1 has no line for f, both names mean the second model. {@code hifi-literal} is Eq
 * 6.1 as printed.
 */
public final class HiFiDetections {
  private static final String LITERAL = "hifi-literal";

  private HiFiDetections() {}

  /** Adds every model of the {@linkplain PublishedModels#published published catalogue}. */
  public static void register(Registry<DetectionModel> registry) {
    PublishedModels catalogue = PublishedModels.published();
    for (String detector : catalogue.detectors()) {
      PublishedModels.Line measured =
          catalogue.line(detector, PublishedModels.GROUND_TRUTH).orElseThrow();
      for (PublishedModels.Feature feature : catalogue.features()) {
        Optional<PublishedModels.Line> own = catalogue.line(detector, feature.name());
        String name = "hifi:" + detector + "-" + feature.name();
        register(registry, name, feature, own.orElse(measured));
        if (own.isPresent()) {
          register(registry, name + "-gt", feature, measured);
        } else {
          registry.alias(name + "-gt", name);
        }
      }
    }
    registry.register(
        LITERAL,
        "Eq 6.1 exactly as printed: the line on -log10(PIP), growing with distance",
        () -> literal(catalogue));
  }

  private static void register(
      Registry<DetectionModel> registry,
      String name,
      PublishedModels.Feature feature,
      PublishedModels.Line line) {
    String summary =
        Texts.format(
            "%s line (%s) on the %s (%s)",
            line.detector().toUpperCase(Locale.ROOT),
            line.source(),
            feature.title(),
            feature.provenance().source());
    registry.register(name, summary, () -> model(name, feature, line));
  }

  private static HiFiDetection model(
      String name, PublishedModels.Feature feature, PublishedModels.Line line) {
    PublishedModels catalogue = PublishedModels.published();
    Provenance provenance = feature.provenance().with("detector line", line.source());
    return new HiFiDetection(
        name,
        feature.f(),
        line.g(),
        catalogue.optics(),
        catalogue.threshold(line.g()),
        line.residuals(),
        Optional.of(catalogue.fitted()),
        provenance);
  }

  private static LiteralDetection literal(PublishedModels catalogue) {
    return new LiteralDetection(
        LITERAL, catalogue.literal(), catalogue.optics(), catalogue.reference().threshold());
  }
}
