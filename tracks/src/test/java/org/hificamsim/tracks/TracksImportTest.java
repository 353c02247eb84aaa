package org.hificamsim.tracks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import org.hificamsim.core.Reference;
import org.hificamsim.core.scenario.spec.Field;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests imports independently of the format. */
class TracksImportTest {
  @TempDir Path folder;

  @Test
  void startsNewTrackAfterGap() {
    Imported imported = new Imported(folder).rate(1);
    ImportSummary found = imported.read("ethucy", "0 1 0 0\n1 1 1 0\n2 1 2 0\n6 1 3 0\n7 1 4 0\n");
    assertEquals(
        "target 1 size 0.66;0 0 0;1 0;2 0;target 1 size 0.66;6 3 0;4 0;", imported.tracks());
    assertEquals(
        "1 gaps longer than 3 s, up to 4 s: the target is away meanwhile", found.lines().get(3));
    assertEquals(1, found.targets());
  }

  @Test
  void keepsTrackAcrossAllowedGap() {
    Imported imported = new Imported(folder).rate(1).gap(4);
    imported.read("ethucy", "0 1 0 0\n1 1 1 0\n2 1 2 0\n6 1 3 0\n7 1 4 0\n");
    assertEquals("target 1 size 0.66;0 0 0;1 0;2 0;6 3 0;4 0;", imported.tracks());
  }

  @Test
  void keepsPartOfRecording() {
    Imported imported = new Imported(folder).rate(1).cut(1, 2);
    ImportSummary found = imported.read("ethucy", "5 1 0 0\n6 1 1 0\n7 1 2 0\n8 1 3 0\n");
    assertEquals("target 1 size 0.66;0 1 0;2 0;", imported.tracks());
    assertEquals(new Field(1, 2, 0, 0), found.box());
  }

  @Test
  void summarisesRecording() {
    ImportSummary found =
        new Imported(folder)
            .rate(1)
            .cut(1, 1e9)
            .read(
                "ethucy",
                "0 1 0 0\n6 1 0 -1\n7 1 3 3\n8 1 6 7\n12 1 6 8\n13 1 6 9.23456\n9 2 1e6 0\n");
    assertEquals(
        List.of(
            "6 samples of 2 targets in 12 s",
            "nobody before 5 s: a later start leaves that out",
            "a sample every 1 s (1 a second)",
            "speeds: a quarter up to 1.23 m/s, half up to 5, three quarters up to 5",
            "1 gaps longer than 3 s, up to 4 s: the target is away meanwhile",
            "places: x from 0 to 1000000 m, y from -1 to 9.235 m",
            "odd: 1 targets with one sample alone"),
        found.lines());
    assertEquals(12, found.duration());
    assertEquals(3, found.gap());
  }

  @Test
  void computesQuantilesOfSpeeds() {
    ImportSummary found =
        new Imported(folder)
            .rate(1)
            .read("ethucy", "0 1 0 0\n1 1 0 0\n2 1 1 0\n3 1 3 0\n4 1 5003 0");
    double[] quantiles = {0, 0.25, 0.26, 0.5, 0.75, 1};
    double[] expected = {0, 0, 1, 1, 2, 5000};
    for (int i = 0; i < quantiles.length; i++) {
      assertEquals(expected[i], found.quantile(quantiles[i]), 1e-9);
    }
    assertEquals(
        Double.NaN, new Imported(folder).rate(1).read("ethucy", "0 1 0 0\n").quantile(0.5));
  }

  @Test
  void findsJumpsComparedWithNeighbours() {
    assertEquals(List.of(), jumps(1, 5, 1)); // five times as fast is not a jump
    assertEquals(
        List.of("1 jumps, faster than 5 m/s", "target 1 jumps 6 m before 2 s, 6 m/s"),
        jumps(1, 6, 1));
    assertEquals(2, jumps(9, 1).size()); // at the start, and 9 m/s among the others is odd
    assertEquals(2, jumps(1, 9).size());
    assertEquals(List.of(), jumps(2, 9, 9, 2));
    assertEquals(4, jumps(1, 6, 1, 7, 1, 8, 1, 9, 1).size()); // four, of which three are named
  }

  /** The jumps of a track with these speeds, a move per second, among others of about 1 m/s. */
  private List<String> jumps(double... speeds) {
    StringBuilder text = new StringBuilder("0 2 0 1\n1 2 0.01 1\n0 3 0 2\n1 3 0.01 2\n");
    for (int frame = 0; frame < 40; frame++) {
      text.append(frame + " 4 " + frame + " 3\n");
    }
    double x = 0;
    text.append("0 1 0 0\n");
    for (int i = 0; i < speeds.length; i++) {
      x += speeds[i];
      text.append(i + 1 + " 1 " + x + " 0\n");
    }
    return new Imported(folder).rate(1).read("ethucy", text.toString()).oddities();
  }

  @Test
  void computesQuartilesOfSpeeds() {
    ImportSummary found =
        new Imported(folder)
            .rate(1)
            .read("ethucy", "0 1 0 0\n1 1 1 0\n2 1 3 0\n3 1 6 0\n4 1 10 0\n");
    assertEquals(
        "speeds: a quarter up to 1 m/s, half up to 2, three quarters up to 3",
        found.lines().get(2));
  }

  @Test
  void describesOddities() {
    StringBuilder text = new StringBuilder();
    for (int frame = 0; frame < 100; frame++) {
      text.append(frame).append(" 1 ").append(frame == 50 ? 500 : frame).append(" 0\n");
    }
    text.append("99 1 99 0\n99 2 5 5\n");
    ImportSummary found =
        new Imported(folder).rate(1).wall(10.5, -1, 10.5, 1).read("ethucy", text.toString());
    String oddities = String.join("\n", found.oddities());
    assertTrue(oddities.contains("2 jumps, faster than 5 m/s"), oddities);
    assertTrue(oddities.contains("target 1 jumps 451 m before 50 s, 451 m/s"), oddities);
    assertTrue(oddities.contains("1 targets with one sample alone"), oddities);
    assertTrue(
        oddities.contains("1 samples are there twice and count once, the first at "), oddities);
    assertTrue(oddities.contains("recording:101:1"), oddities);
    assertTrue(oddities.contains("through a wall: once, target 1 at 11.0 s"), oddities);
  }

  @Test
  void findsNoJumpsOfFastCar() {
    StringBuilder text = new StringBuilder();
    for (int frame = 0; frame < 40; frame++) {
      text.append(frame + " 1 " + frame + " 0\n" + frame + " 2 " + frame + " 1\n");
      text.append(frame + " 3 " + frame * 15 + " 2\n");
      text.append(frame + " 4 " + frame + " 3\n" + frame + " 5 " + frame + " 3\n");
    }
    assertEquals(
        List.of(), new Imported(folder).rate(1).read("ethucy", text.toString()).oddities());
  }

  @Test
  void readsPackedFilesAndNamesWithAccents() throws IOException {
    Path file = folder.resolve("Straße é.txt.gz");
    try (Writer out =
        new OutputStreamWriter(
            new GZIPOutputStream(Files.newOutputStream(file)), StandardCharsets.UTF_8)) {
      out.write("\ufeff0 1 2 3\n");
    }
    Imported imported = new Imported(folder).rate(1);
    imported.readFile("ethucy", file);
    assertEquals("target 1 size 0.66;0 2 3;", imported.tracks());
  }

  @Test
  void findsPublishedFiguresOfZara01() {
    Path file = Reference.file("tracks/zara01-obsmat.txt");
    ImportSummary found = new Imported(folder).rate(25).readFile("obsmat", file);
    assertEquals(148, found.targets());
    assertEquals(5024, found.samples());
    assertEquals(0.4, found.interval());
  }
}
