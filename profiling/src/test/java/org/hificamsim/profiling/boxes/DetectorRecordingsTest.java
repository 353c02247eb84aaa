package org.hificamsim.profiling.boxes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.LongPredicate;
import java.util.stream.Collectors;
import org.hificamsim.core.Reference;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.hifi.boxes.BoxDetection;
import org.hificamsim.profiling.check.Calibration;
import org.hificamsim.profiling.check.Calibration.Size;
import org.hificamsim.profiling.fit.Reliability;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests fits to two public recordings with boxes of a Faster R-CNN, which are not part of the
 * project.
 */
class DetectorRecordingsTest {
  private static final int HALF = 397;
  private static final BoxRecording.Reading READING =
      new BoxRecording.Reading(Optional.empty(), Optional.empty(), 0);

  @TempDir private Path folder;

  private Path detectors;

  @BeforeEach
  void findRecordings() {
    detectors = Reference.file("detectors");
  }

  private BoxRecording recording(String name) {
    return BoxRecording.read(
        detectors.resolve(name + ".gt.txt"), detectors.resolve(name + ".det.txt"), READING);
  }

  private Path part(String file, LongPredicate frames) throws IOException {
    String rows =
        Files.readAllLines(detectors.resolve(file)).stream()
            .filter(row -> frames.test(Long.parseLong(row.substring(0, row.indexOf(',')))))
            .collect(Collectors.joining("\n"));
    return Files.writeString(folder.resolve(file), rows);
  }

  private MeasuredBoxes pets(LongPredicate frames) throws IOException {
    Path labels = part("PETS09-S2L1.gt.txt", frames);
    Path boxes = part("PETS09-S2L1.det.txt", frames);
    return MeasuredBoxes.of(List.of(BoxRecording.read(labels, boxes, READING)), 0.5);
  }

  @Test
  void firstHalfPredictsSecond() throws IOException {
    BoxFit fit = BoxFit.of(pets(frame -> frame <= HALF));
    assertFalse(fit.rejected());
    Reliability second = ModelCheck.of(fit.curve(), pets(frame -> frame > HALF).boxes());
    assertEquals(second.all().detected(), second.all().expected(), 0.03);
    assertTrue(second.logLoss() <= 0.47, "log loss: " + second.logLoss());
  }

  @Test
  void bothRecordingsGiveOneModel() {
    MeasuredBoxes measured =
        MeasuredBoxes.of(
            List.of(recording("PETS09-S2L1"), recording("TUD-Stadtmitte")),
            MeasuredBoxes.USUAL_OVERLAP);
    assertEquals(4650 + 1156, measured.boxes().size());
    assertEquals(0.762, measured.recordings().get(0).found(), 0.001);
    assertEquals(0.771, measured.recordings().get(1).found(), 0.001);
    BoxFit fit = BoxFit.of(measured);
    assertFalse(fit.rejected());
    double logLoss = fit.modelReliability().logLoss();
    assertTrue(logLoss < fit.unseenPeople().get(FoundForm.HEIGHT).logLoss());
    assertTrue(logLoss < fit.unseenPeople().get(FoundForm.HIDDEN).logLoss());
    assertTrue(fit.curve().width().counts(), fit.width());
    assertTrue(
        fit.unseenRecordings().get(fit.form()).logLoss()
            < fit.unseenRecordings().get(FoundForm.CONSTANT).logLoss());
    List<String> table = new FoundTable(measured).lines();
    assertTrue(table.stream().anyMatch(line -> line.startsWith("5 to 25 % hidden")), "" + table);
  }

  @Test
  void simulatedCameraPredictsSecondHalf() throws IOException {
    BoxDetection model = BoxFit.of(pets(frame -> frame <= HALF)).detection("first");
    Calibration camera =
        Calibration.read(
            detectors.resolve("PETS09-view-001.xml"), Optional.empty(), Optional.empty());
    SimulatedRecording second =
        new SimulatedRecording(detectors, pets(frame -> frame > HALF), camera, new Size(0.5, 1.75));
    assertEquals(0, second.withoutPlace());
    ExpectedPeople expected = second.expected(byDefault(model));
    assertEquals(0, expected.reliability().all().error(), 0.05);
    assertTrue(expected.correlation() > 0.5, "correlation: " + expected.correlation());
    Detection inView = byDefault(new GeometricDetection());
    ExpectedPeople inPicture = second.expected(inView);
    assertEquals(1, inPicture.reliability().all().expected(), "all are in the picture");
    assertTrue(expected.reliability().logLoss() < inPicture.reliability().logLoss());
  }

  private static Detection byDefault(DetectionModel model) {
    return Detection.by(model.defaultRule(), model.name(), model);
  }
}
