package org.hificamsim.profiling.lab;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.DatasetReader;
import org.hificamsim.profiling.dataset.DatasetReading;
import org.hificamsim.profiling.dataset.Sample;
import org.hificamsim.profiling.opencv.Mats;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.opencv.core.Core;
import org.opencv.imgcodecs.Imgcodecs;

class LaboratoryTest {
  private static final LabSettings SMALL =
      LabSettings.thesis(3).withScale(0.05).withGrid(List.of(0.015, 0.050), List.of(1.0, 4.0), 4);

  /** No imperfection at all. */
  private static final LabSettings IDEAL =
      SMALL
          .withScale(0.25)
          .with(new LabSettings.Optics(0, 0, 0, 0, 0), new LabSettings.Scene(0, 0, 0, 0));

  @TempDir Path folder;

  @Test
  void isTheSameOnAnyNumberOfThreads() throws IOException {
    Path one = folder.resolve("one");
    Path three = folder.resolve("three");
    AtomicInteger photos = new AtomicInteger();
    new Laboratory(SMALL).render(one, 1, photos::incrementAndGet);
    new Laboratory(SMALL).render(three, 3, () -> {});
    assertEquals(16, photos.get());
    List<Path> files = files(one);
    assertEquals(files.size(), files(three).size());
    for (Path file : files) {
      assertArrayEquals(
          Files.readAllBytes(one.resolve(file)),
          Files.readAllBytes(three.resolve(file)),
          file::toString);
    }
    assertTrue(files.size() >= 3 + 4 + 2 * 16 - 2, files.toString());
  }

  @Test
  void anotherSeedGivesOtherPhotos() throws IOException {
    LabSettings other =
        LabSettings.thesis(4).withScale(0.05).withGrid(List.of(0.050), List.of(4.0), 1);
    LabSettings same =
        LabSettings.thesis(3).withScale(0.05).withGrid(List.of(0.050), List.of(4.0), 1);
    new Laboratory(other).render(folder.resolve("other"), 1, () -> {});
    new Laboratory(same).render(folder.resolve("same"), 1, () -> {});
    Path image = Path.of("images", "matchbox-50mm-04.0m.jpg");
    assertFalse(
        java.util.Arrays.equals(
            Files.readAllBytes(folder.resolve("other").resolve(image)),
            Files.readAllBytes(folder.resolve("same").resolve(image))));
  }

  @Test
  void idealCamerasMaskIsThePinholesArea() {
    Dataset dataset = rendered(IDEAL);
    int compared = 0;
    for (Sample sample : dataset.samples()) {
      LabObject object =
          LabObject.ALL.stream().filter(o -> o.name().equals(sample.object())).findFirst().get();
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
  void objectsLargerThanTheFrameAreDroppedAndCounted() throws IOException {
    LabSettings close =
        LabSettings.thesis(0).withScale(0.05).withGrid(List.of(0.085), List.of(1.0), 8);
    Laboratory.Outcome outcome = new Laboratory(close).render(folder, 1, () -> {});
    // 85 mm at 1 m shows 0.176 m of height: three of the eight objects fit.
    assertEquals(new Laboratory.Outcome(3, 5), outcome);
    assertTrue(Files.readString(folder.resolve("lab.json")).contains("\"dropped\": 5"));
    assertEquals(4, Files.readAllLines(folder.resolve(Dataset.TABLE)).size());
  }

  @Test
  void writesADataSetWithoutProblems() {
    Dataset dataset = rendered(SMALL);
    assertEquals(4, dataset.templates().size());
    dataset.samples().forEach(sample -> assertTrue(sample.patch().area() > 0));
  }

  private Dataset rendered(LabSettings settings) {
    new Laboratory(settings).render(folder, 2, () -> {});
    DatasetReading reading = DatasetReader.read(folder);
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
