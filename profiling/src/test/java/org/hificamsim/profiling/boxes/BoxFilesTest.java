package org.hificamsim.profiling.boxes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.check.Calibration.Size;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests each format with the same recording, and with broken files. */
class BoxFilesTest {
  private static final String COCO =
      """
      {"info": {"year": 2026}, "images": [
        {"id": 1, "width": 200, "height": 100, "file_name": "1.jpg"},
        {"id": 2, "width": 200, "height": 100, "file_name": "2.jpg"}],
       "categories": [{"id": 3, "name": "dog"}, {"id": 7, "name": "person"}],
       "annotations": [
        {"id": 1, "image_id": 1, "category_id": 7, "bbox": [10, 20, 20, 40], "track_id": 5},
        {"id": 2, "image_id": 1, "category_id": 3, "bbox": [50, 20, 20, 40]},
        {"id": 3, "image_id": 2, "category_id": 7, "bbox": [12, 20, 20, 40], "track_id": 5,
         "attributes": null, "segmentation": [[1, 2]]}]}
      """;
  private static final String RESULTS =
      """
      [{"image_id": 1, "category_id": 7, "bbox": [11, 20, 20, 40], "score": 0.9},
       {"image_id": 1, "category_id": 3, "bbox": [50, 20, 20, 40], "score": 0.9},
       {"image_id": 2, "category_id": 7, "bbox": [100, 20, 20, 40], "score": 0.8}]
      """;
  private static final String MOT = "1,5,10,20,20,40,1,-1,-1,-1\n2,5,12,20,20,40,1,-1,-1,-1\n";
  private static final String MOT_BOXES =
      "1,-1,11,20,20,40,0.9,-1,-1,-1\n2,-1,100,20,20,40,0.8,-1,-1,-1\n";

  @TempDir private Path folder;

  private Path file(String name, String content) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, content);
  }

  private static MeasuredBoxes measured(Path labels, Path boxes, Optional<Size> picture) {
    BoxRecording.Reading reading = new BoxRecording.Reading(picture, Optional.empty(), 0);
    return MeasuredBoxes.of(List.of(BoxRecording.read(labels, boxes, reading)), 0.5);
  }

  private MeasuredBoxes measured(String labels, String boxes) throws IOException {
    return measured(file("a.gt.txt", labels), file("a.det.txt", boxes), Optional.empty());
  }

  private void assertOneOfTwoFound(MeasuredBoxes measured) {
    assertEquals(2, measured.boxes().size());
    assertEquals(1, measured.people());
    assertEquals(1, measured.boxes().get(0).found());
    assertEquals(0, measured.boxes().get(1).found());
    assertEquals(40, measured.boxes().get(0).height(), 1e-9);
    assertEquals(0.5, measured.falseAlarmsPerFrame());
  }

  @Test
  void readsMotChallenge() throws IOException {
    assertOneOfTwoFound(measured(MOT, MOT_BOXES));
  }

  @Test
  void readsCocoWithResults() throws IOException {
    Path labels = file("coco.json", COCO);
    assertOneOfTwoFound(measured(labels, file("results.json", RESULTS), Optional.empty()));
  }

  @Test
  void readsYoloFoldersWithFrameSize() throws IOException {
    file("gt/img_000001.txt", "0 0.1 0.4 0.1 0.4 5\n2 0.3 0.4 0.1 0.4\n");
    file("gt/img_000002.txt", "0 0.11 0.4 0.1 0.4 5\n");
    file("det/img_000001.txt", "0 0.105 0.4 0.1 0.4 0.9\n2 0.3 0.4 0.1 0.4 0.9\n");
    file("det/img_000002.txt", "0 0.55 0.4 0.1 0.4 0.8\n");
    Optional<Size> picture = Optional.of(new Size(200, 100));
    assertOneOfTwoFound(measured(folder.resolve("gt"), folder.resolve("det"), picture));
    InputException missing =
        assertThrows(
            InputException.class,
            () -> measured(folder.resolve("gt"), folder.resolve("det"), Optional.empty()));
    assertTrue(missing.getMessage().contains("image=WIDTHxHEIGHT"), missing.getMessage());
  }

  @Test
  void takesVisibilityAndClassOfNineColumns() throws IOException {
    String labels =
        "1,1,0,0,10,20,1,1,0.25\n1,2,50,0,10,20,0,1,1\n1,3,80,0,10,20,1,7,1\n2,1,0,0,10,20,1,1,1\n";
    MeasuredBoxes measured =
        measured(labels, "1,-1,50,0,10,20,0.9\n1,-1,80,0,10,20,0.9\n2,-1,0,0,10,20,0.9\n");
    assertEquals(2, measured.boxes().size(), "ignored rows are no people");
    assertEquals(0.75, measured.boxes().get(0).hidden());
    assertEquals(0, measured.falseAlarmsPerFrame(), "what is ignored is no false alarm either");
  }

  @Test
  void omitsDetectionsBelowScore() throws IOException {
    Path labels = file("a.gt.txt", MOT);
    Path boxes = file("a.det.txt", MOT_BOXES);
    BoxRecording.Reading reading =
        new BoxRecording.Reading(Optional.empty(), Optional.empty(), 0.85);
    BoxRecording recording = BoxRecording.read(labels, boxes, reading);
    assertEquals(1, recording.frames().get(1L).detections().size());
    assertTrue(recording.frames().get(2L).detections().isEmpty());
    assertEquals("a", recording.name());
  }

  @Test
  void countsDetectionsOutsideLabelledTime() throws IOException {
    MeasuredBoxes measured = measured(MOT, MOT_BOXES + "3,-1,1,1,9,9,0.9,-1,-1,-1\n");
    assertEquals(1, measured.recordings().get(0).outside());
    assertEquals(0.5, measured.falseAlarmsPerFrame());
  }

  private void assertRejected(String labels, String boxes, String... expected) {
    InputException refused =
        assertThrows(InputException.class, () -> measured(labels, boxes), labels);
    for (String part : expected) {
      assertTrue(refused.getMessage().contains(part), refused.getMessage());
    }
    assertFalse(refused.getMessage().contains("\n"), "one line");
  }

  @Test
  void rejectsDetectionsMostlyOutsideLabelledFrames() {
    assertRejected(
        MOT,
        MOT_BOXES.replace("1,-1,11", "900,-1,11").replace("2,-1,1", "901,-1,1"),
        "a.det.txt:1:1",
        "frame is 900",
        "1 to 2");
  }

  @Test
  void rejectsBoxesOfSizeZero() {
    assertRejected(MOT.replace("20,40,1", "0,40,1"), MOT_BOXES, "a.gt.txt:1", "0.0 x 40.0");
    assertRejected(MOT, MOT_BOXES.replace("20,40,0.8", "20,0,0.8"), "a.det.txt:2", "20.0 x 0.0");
  }

  @Test
  void rejectsScoresOutsideUnitRange() {
    assertRejected(MOT, MOT_BOXES.replace("0.8", "80"), "a.det.txt:2", "score", "80", "0 to 1");
  }

  @Test
  void rejectsRepeatedIdInFrame() {
    assertRejected(MOT + "2,5,80,20,20,40,1,-1,-1,-1\n", MOT_BOXES, "a.gt.txt:3", "'5'", "frame 2");
  }

  @Test
  void readsResultsOfUnnamedCategories() throws IOException {
    Path labels = file("a.gt.txt", MOT);
    Path people = file("people.json", RESULTS.replace("\"category_id\": 7", "\"category_id\": 1"));
    assertOneOfTwoFound(measured(labels, people, Optional.empty()));
    Path sevens = file("sevens.json", RESULTS);
    InputException refused =
        assertThrows(InputException.class, () -> measured(labels, sevens, Optional.empty()));
    assertTrue(refused.getMessage().contains("no box has category_id 1"), refused.getMessage());
    BoxRecording.Reading asSeven = new BoxRecording.Reading(Optional.empty(), Optional.of("7"), 0);
    BoxRecording recording = BoxRecording.read(labels, sevens, asSeven);
    assertOneOfTwoFound(MeasuredBoxes.of(List.of(recording), 0.5));
  }

  @Test
  void rejectsJsonThatIsNoCoco() throws IOException {
    for (String content : new String[] {"{}", "[1, 2]", "7", "{\"images\": 3}", "[]", ""}) {
      Path labels = file("coco.json", content);
      Path boxes = file("results.json", RESULTS);
      InputException refused =
          assertThrows(
              InputException.class, () -> measured(labels, boxes, Optional.empty()), content);
      assertTrue(refused.getMessage().contains("coco.json"), refused.getMessage());
      assertFalse(refused.getMessage().contains("\n"), "one line");
    }
    String foreign = RESULTS.replace("\"image_id\": 2", "\"image_id\": 9");
    Path labels = file("coco.json", COCO);
    Path boxes = file("results.json", foreign);
    InputException refused =
        assertThrows(InputException.class, () -> measured(labels, boxes, Optional.empty()));
    assertTrue(refused.getMessage().contains("image_id is 9"), refused.getMessage());
  }
}
