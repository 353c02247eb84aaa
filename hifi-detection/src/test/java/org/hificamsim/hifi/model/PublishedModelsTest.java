package org.hificamsim.hifi.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.feature.Expression;
import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.feature.LogPipAbstraction;
import org.hificamsim.hifi.json.JsonFile;
import org.hificamsim.hifi.optics.Optics;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PublishedModelsTest {
  private static final PublishedModels CATALOGUE = PublishedModels.published();

  @Test
  void readsTheCatalogueOnce() {
    assertSame(CATALOGUE, PublishedModels.published());
  }

  @Test
  void holdsTheCameraOfTheLab() {
    assertEquals(new Optics(0.0224, 0.085), CATALOGUE.optics());
  }

  @ParameterizedTest
  @CsvSource({
    // Worked by hand: -18.82*0.05 - 2*0.3 + 0.2*4 + 2.47
    "lin, 0.3, 4, 0.05, 1.729",
    // (0.05-0.51) * (-(0.1-0.51)*(-4-0.51) - 0.36/0.3) = -0.46 * (-1.8491 - 1.2)
    "sr, 0.3, 4, 0.05, 1.402586",
    // -6.74*0.05 - 2.04*0.3 + 0.2*4 + 1.88
    "svr-lin, 0.3, 4, 0.05, 1.731",
    "lin, 0.66, 1, 0.085, -0.2497",
    "lin, 0.10, 10, 0.010, 4.0818",
  })
  void regressionsEqualTheirEquations(String f, double q, double d, double z, double value) {
    assertEquals(
        value, ((LogPipAbstraction) Features.abstraction(f)).negativeLogPip(q, d, z), 1e-12);
  }

  @ParameterizedTest
  @CsvSource({"orb, 0.60, 0.02", "sift, 0.75, 0.10", "surf, 0.73, 0.05"})
  void groundTruthLinesEqualEquations52To54(String detector, double slope, double intercept) {
    assertEquals(
        new DetectorLine(slope, intercept),
        CATALOGUE.line(detector, PublishedModels.GROUND_TRUTH).orElseThrow().g());
  }

  @Test
  void groundTruthLinesEqualThePublishedTable() throws IOException {
    List<Map<String, String>> rows = Published.rows("detector-ground-truth-pip.csv");
    assertEquals(3, rows.size());
    rows.forEach(row -> assertLine(row, row.get("detector"), PublishedModels.GROUND_TRUTH));
  }

  @Test
  void reportsCatalogueErrorsWithLineAndColumn() throws IOException {
    String text = catalogue();
    assertEquals(CATALOGUE, read(text));
    InputException error =
        assertThrows(InputException.class, () -> read(text.replaceFirst("slope", "slop")));
    assertTrue(
        error.getMessage().matches("c:\\d+:\\d+: property 'slope' is missing, .*"), "" + error);
  }

  private static String catalogue() throws IOException {
    try (InputStream in = PublishedModels.class.getResourceAsStream("catalogue.json")) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private static PublishedModels read(String text) {
    return JsonFile.parse("c", text.getBytes(StandardCharsets.UTF_8))
        .readWhole(PublishedModels::read);
  }

  @Test
  void fittedLinesEqualTable61() throws IOException {
    List<Map<String, String>> rows = Published.rows("table-6.1.csv");
    assertEquals(CATALOGUE.lines().size(), rows.size() + 3);
    rows.forEach(row -> assertLine(row, row.get("detector"), Published.name(row.get("f"))));
  }

  @Test
  void regressionsEqualThePublishedFormulas() throws IOException {
    int compared = 0;
    for (Map<String, String> row : Published.rows("feature-abstraction.csv")) {
      if (row.get("closed_form").equals("yes")) {
        assertSameValues(
            Expression.parse(row.get("equation")),
            (LogPipAbstraction) Features.abstraction(Published.name(row.get("id"))));
        compared++;
      }
    }
    assertEquals(3, compared);
  }

  @Test
  void literalModelIsTheReferenceLineOnTheResponse() {
    LinearAbstraction lin = (LinearAbstraction) Features.abstraction("lin");
    DetectorLine orb = CATALOGUE.line("orb", "lin").orElseThrow().g();
    LinearAbstraction literal = CATALOGUE.literal();
    assertEquals(orb.slope() * lin.z(), literal.z(), 0.0075);
    assertEquals(orb.slope() * lin.q(), literal.q(), 0.005);
    assertEquals(orb.slope() * lin.d(), literal.d(), 0.005);
    assertEquals(orb.confidence(lin.intercept()), literal.intercept(), 0.0075);
  }

  @Test
  void everyFeatureAndLineNamesItsSource() {
    CATALOGUE.features().forEach(f -> assertFalse(f.provenance().source().isEmpty(), f.name()));
    CATALOGUE.lines().forEach(line -> assertFalse(line.source().isEmpty(), line.toString()));
  }

  @Test
  void provenanceOfPowerLawSaysNotMeasured() {
    Map<String, String> remarks = Features.feature("power").provenance().remarks();
    assertTrue(remarks.get("source").contains("not measured"));
    assertEquals("profile fit", remarks.get("replaced by"));
  }

  @Test
  void thresholdsAreConfidencesAtTheReferencePip() {
    double pip = (0.0441 - 0.026) / 0.571;
    assertEquals(0.0441, CATALOGUE.threshold(new DetectorLine(0.571, 0.026)));
    for (PublishedModels.Line line : CATALOGUE.lines()) {
      DetectorLine g = line.g();
      assertEquals(g.slope() * pip + g.intercept(), CATALOGUE.threshold(g), 1e-17);
    }
  }

  private static void assertLine(Map<String, String> row, String detector, String f) {
    assertEquals(
        new DetectorLine(
            Double.parseDouble(row.get("slope")), Double.parseDouble(row.get("intercept"))),
        CATALOGUE.line(detector, f).orElseThrow().g());
  }

  private static void assertSameValues(Expression published, LogPipAbstraction shipped) {
    for (double z : new double[] {0.010, 0.024, 0.085}) {
      for (double q : new double[] {0.10, 0.31, 0.66}) {
        for (double d : new double[] {1, 5.07, 10}) {
          assertEquals(published.value(q, d, z), shipped.negativeLogPip(q, d, z), 1e-12);
        }
      }
    }
  }
}
