package org.hificamsim.hifi.model;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.Provenance;
import org.hificamsim.hifi.Residuals;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.optics.Optics;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ModelFilesTest {
  private static final String SHORTEST =
      """
      {
        "schema": "hificamsim-model",
        "version": 1,
        "name": "mine",
        "f": {"type": "linear", "z": -20, "q": -2, "d": 0.25, "intercept": 2.5},
        "g": {"slope": 0.5, "intercept": 0.03}
      }
      """;

  @TempDir Path folder;

  @Test
  void optionalPropertiesHaveDefaults() throws IOException {
    HiFiDetection model =
        (HiFiDetection) ModelFiles.read(Files.writeString(folder.resolve("m.json"), SHORTEST));
    assertEquals("mine", model.name());
    assertEquals(new LinearAbstraction(-20, -2, 0.25, 2.5), model.f());
    assertEquals(new DetectorLine(0.5, 0.03), model.g());
    assertEquals(new Optics(0.0224, 0.085), model.optics());
    assertEquals(0.5 * (0.0441 - 0.026) / 0.571 + 0.03, model.defaultThreshold(), 1e-17);
    assertEquals(Provenance.UNKNOWN, model.provenance());
  }

  @Test
  void publishedModelsSurviveWritingAndReading() throws IOException {
    int compared = 0;
    for (String name : Features.registered()) {
      if (Features.registry().create(name) instanceof HiFiDetection model) {
        assertRoundTrip(model);
        compared++;
      }
    }
    assertEquals(21, compared);
  }

  @Test
  void rewritingAFileKeepsItsBytes() throws IOException {
    Path first = folder.resolve("first.json");
    Path second = folder.resolve("second.json");
    ModelFiles.write(ModelFiles.read(Files.writeString(folder.resolve("m.json"), SHORTEST)), first);
    ModelFiles.write(ModelFiles.read(first), second);
    assertArrayEquals(Files.readAllBytes(first), Files.readAllBytes(second));
  }

  @Test
  void writesNumbersAndRemarksExactly() throws IOException {
    double third = 1.0 / 3;
    assertRoundTrip(
        new HiFiDetection(
            "hifi:orb_v2.1-x",
            new LinearAbstraction(-0.0, Double.MIN_VALUE, Math.nextUp(third), -999999.9999999999),
            new DetectorLine(Math.PI, -third),
            new Optics(0.1 + 0.2, Math.nextDown(0.085)),
            Math.nextUp(0.0441),
            Optional.empty(),
            Optional.empty(),
            new Provenance(
                Map.of("quotes \" and \\", "line\nbreak, tab\t, é, 狐, \uD83E\uDD8A, \u0000"))));
  }

  @Test
  void scatterSurvivesWritingAndReading() throws IOException {
    HiFiDetection without = named("m", new LinearAbstraction(1, 2, 3, 4));
    assertRoundTrip(without);
    assertRoundTrip(
        new HiFiDetection(
            "m",
            without.f(),
            without.g(),
            without.optics(),
            0.05,
            Optional.of(Residuals.of(1.0 / 3)),
            Optional.empty(),
            without.provenance()));
  }

  @Test
  void remarksKeepTheirOrder() throws IOException {
    Path file = folder.resolve("m.json");
    ModelFiles.write(named("m", new LinearAbstraction(1, 2, 3, 4)), file);
    assertEquals(
        List.of("zebra", "ant", "monkey"),
        List.copyOf(((HiFiDetection) ModelFiles.read(file)).provenance().remarks().keySet()));
  }

  @Test
  void writesEachPropertyOnItsOwnLine() throws IOException {
    Path file = folder.resolve("m.json");
    ModelFiles.write(named("m", new LinearAbstraction(-20, -2, 0.25, 2.5)), file);
    List<String> lines = Files.readAllLines(file);
    assertTrue(lines.contains("  \"name\": \"m\","), lines.toString());
    assertTrue(lines.contains("    \"z\": -20.0,"), lines.toString());
  }

  @Test
  void replacesOlderFileAndLeavesNoOthers() throws IOException {
    Path file = Files.writeString(folder.resolve("m.json"), "older");
    ModelFiles.write(named("m", new LinearAbstraction(1, 2, 3, 4)), file);
    assertEquals("m", ModelFiles.read(file).name());
    assertEquals(List.of("m.json"), names());
  }

  @Test
  void readersNeverSeeAPartlyWrittenFile() throws Exception {
    Path file = folder.resolve("m.json");
    HiFiDetection model = named("m", new LinearAbstraction(1, 2, 3, 4));
    ModelFiles.write(model, file);
    AtomicBoolean done = new AtomicBoolean();
    CompletableFuture<Integer> reader =
        CompletableFuture.supplyAsync(
            () -> {
              int read = 0;
              for (; !done.get() || read == 0; read++) {
                assertEquals(model, ModelFiles.read(file));
              }
              return read;
            });
    for (int i = 0; i < 100 && !reader.isDone(); i++) {
      ModelFiles.write(model, file);
    }
    done.set(true);
    assertTrue(reader.get(10, TimeUnit.SECONDS) > 0);
  }

  @Test
  void rejectedModelLeavesTheOlderFile() throws IOException {
    Path file = Files.writeString(folder.resolve("m.json"), "older");
    LinearAbstraction fine = new LinearAbstraction(1, 2, 3, 4);
    for (HiFiDetection model :
        List.of(
            named("m", new LinearAbstraction(Double.NaN, 2, 3, 4)),
            named("m", new LinearAbstraction(1e300, 2, 3, 4)),
            named("two words", fine),
            named("", fine),
            named("m", (q, d, z) -> 1))) {
      assertThrows(IllegalArgumentException.class, () -> ModelFiles.write(model, file));
    }
    assertEquals("older", Files.readString(file));
    assertEquals(List.of("m.json"), names());
  }

  @Test
  void reportsUnreadableAndUnwritableFilesInOneLine() {
    Path missing = folder.resolve("no/such.json");
    HiFiDetection model = named("m", new LinearAbstraction(1, 2, 3, 4));
    for (InputException e :
        List.of(
            assertThrows(InputException.class, () -> ModelFiles.read(missing)),
            assertThrows(InputException.class, () -> ModelFiles.read(folder)),
            assertThrows(InputException.class, () -> ModelFiles.write(model, missing)))) {
      assertTrue(e.getMessage().startsWith(folder.toString()), e.getMessage());
      assertTrue(e.getMessage().contains("expected"), e.getMessage());
      assertEquals(1, e.getMessage().lines().count());
    }
  }

  private void assertRoundTrip(HiFiDetection model) throws IOException {
    Path file = folder.resolve("round-trip.json");
    ModelFiles.write(model, file);
    assertEquals(model, ModelFiles.read(file));
  }

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }

  private static HiFiDetection named(String name, FeatureAbstraction f) {
    Provenance remarks = Provenance.UNKNOWN.with("zebra", "1").with("ant", "2").with("monkey", "3");
    return new HiFiDetection(
        name,
        f,
        new DetectorLine(0.5, 0.03),
        new Optics(0.0224, 0.085),
        0.05,
        Optional.empty(),
        Optional.empty(),
        remarks);
  }
}
