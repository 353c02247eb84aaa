package org.hificamsim.hifi.model;

import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.json.JsonObject;

/** The JSON form of the {@link PublishedModels}. */
final class PublishedModelsFormat {
  private PublishedModelsFormat() {}

  static PublishedModels read(JsonObject file) {
    return file.whole(PublishedModelsFormat::catalogue);
  }

  private static PublishedModels catalogue(JsonObject json) {
    ModelFormat.version(json, "hificamsim-catalogue", 1);
    return new PublishedModels(
        ModelFormat.optics(json),
        json.object("reference").whole(PublishedModelsFormat::reference),
        json.object("literal").whole(PublishedModelsFormat::literal),
        json.objects("features").stream()
            .map(f -> f.whole(PublishedModelsFormat::feature))
            .toList(),
        json.objects("lines").stream().map(g -> g.whole(PublishedModelsFormat::line)).toList());
  }

  private static PublishedModels.Reference reference(JsonObject json) {
    ModelFormat.provenance(json);
    return new PublishedModels.Reference(
        json.text("detector"), json.text("f"), ModelFormat.threshold(json));
  }

  private static LinearAbstraction literal(JsonObject json) {
    ModelFormat.provenance(json);
    return FeatureFormats.linear(json);
  }

  private static PublishedModels.Feature feature(JsonObject json) {
    return new PublishedModels.Feature(
        json.text("name"),
        json.text("title"),
        FeatureFormats.read(json.object("f")),
        ModelFormat.provenance(json));
  }

  private static PublishedModels.Line line(JsonObject json) {
    return new PublishedModels.Line(
        json.text("detector"),
        json.text("f"),
        DetectorFormats.line(json),
        ModelFormat.rmse(json),
        json.text("source"));
  }
}
