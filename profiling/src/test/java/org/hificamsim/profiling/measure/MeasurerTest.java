package org.hificamsim.profiling.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.SmallLab;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.LabelledPhoto;
import org.hificamsim.profiling.dataset.Photos;
import org.hificamsim.profiling.detector.RatioTest;
import org.hificamsim.profiling.measure.Measurer.MeasureProgress;
import org.hificamsim.profiling.measure.Measurer.MeasureSettings;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MeasurerTest {
  private static final List<String> ALL = List.of("orb", "sift", "surf");
  private static final MeasureSettings ORB =
      new MeasureSettings(List.of("orb"), RatioTest.THESIS, PipReading.SILHOUETTE, 0.01);
  private static final MeasureSettings PLAIN =
      new MeasureSettings(ALL, RatioTest.THESIS, PipReading.SILHOUETTE, 0.01);

  @TempDir static Path folder;
  private static Dataset dataset;

  /** A data set with a few photos of every object, for slow tests. */
  private static Dataset somePhotos;

  /** The table of these photos for all detectors, measured with one thread. */
  private static String measured;

  @BeforeAll
  static void measureSome() throws IOException {
    dataset = SmallLab.render(folder);
    List<LabelledPhoto> allPhotos = dataset.samples();
    somePhotos =
        with(
            IntStream.range(0, allPhotos.size())
                .filter(i -> i % 3 == 0)
                .mapToObj(allPhotos::get)
                .toList());
    new Measurer(somePhotos, PLAIN).measure(1, () -> {});
    measured = table();
  }

  private static Dataset with(List<LabelledPhoto> samples) {
    return new Dataset(folder, dataset.camera(), samples, dataset.templates(), List.of());
  }

  @Test
  void measuresTheSameOnAnyNumberOfThreads() throws IOException {
    new Measurer(somePhotos, PLAIN).measure(3, () -> {});
    assertEquals(measured, table());
    assertEquals(somePhotos.samples().size() + 1, measured.lines().count());
  }

  @Test
  void resumesKilledMeasurement() throws IOException {
    AtomicInteger seen = new AtomicInteger();
    assertThrows(
        IllegalStateException.class,
        () ->
            new Measurer(somePhotos, PLAIN)
                .measure(
                    1,
                    () -> {
                      if (seen.incrementAndGet() == 10) {
                        throw new IllegalStateException("killed");
                      }
                    }));
    Path partFile = partFile().orElseThrow();
    Files.writeString(partFile, Files.readString(partFile) + "images/half,a li");
    int resumed = new Measurer(somePhotos, PLAIN).measure(2, () -> {}).resumed();
    assertEquals(10, resumed);
    assertEquals(measured, table());
    assertTrue(partFile().isEmpty());
  }

  @Test
  void doesNotResumeWithOtherSettings() throws IOException {
    AtomicInteger seen = new AtomicInteger();
    assertThrows(
        IllegalStateException.class,
        () ->
            new Measurer(somePhotos, PLAIN)
                .measure(
                    1,
                    () -> {
                      if (seen.incrementAndGet() == 2) {
                        throw new IllegalStateException("killed");
                      }
                    }));
    assertEquals(0, new Measurer(somePhotos, ORB).measure(2, () -> {}).resumed());
    Files.delete(partFile().orElseThrow());
  }

  @Test
  void pipCountsTheMaskOrElseThePatch() {
    new Measurer(dataset, ORB).measure(2, () -> {});
    List<Measurement> masked = MeasurementsFile.read(folder.resolve(MeasurementsFile.NAME));
    List<LabelledPhoto> bare = dataset.samples().stream().map(MeasurerTest::unmasked).toList();
    new Measurer(with(bare), ORB).measure(2, () -> {});
    List<Measurement> patched = MeasurementsFile.read(folder.resolve(MeasurementsFile.NAME));
    double pixels = (double) dataset.camera().width() * dataset.camera().height();
    for (int i = 0; i < bare.size(); i++) {
      assertEquals(bare.get(i).patch().area() / pixels, patched.get(i).pip());
      assertTrue(masked.get(i).pip() <= patched.get(i).pip());
      assertTrue(masked.get(i).pip() > 0.4 * patched.get(i).pip());
    }
  }

  @Test
  void rectanglePipCountsThePatchInItsOwnColumn() throws IOException {
    MeasureSettings rectangles =
        new MeasureSettings(List.of("orb"), RatioTest.THESIS, PipReading.RECTANGLE, 0.01);
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
  void dataSetWithoutMasksHasRectanglePip(@TempDir Path other) throws IOException {
    String measured = "image,object,size_m,distance_m,focal_length_m,pip,orb\n";
    Files.writeString(other.resolve(MeasurementsFile.NAME), measured + "a,b,0.1,1,0.01,0.5,0.2\n");
    assertEquals(PipReading.SILHOUETTE, PipReading.ofDataset(other));
    Files.writeString(other.resolve("dataset.csv"), "image,mask\na.png,\n");
    assertEquals(PipReading.RECTANGLE, PipReading.ofDataset(other));
    Files.writeString(other.resolve("dataset.csv"), "image,mask\na.png,\nb.png,masks/b.png\n");
    assertEquals(PipReading.SILHOUETTE, PipReading.ofDataset(other));
  }

  @Test
  void drawsMatchesWithoutMeasuringAgain() throws IOException {
    String before = table();
    Path file = folder.resolve(MeasurementsFile.NAME);
    Files.writeString(file, "kept");
    String image = dataset.samples().get(0).image();
    assertEquals(1, new MatchPictures(dataset, ORB).draw(List.of(image)));
    Path picture = folder.resolve("matches/orb-images_matchbox-10mm-01.0m.jpg");
    assertTrue(Files.exists(picture), picture.toString());
    assertEquals("kept", table());
    Files.writeString(file, before);
  }

  @Test
  void reportsResumedPhotosOnceAndFirst() {
    List<String> events = new ArrayList<>();
    MeasureProgress watcher =
        new MeasureProgress() {
          @Override
          public void advance() {
            events.add("one");
            if (events.size() == 6) {
              throw new IllegalStateException("killed");
            }
          }

          @Override
          public void resume(long photos) {
            events.add("resumed " + photos);
          }
        };
    Measurer measurer = new Measurer(dataset, ORB);
    assertThrows(IllegalStateException.class, () -> measurer.measure(1, watcher));
    events.clear();
    events.addAll(Collections.nCopies(10, "earlier"));
    measurer.measure(1, watcher);
    assertEquals("resumed 5", events.get(10));
    assertEquals(dataset.samples().size() - 5, events.size() - 11);
  }

  @Test
  void warnsOfTemplateWithoutFeatures() throws IOException {
    Path blank = folder.resolve("blank.png");
    Photos.write(blank, 60, 60);
    Map<String, Path> templates = new LinkedHashMap<>(dataset.templates());
    templates.put("matchbox", blank);
    Dataset plain = new Dataset(folder, dataset.camera(), dataset.samples(), templates, List.of());
    List<String> warnings = new Measurer(plain, ORB).measure(2, () -> {}).warnings();
    assertEquals(1, warnings.size(), warnings.toString());
    assertTrue(warnings.get(0).startsWith(blank + ": orb finds no feature"), warnings.get(0));
    Measurement row = MeasurementsFile.read(folder.resolve(MeasurementsFile.NAME)).get(0);
    assertEquals(0, row.confidence("orb"));
  }

  @ParameterizedTest
  @CsvSource({"100, 100 times smaller", "0.01, 100 times larger"})
  void warnsOfWrongUnitOfAllPhotosInOneLine(double factor, String words) {
    List<LabelledPhoto> wrong = dataset.samples().stream().map(s -> scaled(s, factor)).toList();
    List<String> warnings = measured(wrong).warnings();
    assertEquals(1, warnings.size(), warnings.toString());
    assertTrue(warnings.get(0).contains("photos show their object"), warnings.get(0));
    assertTrue(
        warnings.get(0).matches(".*\\b(9\\d|1\\d\\d)(\\.\\d)? times " + words.substring(10) + ".*"),
        warnings.get(0));
  }

  @Test
  void warnsOfWrongUnitOfOnePhotoByName() {
    List<LabelledPhoto> wrong = new ArrayList<>(dataset.samples());
    wrong.set(3, scaled(wrong.get(3), 100));
    List<String> warnings = measured(wrong).warnings();
    assertEquals(1, warnings.size(), warnings.toString());
    assertTrue(warnings.get(0).contains(wrong.get(3).image()), warnings.get(0));
    assertEquals(List.of(), measured(dataset.samples()).warnings());
  }

  @Test
  void rejectsTruncatedPictureByName() throws IOException {
    Path cut = folder.resolve("images/cut.jpg");
    byte[] whole = Files.readAllBytes(dataset.samples().get(0).file());
    byte[] half = Arrays.copyOf(whole, whole.length / 2);
    half[half.length - 2] = (byte) 0xFF;
    half[half.length - 1] = (byte) 0xD9;
    Files.write(cut, half);
    LabelledPhoto first = dataset.samples().get(0);
    LabelledPhoto sample =
        new LabelledPhoto(
            "images/cut.jpg",
            cut,
            first.object(),
            first.size(),
            first.distance(),
            first.focalLength(),
            first.patch(),
            first.mask());
    String message =
        assertThrows(InputException.class, () -> measured(List.of(sample))).getMessage();
    assertTrue(message.startsWith(cut + ": the picture is damaged"), message);
  }

  private static LabelledPhoto unmasked(LabelledPhoto photo) {
    return new LabelledPhoto(
        photo.image(),
        photo.file(),
        photo.object(),
        photo.size(),
        photo.distance(),
        photo.focalLength(),
        photo.patch(),
        Optional.empty());
  }

  private static LabelledPhoto scaled(LabelledPhoto sample, double factor) {
    return new LabelledPhoto(
        sample.image(),
        sample.file(),
        sample.object(),
        sample.size() * factor,
        sample.distance(),
        sample.focalLength(),
        sample.patch(),
        sample.mask());
  }

  private static Measurer.Outcome measured(List<LabelledPhoto> samples) {
    return new Measurer(with(samples), ORB).measure(2, () -> {});
  }

  @Test
  void reportsInvalidMeasurementsWithTheirPlace() throws IOException {
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

  @Test
  void ignoresConditionColumnsOfOlderTables() throws IOException {
    Path file = folder.resolve("older.csv");
    Files.writeString(
        file,
        "image,object,size_m,distance_m,focal_length_m,pip,distinctiveness,aperture,distortion,"
            + "light,orb\n"
            + "a,b,0.1,1,0.01,0.5,0.7,f/8,,,0.2\n");
    assertEquals(Map.of("orb", 0.2), MeasurementsFile.read(file).get(0).confidences());
  }

  private static String table() throws IOException {
    return Files.readString(folder.resolve(MeasurementsFile.NAME));
  }

  private static Optional<Path> partFile() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .filter(f -> f.getFileName().toString().matches("\\.measurements-.*\\.part"))
          .findFirst();
    }
  }
}
