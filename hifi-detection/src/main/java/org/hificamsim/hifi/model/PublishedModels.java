package org.hificamsim.hifi.model;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.file.Io;
import org.hificamsim.hifi.FittedOn;
import org.hificamsim.hifi.Provenance;
import org.hificamsim.hifi.Residuals;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.json.JsonFile;
import org.hificamsim.hifi.json.JsonObject;
import org.hificamsim.hifi.optics.Optics;

/**
 * The published models as data, each with the equation or table that it comes from.
 *
 * @param optics the lab's camera (thesis 3.5)
 * @param reference the line and threshold from which all default thresholds are derived
 * @param fitted the ranges of the data that all models were fitted to (Table 4.1)
 * @param literal the weights of Eq 6.1
 * @param features the feature abstractions f
 * @param lines the detector lines g
 */
public record PublishedModels(
    Optics optics,
    Reference reference,
    FittedOn fitted,
    LinearAbstraction literal,
    List<Feature> features,
    List<Line> lines) {
  /** The {@code f} of a line that was fitted on measured PIP, not on the predictions of an f. */
  public static final String GROUND_TRUTH = "ground-truth";

  private static final String RESOURCE = "catalogue.json";

  /** A feature abstraction with its short name and its title. */
  public record Feature(String name, String title, FeatureAbstraction f, Provenance provenance) {}

  /**
   * A detector line, its scatter, and the f whose PIP it was fitted on (or {@link #GROUND_TRUTH}).
   */
  public record Line(
      String detector, String f, DetectorLine g, Optional<Residuals> residuals, String source) {}

  /** The line to which the default threshold was fitted, and that threshold. */
  public record Reference(String detector, String f, double threshold) {}

  /** Returns the catalogue of this module, which is read once. */
  public static PublishedModels published() {
    return Published.CATALOGUE;
  }

  /** Returns the line of a detector on the PIP of {@code f}, if one was fitted. */
  public Optional<Line> line(String detector, String f) {
    return lines.stream()
        .filter(line -> line.detector().equals(detector) && line.f().equals(f))
        .findFirst();
  }

  /** Returns the names of the detectors, in the order of the catalogue. */
  public List<String> detectors() {
    return lines.stream().map(Line::detector).distinct().toList();
  }

  /**
   * Returns the default threshold of a model with this g: its confidence at the PIP at which the
   * reference line reaches the reference threshold. With these thresholds, models differ only by
   * their f and g.
   */
  public double threshold(DetectorModel g) {
    DetectorLine line = line(reference.detector(), reference.f()).orElseThrow().g();
    return g.equals(line) ? reference.threshold() : g.confidence(line.pip(reference.threshold()));
  }

  private static final class Published {
    static final PublishedModels CATALOGUE = read();

    private static PublishedModels read() {
      return JsonFile.parse(RESOURCE, Io.resource(PublishedModels.class, RESOURCE))
          .readWhole(PublishedModels::read);
    }
  }

  /** Reads a catalogue from JSON. */
  static PublishedModels read(JsonObject json) {
    ModelFormat.version(json, "hificamsim-catalogue", 1);
    return new PublishedModels(
        ModelFormat.optics(json),
        json.object("reference", PublishedModels::reference),
        json.object("fitted", PublishedModels::fitted),
        json.object("literal", PublishedModels::literal),
        json.objects("features").stream().map(f -> f.readWhole(PublishedModels::feature)).toList(),
        json.objects("lines").stream().map(g -> g.readWhole(PublishedModels::line)).toList());
  }

  private static Reference reference(JsonObject json) {
    ModelFormat.provenance(json);
    return new Reference(json.text("detector"), json.text("f"), ModelFormat.threshold(json));
  }

  private static FittedOn fitted(JsonObject json) {
    ModelFormat.provenance(json);
    return ModelFormat.fittedOn(json);
  }

  private static LinearAbstraction literal(JsonObject json) {
    ModelFormat.provenance(json);
    return FeatureFormats.linear(json);
  }

  private static Feature feature(JsonObject json) {
    return new Feature(
        json.text("name"),
        json.text("title"),
        json.object("f", FeatureFormats::read),
        ModelFormat.provenance(json));
  }

  private static Line line(JsonObject json) {
    return new Line(
        json.text("detector"),
        json.text("f"),
        DetectorFormats.line(json),
        ModelFormat.residuals(json),
        json.text("source"));
  }
}
