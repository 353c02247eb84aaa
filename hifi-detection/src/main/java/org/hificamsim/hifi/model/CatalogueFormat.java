package org.hificamsim.hifi.model;

import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.json.JsonObject;

/** The JSON form of the {@link Catalogue}. */
final class CatalogueFormat {
  private CatalogueFormat() {}

  static Catalogue read(JsonObject json) {
    ModelFormat.checkSchema(json, "hificamsim-catalogue");
    Catalogue catalogue =
        new Catalogue(
            ModelFormat.optics(json.object("optics")),
            reference(json.object("reference")),
            literal(json.object("literal")),
            json.objects("features").stream().map(CatalogueFormat::feature).toList(),
            json.objects("lines").stream().map(CatalogueFormat::line).toList());
    json.rejectUnknown();
    return catalogue;
  }

  private static Catalogue.Reference reference(JsonObject json) {
    Catalogue.Reference reference =
        new Catalogue.Reference(json.text("detector"), json.text("f"), ModelFormat.threshold(json));
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

  private static Catalogue.Feature feature(JsonObject json) {
    Catalogue.Feature feature =
        new Catalogue.Feature(
            json.text("name"),
            json.text("title"),
            FeatureFormats.read(json.object("f")),
            ModelFormat.provenance(json));
    json.rejectUnknown();
    return feature;
  }

  private static Catalogue.Line line(JsonObject json) {
    Catalogue.Line line =
        new Catalogue.Line(
            json.text("detector"),
            json.text("f"),
            ModelFormat.detectorLine(json),
            json.text("source"));
    json.rejectUnknown();
    return line;
  }
}
