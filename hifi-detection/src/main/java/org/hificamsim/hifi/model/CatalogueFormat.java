package org.hificamsim.hifi.model;

import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.json.JsonObject;

/** The JSON form of the {@link Catalogue}. */
final class CatalogueFormat {
  private CatalogueFormat() {}

  static Catalogue read(JsonObject file) {
    return file.whole(CatalogueFormat::catalogue);
  }

  private static Catalogue catalogue(JsonObject json) {
    ModelFormat.checkSchema(json, "hificamsim-catalogue");
    return new Catalogue(
        ModelFormat.optics(json),
        json.object("reference").whole(CatalogueFormat::reference),
        json.object("literal").whole(CatalogueFormat::literal),
        json.objects("features").stream().map(f -> f.whole(CatalogueFormat::feature)).toList(),
        json.objects("lines").stream().map(g -> g.whole(CatalogueFormat::line)).toList());
  }

  private static Catalogue.Reference reference(JsonObject json) {
    ModelFormat.provenance(json);
    return new Catalogue.Reference(
        json.text("detector"), json.text("f"), ModelFormat.threshold(json));
  }

  private static LinearAbstraction literal(JsonObject json) {
    ModelFormat.provenance(json);
    return FeatureFormats.linear(json);
  }

  private static Catalogue.Feature feature(JsonObject json) {
    return new Catalogue.Feature(
        json.text("name"),
        json.text("title"),
        FeatureFormats.read(json.object("f")),
        ModelFormat.provenance(json));
  }

  private static Catalogue.Line line(JsonObject json) {
    return new Catalogue.Line(
        json.text("detector"), json.text("f"), ModelFormat.detectorLine(json), json.text("source"));
  }
}
