package org.hificamsim.hifi.model;

import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.json.JsonObject;

/** The JSON form of the {@link PublishedModels}. */
final class PublishedModelsFormat {
  private PublishedModelsFormat() {}

  static PublishedModels read(JsonObject json) {
    ModelFormat.checkSchema(json, "hificamsim-catalogue");
    PublishedModels catalogue =
        new PublishedModels(
            ModelFormat.optics(json.object("optics")),
            reference(json.object("reference")),
            literal(json.object("literal")),
            json.objects("features").stream().map(PublishedModelsFormat::feature).toList(),
            json.objects("lines").stream().map(PublishedModelsFormat::line).toList());
    json.rejectUnknown();
    return catalogue;
  }

  private static PublishedModels.Reference reference(JsonObject json) {
    PublishedModels.Reference reference =
        new PublishedModels.Reference(
            json.text("detector"), json.text("f"), ModelFormat.threshold(json));
    ModelFormat.provenance(json);
    json.rejectUnknown();
    return reference;
  }

  private static LinearAbstraction literal(JsonObject json) {
    LinearAbstraction sum = FeatureFormats.linear(json);
    ModelFormat.provenance(json);
    json.rejectUnknown();
    return sum;
  }

  private static PublishedModels.Feature feature(JsonObject json) {
    PublishedModels.Feature feature =
        new PublishedModels.Feature(
            json.text("name"),
            json.text("title"),
            FeatureFormats.read(json.object("f")),
            ModelFormat.provenance(json));
    json.rejectUnknown();
    return feature;
  }

  private static PublishedModels.Line line(JsonObject json) {
    PublishedModels.Line line =
        new PublishedModels.Line(
            json.text("detector"),
            json.text("f"),
            ModelFormat.detectorLine(json),
            json.text("source"));
    json.rejectUnknown();
    return line;
  }
}
