package org.hificamsim.core.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.spec.AgentCheck;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.track.Track;
import org.hificamsim.core.world.movement.Movements;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the element {@code tracks} and its file. */
class TracksTest {
  private static final String TRACKS =
      """
      # two people, the first one goes and comes again
      tracks 1
      interval 0.5
      target 1 width 0.5 height 2
      0 -1 2
      -1.5 2.5
      5 3 4
      target 7 size 0.25
      1.25\t0 0
      0 1
      0 2
      target 1 width 0.5 height 2
      20 1 1
      """;

  @TempDir Path folder;
  private final List<String> warnings = new ArrayList<>();

  @Test
  void tracksBecomeEventsThatAddAndRemoveTargets() {
    Scenario scenario = read("tracks file='people.tracks'", TRACKS);
    assertEquals(
        List.of(
            "add 1.0 0",
            "remove 1.0 6",
            "add 7.0 2",
            "remove 7.0 3",
            "add 1.0 20",
            "remove 1.0 21"),
        scenario.events().stream().map(TracksTest::describe).toList());
    assertEquals(List.of(), warnings);
  }

  private static String describe(ScenarioEvent event) {
    return event instanceof ScenarioEvent.AddTarget add
        ? "add " + add.target().features() + " " + add.step()
        : "remove " + ((ScenarioEvent.RemoveTarget) event).features() + " " + event.step();
  }

  @Test
  void samplesWithoutTimeFollowTheInterval() {
    Track track = added(read("tracks file='people.tracks'", TRACKS), 0).track().get();
    assertEquals(List.of(0.0, 0.5, 5.0), List.of(track.time(0), track.time(1), track.time(2)));
    assertEquals(-1.5, track.x(1));
    assertEquals(4, track.y(2));
  }

  @Test
  void targetHasSizeAndMeanSpeed() {
    Scenario scenario = read("tracks file='people.tracks'", TRACKS);
    assertEquals(Optional.of(new Extent(0.5, 2)), added(scenario, 0).extent());
    assertEquals(0.25, added(scenario, 2).size());
    assertEquals(2, added(scenario, 2).speed(), 1e-12);
    assertEquals(0, added(scenario, 4).speed());
  }

  private static TargetSpec added(Scenario scenario, int event) {
    return ((ScenarioEvent.AddTarget) scenario.events().get(event)).target();
  }

  @Test
  void readsBackEqualWithoutTracksFile() throws IOException {
    Scenario scenario =
        read("tracks file='people.tracks'", TRACKS).withTargets(target -> target.withSize(3));
    Files.delete(folder.resolve("people.tracks"));
    Path written = folder.resolve("test.xml");
    Files.writeString(written, ScenarioWriter.write(scenario));
    assertEquals(scenario, read(written));
    assertEquals(Files.readString(written), ScenarioWriter.write(read(written)));
  }

  @Test
  void otherMovementKeepsEvents() throws IOException {
    Scenario scenario = read("tracks file='people.tracks'", TRACKS).withMovement("Brownian");
    Path written = folder.resolve("test.xml");
    Files.writeString(written, ScenarioWriter.write(scenario));
    assertEquals(
        scenario.events().stream().map(TracksTest::describe).toList(),
        read(written).events().stream().map(TracksTest::describe).toList());
  }

  @Test
  void warnsOfTracksWithoutStepOrOutsideField() {
    read(
        "tracks file='people.tracks'",
        "tracks 1\ninterval 1\ntarget 1 size 1\n0.2 1 1\n" + "target 2 size 1\n0 99 0\n");
    assertEquals(2, warnings.size(), warnings::toString);
    assertTrue(warnings.get(0).contains(": 1 of the tracks no step meets"), warnings::toString);
    assertTrue(warnings.get(1).contains(": 1 of the tracks lead outside"), warnings::toString);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "x|people.tracks:1:1: expected 'tracks 1' as the first line",
        "tracks 1;interval 0|people.tracks:2:10: interval is '0', expected a number above 0",
        "tracks 1;interval 1;1 2 3|people.tracks:3:1: the line is '1', expected 'target'",
        "tracks 1;interval 1;target 1;|people.tracks:3:9: the line has no the word, expected"
            + " 'size'",
        "tracks 1;interval 1;target 1 size 1;|people.tracks:3:1: a target without a sample",
        "tracks 1;interval 1;target 1 size 1;1 2|people.tracks:4:4: the line has no time, x and y",
        "tracks 1;interval 1;target 1 size 1;0 1 2;0 1 2|people.tracks:5:1: time is '0', expected a"
            + " number of seconds from 0, later",
        "tracks 1;interval 1;target 1 size 1;0 1 NaN|people.tracks:4:5: y is 'NaN', expected",
        "tracks 1;interval 1;target 1 size 1;0 1 2 3|people.tracks:4:7: a further field is '3'",
        "tracks 1;interval 1;target 1 size 1;0 1 2;3|people.tracks:5:2: the line has no y",
        "tracks 1;interval 1;target 1 size 1;0 1 2;target 1 size 1;0 1 1|people.tracks:6:1: time is"
      })
  void rejectsInvalidTracksWithPlace(String content, String message) {
    InputException error =
        assertThrows(
            InputException.class,
            () -> read("tracks file='people.tracks'", content.replace(';', '\n')));
    assertTrue(error.getMessage().contains(message), error::getMessage);
  }

  @Test
  void rejectsInvalidInlineTracksWithPlace() {
    InputException error =
        assertThrows(
            InputException.class,
            () -> read("tracks>\ntracks 1\ninterval 1\ntarget 1 size x\n</tracks><other", ""));
    assertTrue(error.getMessage().contains("test.xml:4:15: size is 'x'"), error::getMessage);
  }

  @Test
  void rejectsMissingFile() {
    InputException error =
        assertThrows(InputException.class, () -> read("tracks file='none.tracks'", TRACKS));
    assertTrue(error.getMessage().endsWith("no such file, expected a file"), error::getMessage);
  }

  @Test
  void rejectsTargetThatIsPresent() {
    InputException error =
        assertThrows(
            InputException.class,
            () ->
                read(
                    "object features='7' x='0' y='0' heading='0' speed='0'/><tracks"
                        + " file='people.tracks'",
                    TRACKS));
    assertTrue(
        error.getMessage().contains("target 7.0 of the tracks comes at step 2 while another"),
        error::getMessage);
  }

  @Test
  void acceptsEarlierRemovalOfTrackedTarget() {
    read(
        "event timestep='3' participant='object' event='error' name='1'/><tracks"
            + " file='people.tracks'",
        TRACKS);
    assertEquals(List.of(), warnings);
  }

  private Scenario read(String element, String tracks) {
    Path file = folder.resolve("test.xml");
    try {
      Files.writeString(folder.resolve("people.tracks"), tracks);
      Files.writeString(
          file,
          "<root><simulation min_x='-10' max_x='10' min_y='-10' max_y='10'><camera name='a' x='0'"
              + " y='0' heading='0' viewing_angle='90' range='5'/><"
              + element
              + "/></simulation></root>");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return read(file);
  }

  private Scenario read(Path file) {
    return ScenarioReader.read(
        file, Movements.registry().names()::contains, AgentCheck.NONE, warnings::add);
  }
}
