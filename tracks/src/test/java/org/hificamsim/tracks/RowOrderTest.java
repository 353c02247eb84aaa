package org.hificamsim.tracks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.hificamsim.core.InputException;
import org.hificamsim.tracks.format.Unit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests rows that are not in the order of time. */
class RowOrderTest {
  @TempDir Path folder;

  private Imported table() {
    return new Imported(folder).unit(Unit.M);
  }

  @Test
  void sortsRowsByTime() {
    Imported imported = table();
    ImportSummary found =
        imported.read("csv", "time,id,x,y\n0,1,0,0\n2,1,2,0\n1,1,1,0\n3,1,3,0\n0,2,5,5\n");
    assertEquals(
        "target 1 size 0.66;0 0 0;1 0;2 0;3 0;target 2 size 0.66;0 5 5;", imported.tracks());
    String line = "sorted by time: 1 row of 1 targets, the first at ";
    assertTrue(found.lines().toString().contains(line), found.lines()::toString);
    assertTrue(found.lines().toString().contains("recording:4:1"), found.lines()::toString);
  }

  @Test
  void sortsShuffledRowsAsIfInOrder() {
    List<String> rows = new ArrayList<>();
    for (int time = 0; time < 50; time++) {
      for (int id = 1; id <= 3; id++) {
        rows.add("%s,%s,%s,%s\n".formatted(time, id, time * 1.5, id));
      }
    }
    Imported inOrder = table();
    inOrder.read("csv", "time,id,x,y\n" + String.join("", rows));
    String expected = inOrder.tracks().replaceAll("target \\d", "target");
    for (int seed = 0; seed < 5; seed++) {
      Collections.shuffle(rows, new Random(seed));
      Imported shuffled = table();
      shuffled.read("csv", "time,id,x,y\n" + String.join("", rows));
      assertEquals(
          sortedTargets(expected),
          sortedTargets(shuffled.tracks().replaceAll("target \\d", "target")));
    }
  }

  private static List<String> sortedTargets(String tracks) {
    return List.of(tracks.split("(?=target)")).stream().sorted().toList();
  }

  @Test
  void countsLateDuplicatesOnce() {
    Imported imported = table();
    imported.read("csv", "time,id,x,y\n0,1,0,0\n1,1,1,0\n0,1,0,0\n2,1,2,0\n");
    assertEquals("target 1 size 0.66;0 0 0;1 0;2 0;", imported.tracks());
  }

  @Test
  void rejectsTwoPlacesAtOneTimeInAnyOrder() {
    InputException error =
        assertThrows(
            InputException.class,
            () -> table().read("csv", "time,id,x,y\n0,1,0,0\n1,1,1,0\n0,1,9,0\n"));
    String message = "recording:4:1: target 1 is at two places at time 0.0, expected one sample";
    assertTrue(error.getMessage().contains(message), error::getMessage);
  }

  @Test
  void keepsPausesIfLaterPartsComeFirst() {
    Imported imported = new Imported(folder);
    imported.read(
        "gpx",
        """
        <gpx><trk><trkseg>
        <trkpt lat="48" lon="11"><time>2024-05-31T12:00:10Z</time></trkpt>
        <trkpt lat="48" lon="11"><time>2024-05-31T12:00:15Z</time></trkpt>
        </trkseg><trkseg>
        <trkpt lat="48" lon="11"><time>2024-05-31T12:00:00Z</time></trkpt>
        <trkpt lat="48" lon="11"><time>2024-05-31T12:00:05Z</time></trkpt>
        </trkseg></trk></gpx>
        """);
    assertEquals("target 1 size 0.66;0 0 0;0 0;target 1 size 0.66;10 0 0;0 0;", imported.tracks());
  }

  @Test
  void pedestriansOfDifferentScenesAreDifferentTargets() {
    StringBuilder text = new StringBuilder();
    for (int scene = 0; scene < 2; scene++) {
      for (int frame = 0; frame <= 20; frame += 10) {
        text.append(
            "{\"track\": {\"f\": %s, \"p\": 7, \"x\": %s, \"y\": %s, \"scene_id\": %s}}\n"
                .formatted(frame, frame / 10, scene, scene));
      }
    }
    Imported imported = new Imported(folder).rate(10);
    imported.read("trajnet", text.toString());
    String expected = "target 1 size 0.66;0 0 0;1 0;2 0;target 2 size 0.66;0 0 1;1 1;2 1;";
    assertEquals(expected, imported.tracks());
    Imported withoutScenes = new Imported(folder).rate(10);
    ImportSummary found =
        withoutScenes.read("trajnet", text.toString().replaceAll(", .scene_id.: .", ""));
    assertEquals(expected, withoutScenes.tracks());
    assertTrue(found.lines().toString().contains("ids: 1 are used again"), found.lines()::toString);
    assertFalse(found.lines().toString().contains("sorted by time"), found.lines()::toString);
  }

  @Test
  void pedestrianAtTwoPlacesAtOnceBecomesTwoTargets() {
    Imported imported = new Imported(folder).rate(10);
    imported.read(
        "trajnet",
        """
        {"track": {"f": 0, "p": 7, "x": 0, "y": 0}}
        {"track": {"f": 10, "p": 7, "x": 1, "y": 0}}
        {"track": {"f": 10, "p": 7, "x": 9, "y": 9}}
        {"track": {"f": 20, "p": 7, "x": 8, "y": 9}}
        """);
    assertEquals("target 1 size 0.66;0 0 0;1 0;target 2 size 0.66;1 9 9;8 9;", imported.tracks());
  }

  @Test
  void sortsPedestriansWithoutScenes() {
    Imported imported = new Imported(folder).rate(10);
    imported.read(
        "trajnet",
        """
        {"track": {"f": 0, "p": 7, "x": 0, "y": 0}}
        {"track": {"f": 20, "p": 7, "x": 2, "y": 0}}
        {"track": {"f": 10, "p": 7, "x": 1, "y": 0}}
        """);
    assertEquals("target 7 size 0.66;0 0 0;1 0;2 0;", imported.tracks());
  }
}
