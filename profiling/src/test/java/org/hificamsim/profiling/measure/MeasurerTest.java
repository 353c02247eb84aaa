package org.hificamsim.profiling.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.SmallLab;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.Sample;
import org.hificamsim.profiling.detector.RatioTest;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MeasurerTest {
  private static final List<String> ALL = List.of("orb", "sift", "surf");
  private static final MeasureSettings PLAIN =
      new MeasureSettings(ALL, RatioTest.THESIS, PipReading.SILHOUETTE, Set.of());

  @TempDir static Path folder;
  private static Dataset dataset;

  @BeforeAll
  static void render() {
    dataset = SmallLab.render(folder);
  }

  @Test
  void givesTheSameOnAnyNumberOfThreads() throws IOException {
    new Measurer(dataset, PLAIN).measure(1, () -> {});
    String one = table();
    new Measurer(dataset, PLAIN).measure(3, () -> {});
    assertEquals(one, table());
    assertEquals(dataset.samples().size() + 1, one.lines().count());
  }

  @Test
  void goesOnWhereAKilledCallStopped() throws IOException {
    new Measurer(dataset, PLAIN).measure(2, () -> {});
    String whole = table();
    AtomicInteger seen = new AtomicInteger();
    assertThrows(
        IllegalStateException.class,
        () ->
            new Measurer(dataset, PLAIN)
                .measure(
                    1,
                    () -> {
                      if (seen.incrementAndGet() == 10) {
                        throw new IllegalStateException("killed");
                      }
                    }));
    Path part = part().orElseThrow();
    Files.writeString(part, Files.readString(part) + "images/half,a li");
    int resumed = new Measurer(dataset, PLAIN).measure(2, () -> {});
    assertEquals(10, resumed);
    assertEquals(whole, table());
    assertTrue(part().isEmpty());
  }

  @Test
  void otherSettingsDoNotResumeIt() throws IOException {
    AtomicInteger seen = new AtomicInteger();
    MeasureSettings orb =
        new MeasureSettings(List.of("orb"), RatioTest.THESIS, PipReading.SILHOUETTE, Set.of());
    assertThrows(
        IllegalStateException.class,
        () ->
            new Measurer(dataset, PLAIN)
                .measure(
                    1,
                    () -> {
                      if (seen.incrementAndGet() == 2) {
                        throw new IllegalStateException("killed");
                      }
                    }));
    assertEquals(0, new Measurer(dataset, orb).measure(2, () -> {}));
    Files.delete(part().orElseThrow());
  }

  @Test
  void pipIsTheMasksShareAndElseThePatchs() {
    new Measurer(dataset, PLAIN).measure(2, () -> {});
    List<Measurement> masked = MeasurementsFile.read(folder.resolve(MeasurementsFile.NAME));
    List<Sample> bare =
        dataset.samples().stream()
            .map(
                s ->
                    new Sample(
                        s.image(),
                        s.file(),
                        s.object(),
                        s.size(),
                        s.distance(),
                        s.focalLength(),
                        s.patch(),
                        Optional.empty()))
            .toList();
    Dataset unmasked = new Dataset(folder, dataset.camera(), bare, dataset.templates());
    MeasureSettings orb =
        new MeasureSettings(List.of("orb"), RatioTest.THESIS, PipReading.SILHOUETTE, Set.of());
    new Measurer(unmasked, orb).measure(2, () -> {});
    List<Measurement> patched = MeasurementsFile.read(folder.resolve(MeasurementsFile.NAME));
    double pixels = (double) dataset.camera().width() * dataset.camera().height();
    for (int i = 0; i < bare.size(); i++) {
      assertEquals(bare.get(i).patch().area() / pixels, patched.get(i).pip());
      assertTrue(masked.get(i).pip() <= patched.get(i).pip());
      assertTrue(masked.get(i).pip() > 0.4 * patched.get(i).pip());
    }
  }

  @Test
  void pipOfRectanglesIsThePatchsShareAndSaysSoInTheTable() throws IOException {
    MeasureSettings rectangles =
        new MeasureSettings(List.of("orb"), RatioTest.THESIS, PipReading.RECTANGLE, Set.of());
    new Measurer(dataset, rectangles).measure(2, () -> {});
    assertTrue(
        table().startsWith("image,object,size_m,distance_m,focal_length_m,pip_rectangle,orb\n"));
    assertEquals(PipReading.RECTANGLE, PipReading.ofDataset(folder));
    double pixels = (double) dataset.camera().width() * dataset.camera().height();
    List<Measurement> rows = MeasurementsFile.read(folder.resolve(MeasurementsFile.NAME));
    for (int i = 0; i < rows.size(); i++) {
      assertEquals(dataset.samples().get(i).patch().area() / pixels, rows.get(i).pip());
      assertEquals(List.of("orb"), List.copyOf(rows.get(i).confidences().keySet()));
    }
  }

  @Test
  void aDataSetWithoutMasksHasRectanglesWhateverItsColumnIsCalled(@TempDir Path other)
      throws IOException {
    String measured = "image,object,size_m,distance_m,focal_length_m,pip,orb\n";
    Files.writeString(other.resolve(MeasurementsFile.NAME), measured + "a,b,0.1,1,0.01,0.5,0.2\n");
    assertEquals(PipReading.SILHOUETTE, PipReading.ofDataset(other));
    Files.writeString(other.resolve("dataset.csv"), "image,mask\na.png,\n");
    assertEquals(PipReading.RECTANGLE, PipReading.ofDataset(other));
    Files.writeString(other.resolve("dataset.csv"), "image,mask\na.png,\nb.png,masks/b.png\n");
    assertEquals(PipReading.SILHOUETTE, PipReading.ofDataset(other));
  }

  @Test
  void drawsMatchesOnRequest() {
    String image = dataset.samples().get(0).image();
    new Measurer(
            dataset,
            new MeasureSettings(
                List.of("orb"), RatioTest.THESIS, PipReading.SILHOUETTE, Set.of(image)))
        .measure(2, () -> {});
    Path picture = folder.resolve("matches/orb-images_matchbox-10mm-01.0m.jpg");
    assertTrue(Files.exists(picture), picture.toString());
  }

  @Test
  void measurementsThatAreNoneAreToldWithTheirPlace() throws IOException {
    Path file = folder.resolve("broken.csv");
    Files.writeString(
        file,
        "image,object,size_m,distance_m,focal_length_m,pip,orb\n"
            + "a,b,0.1,1,0.01,0.5,0.2\n"
            + "a,b,0.1,1,0.01,2,0.2\n");
    String message =
        assertThrows(InputException.class, () -> MeasurementsFile.read(file)).getMessage();
    assertTrue(message.startsWith(file + ":3:"), message);
    assertTrue(message.contains("pip is '2', expected a share above 0"), message);
  }

  private static String table() throws IOException {
    return Files.readString(folder.resolve(MeasurementsFile.NAME));
  }

  private static Optional<Path> part() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .filter(f -> f.getFileName().toString().matches("\\.measurements-.*\\.part"))
          .findFirst();
    }
  }
}
