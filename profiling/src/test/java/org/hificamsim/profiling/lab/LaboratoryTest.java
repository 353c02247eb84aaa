package org.hificamsim.profiling.lab;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.hificamsim.profiling.SmallLab;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.DatasetReader;
import org.hificamsim.profiling.dataset.LabelledPhoto;
import org.hificamsim.profiling.opencv.Mats;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.opencv.core.Core;
import org.opencv.core.Mat;
import org.opencv.imgcodecs.Imgcodecs;

class LaboratoryTest {
  private static final List<Double> LENGTHS = List.of(0.015, 0.050);
  private static final List<Double> DISTANCES = List.of(1.0, 4.0);
  private static final LabSettings SMALL = SmallLab.settings(3, 0.05, LENGTHS, DISTANCES, 4);

  @TempDir Path folder;

  /** The small laboratory, rendered with one thread. */
  @TempDir static Path smallLab;

  private static final AtomicInteger PHOTOS = new AtomicInteger();

  @BeforeAll
  static void renderSmallLaboratory() {
    new Laboratory(SMALL).render(smallLab, 1, PHOTOS::incrementAndGet);
  }

  @Test
  void rendersTheSameOnAnyNumberOfThreads() throws IOException {
    new Laboratory(SMALL).render(folder, 3, () -> {});
    assertEquals(16, PHOTOS.get());
    List<Path> files = files(smallLab);
    assertEquals(files.size(), files(folder).size());
    for (Path file : files) {
      assertArrayEquals(
          Files.readAllBytes(smallLab.resolve(file)),
          Files.readAllBytes(folder.resolve(file)),
          file::toString);
    }
    assertTrue(files.size() >= 3 + 4 + 2 * 16 - 2, files.toString());
  }

  @Test
  void sizeIsTheRootOfWidthTimesHeight() {
    LabelledPhoto matchbox = read(smallLab).samples().get(0);
    assertEquals("matchbox", matchbox.object());
    assertEquals(Math.sqrt(0.10 * 0.09), matchbox.size(), 1e-12);
  }

  @Test
  void lightChangesTheBrightnessOfThePicture() {
    Dataset photos = rendered(bare(5, 0.05, List.of(0.050), List.of(3.0), 8, 0.3));
    List<Double> corners = photos.samples().stream().map(LaboratoryTest::corner).toList();
    // The corner shows the bare wall; display gamma is 2.2.
    double ratio = Collections.max(corners) / Collections.min(corners);
    assertTrue(ratio > 1.1, "ratio " + ratio);
    assertTrue(ratio < Math.pow((1 + 2.5 * 0.3) / (1 - 2.5 * 0.3), 1 / 2.2), "ratio " + ratio);
  }

  /** Returns settings without imperfections except lighting. */
  private static LabSettings bare(
      long seed,
      double scale,
      List<Double> lengths,
      List<Double> distances,
      int objects,
      double lighting) {
    return new LabSettings(
        seed,
        scale,
        lengths,
        distances,
        objects,
        new LabSettings.Optics(0, 0, 0, 0, 0),
        new LabSettings.Scene(0, 0, lighting, 0));
  }

  @Test
  void listsSourceAndLicenceOfEveryPhotograph() throws IOException {
    String sources =
        new String(
            LaboratoryTest.class.getResourceAsStream("photos/SOURCES.md").readAllBytes(),
            StandardCharsets.UTF_8);
    for (LabObject object : LabObject.ALL) {
      assertTrue(sources.contains("| " + object.photo() + ".jpg | "), object.photo());
    }
    try (Mats mats = new Mats();
        PhotoSurfaces photos = new PhotoSurfaces()) {
      for (int i = 0; i < 7; i++) {
        Mat thing = mats.own(photos.thingTexture(i, 64, new SplittableRandom(i)));
        assertEquals(64, thing.cols());
      }
    }
  }

  private static double corner(LabelledPhoto sample) {
    try (Mats mats = new Mats()) {
      String file = sample.file().toString();
      Mat picture = mats.own(Imgcodecs.imread(file, Imgcodecs.IMREAD_GRAYSCALE));
      return Core.mean(mats.own(picture.submat(0, 16, 0, 16))).val[0];
    }
  }

  @Test
  void otherSeedGivesOtherPhotos() throws IOException {
    LabSettings other = SmallLab.settings(4, 0.05, List.of(0.050), List.of(4.0), 1);
    LabSettings same = SmallLab.settings(3, 0.05, List.of(0.050), List.of(4.0), 1);
    new Laboratory(other).render(folder.resolve("other"), 1, () -> {});
    new Laboratory(same).render(folder.resolve("same"), 1, () -> {});
    Path image = Path.of("images", "matchbox-50mm-04.0m.jpg");
    assertFalse(
        java.util.Arrays.equals(
            Files.readAllBytes(folder.resolve("other").resolve(image)),
            Files.readAllBytes(folder.resolve("same").resolve(image))));
  }

  @Test
  void idealCameraMaskHasThePinholeArea() {
    Dataset dataset = rendered(bare(3, 0.25, LENGTHS, DISTANCES, 4, 0));
    int compared = 0;
    for (LabelledPhoto sample : dataset.samples()) {
      LabObject object =
          LabObject.ALL.stream()
              .filter(candidate -> candidate.name().equals(sample.object()))
              .findFirst()
              .get();
      double scale = sample.focalLength() / sample.distance();
      double area = object.size() * object.height() * (object.round() ? Math.PI / 4 : 1);
      double expected = scale * scale * area / (Sensor.WIDTH * Sensor.HEIGHT);
      double pixels = (double) dataset.camera().width() * dataset.camera().height();
      try (Mats mats = new Mats()) {
        String mask = sample.mask().get().toString();
        int set = Core.countNonZero(mats.own(Imgcodecs.imread(mask, Imgcodecs.IMREAD_GRAYSCALE)));
        double perimeter = 4 * Math.sqrt(expected * pixels);
        assertEquals(expected * pixels, set, perimeter / 2 + 2, sample.image());
        compared++;
      }
    }
    assertEquals(16, compared);
  }

  @Test
  void dropsAndCountsObjectsLargerThanTheFrame() throws IOException {
    LabSettings close = SmallLab.settings(0, 0.05, List.of(0.085), List.of(1.0), 8);
    Laboratory.PhotoCount outcome = new Laboratory(close).render(folder, 1, () -> {});
    // 85 mm at 1 m shows 0.176 m of height: three of the eight objects fit.
    assertEquals(new Laboratory.PhotoCount(3, 5), outcome);
    assertTrue(Files.readString(folder.resolve("lab.json")).contains("\"dropped\": 5"));
    assertEquals(4, Files.readAllLines(folder.resolve(Dataset.TABLE)).size());
  }

  @Test
  void writesADataSetWithoutProblems() {
    Dataset dataset = read(smallLab);
    assertEquals(4, dataset.templates().size());
    dataset.samples().forEach(sample -> assertTrue(sample.patch().area() > 0));
  }

  private Dataset rendered(LabSettings settings) {
    new Laboratory(settings).render(folder, 2, () -> {});
    return read(folder);
  }

  private static Dataset read(Path lab) {
    DatasetReader.Reading reading = DatasetReader.read(lab);
    assertEquals(List.of(), reading.problems());
    return reading.dataset().orElseThrow();
  }

  private static List<Path> files(Path root) throws IOException {
    try (Stream<Path> files = Files.walk(root)) {
      List<Path> names = new ArrayList<>();
      files.filter(Files::isRegularFile).sorted().forEach(f -> names.add(root.relativize(f)));
      return names;
    }
  }
}
