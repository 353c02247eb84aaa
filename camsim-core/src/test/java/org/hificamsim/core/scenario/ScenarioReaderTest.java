package org.hificamsim.core.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Headings;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.VisionGraph;
import org.hificamsim.core.scenario.spec.Waypoint;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ScenarioReaderTest {
  private static final String CAMERA =
      "<camera name='a' x='1' y='2' heading='3' viewing_angle='90' range='5'/>";
  private static final String OBJECT = "<object features='1' x='1' y='2' heading='30' speed='4'/>";
  private static final String CHANGED = "x='1' y='1' heading='0' viewing_angle='90' range='5'";

  @TempDir Path folder;
  private final List<String> warnings = new ArrayList<>();

  @Test
  void readsEveryElementAndAttribute() {
    Scenario scenario = read(everything());
    assertEquals("test", scenario.name());
    assertEquals(new Field(-15.5, 15, -10, 10.25), scenario.field());
    assertEquals(StepOrder.CAMSIM, scenario.order());
    assertEquals(Headings.AS_RADIANS, scenario.headings());
    assertEquals(OptionalDouble.of(0.3), scenario.threshold());
    assertEquals(Optional.of(new DetectionRule.Threshold()), scenario.detect());
    assertEquals(new Objective.Covered(2), scenario.objective());
    assertEquals(OptionalDouble.of(3.5), scenario.mountHeight());
    assertEquals(List.of(2.0, 3.5, 5.0), scenario.zooms());
    assertEquals(Map.of("note", "kept & quoted <>\"'"), scenario.extras());
    Scenario known =
        read(everything().replaceAll(" (\\w+_zoom|zoom_steps|colour|tag)=\"\\S*\"", ""));
    assertEquals(
        List.of(
            new CameraSpec("Cam \"1\" \n\tä", -3, 2, 0)
                .with(CameraSpec.HEADING, -180)
                .with(CameraSpec.ALGORITHM, "epics.ai.auctionSchedules.ActiveAuctionSchedule")
                .with(CameraSpec.COMM, 4)
                .with(CameraSpec.CUSTOM_COMM, "epics.ai.Own")
                .with(CameraSpec.LIMIT, 2)
                .with(CameraSpec.BANDIT, "epics.bandits.UCB1"),
            new CameraSpec("", 15, 10.25, 19.9)
                .with(CameraSpec.HEADING, 1000)
                .with(CameraSpec.VIEWING_ANGLE, 0.5)),
        known.cameras());
    assertTargets(known.targets());
    assertEvents(known.events());
    assertEquals(
        List.of(
            Map.of("min_zoom", "2.0", "max_zoom", "5.0", "zoom_steps", "2", "colour", "red"),
            Map.of(),
            Map.of("colour", "blue")),
        scenario.everyCamera().map(CameraSpec::extras).toList());
    assertEquals(
        List.of(Map.of("tag", "t"), Map.of("tag", "u")),
        scenario.targets().subList(4, 6).stream().map(TargetSpec::extras).toList());
    VisionGraph graph = scenario.visionGraph().orElseThrow();
    assertTrue(graph.isStatic());
    assertEquals(Map.of("B", List.of("A & C", "D"), "A", List.of("B")), graph.neighbours());
    assertEquals(List.of("B", "A"), List.copyOf(graph.neighbours().keySet()), "in file order");
  }

  private static void assertTargets(List<TargetSpec> targets) {
    List<Waypoint> path = List.of(new Waypoint(1, 2), new Waypoint(3, 4));
    List<Waypoint> long3 = List.of(new Waypoint(5, 6), new Waypoint(7, 8), new Waypoint(9, 10));
    assertEquals(
        List.of(
            new TargetSpec(1, 0, 0)
                .with(TargetSpec.HEADING, 2.5)
                .with(TargetSpec.SPEED, 1)
                .withSize(0.1),
            new TargetSpec(2, 0, 0)
                .with(TargetSpec.SPEED, 1)
                .with(TargetSpec.MOVE, "epics.movement.Waypoints")
                .with(TargetSpec.WAYPOINTS, path),
            new TargetSpec(3, 0, 0)
                .with(TargetSpec.SPEED, 1)
                .with(TargetSpec.MOVE, "epics.movement.Brownian")
                .with(TargetSpec.MEAN, 0.5)
                .with(TargetSpec.STD, 2),
            new TargetSpec(4, 0, 0).with(TargetSpec.SPEED, -1).with(TargetSpec.MOVE, ""),
            new TargetSpec(5, 99, 0)
                .with(TargetSpec.SPEED, 1)
                .with(TargetSpec.MOVE, "org.example.Right"),
            new TargetSpec(6, 5, 6)
                .with(TargetSpec.ORIGIN, TargetSpec.Origin.OBJECT_WITH_WAYPOINTS)
                .with(TargetSpec.HEADING, -1)
                .with(TargetSpec.SPEED, 0.7)
                .with(TargetSpec.MOVE, "epics.movement.Waypoints")
                .with(TargetSpec.WAYPOINTS, long3)
                .withSize(2)),
        targets);
  }

  private static void assertEvents(List<ScenarioEvent> events) {
    List<Waypoint> path = List.of(new Waypoint(-1, -2), new Waypoint(-3, -4));
    assertEquals(
        List.of(
            new ScenarioEvent.AddCamera(
                9,
                new CameraSpec("Late", 0, 0, 5)
                    .with(CameraSpec.VIEWING_ANGLE, 90)
                    .with(CameraSpec.ALGORITHM, "a")
                    .with(CameraSpec.COMM, 0)
                    .with(CameraSpec.CUSTOM_COMM, "c")
                    .with(CameraSpec.LIMIT, 1)
                    .with(CameraSpec.BANDIT, "b")),
            new ScenarioEvent.ChangeCamera(3, "Late", -1, 1, -1, -1, 30),
            new ScenarioEvent.FailCamera(4, "Late", -1),
            new ScenarioEvent.AddTarget(5, added(7).withSize(5)),
            new ScenarioEvent.AddTarget(
                5,
                added(8)
                    .with(TargetSpec.MOVE, "epics.movement.Brownian")
                    .with(TargetSpec.MEAN, 0.25)
                    .with(TargetSpec.STD, 0.5)),
            new ScenarioEvent.AddTarget(5, added(9).with(TargetSpec.WAYPOINTS, path)),
            new ScenarioEvent.RemoveTarget(6, 9),
            new ScenarioEvent.FailRegistration(7, 5)),
        events);
  }

  private static TargetSpec added(double features) {
    return new TargetSpec(features, 1, 2)
        .with(TargetSpec.ORIGIN, TargetSpec.Origin.EVENT)
        .with(TargetSpec.HEADING, 3)
        .with(TargetSpec.SPEED, 4)
        .with(TargetSpec.MOVE, "");
  }

  @Test
  void missingAttributesTakeDefaults() {
    Scenario scenario = read(scenario("", CAMERA, OBJECT));
    assertEquals(StepOrder.CAMSIM, scenario.order());
    assertEquals(Headings.DEGREES, scenario.headings());
    assertEquals(OptionalDouble.empty(), scenario.threshold());
    assertEquals(Optional.empty(), scenario.detect());
    assertEquals(Objective.kMin(), scenario.objective());
    assertEquals(OptionalDouble.empty(), scenario.mountHeight());
    assertEquals(List.of(), scenario.zooms());
    assertEquals(List.of(), scenario.networkParts());
    assertEquals(0.66, scenario.targets().get(0).size());
    assertEquals("Straight", scenario.targets().get(0).movement());
    assertEquals(0, scenario.targets().get(0).mean());
    assertEquals(1, scenario.targets().get(0).std());
    assertEquals(Optional.empty(), scenario.visionGraph());
    assertEquals(List.of(), warnings);
  }

  @ParameterizedTest
  @CsvSource({
    "'', '', CAMSIM, false",
    "'', <zoom>1 2</zoom>, COVERAGE, true",
    "order='coverage', '', COVERAGE, false",
    "order='camsim', <zoom>1 2</zoom>, CAMSIM, true",
  })
  void zoomListMeansCoverageDialect(
      String attributes, String zoom, StepOrder order, boolean coverage) {
    Scenario scenario = read(scenario(attributes, zoom + CAMERA, OBJECT));
    assertEquals(order, scenario.order());
    assertEquals(coverage, scenario.inCoverageDialect());
  }

  @Test
  void findsElementsAtAnyDepth() {
    Scenario scenario =
        read(
            "<root><group><simulation min_x='-9' max_x='9' min_y='-9' max_y='9'/></group>"
                + CAMERA
                + "<x><y>"
                + OBJECT
                + "</y></x><zoom>1 2</zoom></root>");
    assertEquals(1, scenario.cameras().size());
    assertEquals(1, scenario.targets().size());
    assertEquals(List.of(1.0, 2.0), scenario.zooms());
  }

  @Test
  void acceptsCamerasAndTargetsOnlyFromEvents() {
    Scenario scenario =
        read(
            scenario(
                "",
                "",
                "<event timestep='5' participant='camera' event='add' name='a' x='0' y='0'"
                    + " heading='0' viewing_angle='90' range='5'/>"
                    + "<event timestep='5' participant='object' event='add' name='1' x='0' y='0'"
                    + " heading='0' speed='1'/>"));
    assertEquals(2, scenario.events().size());
  }

  @Test
  void readsZoomsAcrossCommentsAndLines() {
    Scenario scenario =
        read(
            scenario(
                "",
                "<zoom>1<!-- one --> <!-- space -->2\n\t<![CDATA[ 3 ]]>4&#32;5</zoom>" + CAMERA,
                OBJECT));
    assertEquals(List.of(1.0, 2.0, 3.0, 4.0, 5.0), scenario.zooms());
  }

  @ParameterizedTest
  @CsvSource({
    "min_x='-9',    min_x='-1e308', a number from -1e9 to 1e9 (m)",
    "max_y='9',     max_y='1.1e9',  a number from -1e9 to 1e9 (m)",
    "max_x='9',     max_x='-9',     'more than min_x, -9.0'",
    "max_y='9',     max_y='-9.5',   'more than min_y, -9.0'",
    "mount_height='3', mount_height='1e10', a number above 0 and at most 1e9 (m)",
    "range='5',     range='1e200',  a number from 0 to 1e9 (m)",
    "x='7',         x='-1e308',     a number from -1e9 to 1e9 (m)",
    "speed='1',     speed='1e300',  a number from -1e9 to 1e9 (m a step)",
    "size='2',      size='1e10',    a number above 0 and at most 1e9 (m)",
    "mean='0',      mean='-2e9',    a number from -1e9 to 1e9 (m)",
    "std='1',       std='2e9',      a number from 0 to 1e9 (m)",
    "y='4',         y='1e308',      a number from -1e9 to 1e9 (m)",
    "speed='2',     speed='-1e300', a number from -1e9 to 1e9 (m a step)",
    "range='6',     range='1e200',  'a number from 0 to 1e9 (m), or -1 to leave it'",
  })
  void rejectsLengthsAndSpeedsOutOfRange(String part, String beyond, String expected) {
    String text =
        scenario(
            "mount_height='3'",
            CAMERA,
            "<object features='1' x='7' y='0' heading='0' speed='1' size='2' mean='0' std='1'/>"
                + "<object_with_waypoints features='2' speed='2'><waypoint x='2' y='2'/>"
                + "<waypoint x='3' y='4'/></object_with_waypoints>"
                + "<event timestep='1' participant='camera' event='change' name='a' x='-1' y='-1'"
                + " heading='-1' viewing_angle='-1' range='6'/>");
    int at = text.indexOf(part);
    InputException error =
        assertThrows(
            InputException.class,
            () -> read(text.substring(0, at) + beyond + text.substring(at + part.length())));
    String[] sides = beyond.split("=");
    assertEquals(
        "%s:1:%s: %s %s is %s, expected %s"
            .formatted(
                folder.resolve("test.xml"),
                at + 1,
                text.substring(text.lastIndexOf('<', at)).split(" ")[0] + ">",
                sides[0],
                sides[1],
                expected),
        error.getMessage());
  }

  @Test
  void acceptsABillionMetres() {
    Scenario scenario =
        read(
            scenario("", CAMERA.replaceFirst("range='[^']*'", "range='1e9'"), OBJECT)
                .replace("max_x='9'", "max_x='1e9'"));
    assertEquals(1e9, scenario.field().maxX());
    assertEquals(1e9, scenario.cameras().get(0).range());
  }

  @Test
  void warningsNameTheirPlace() {
    read(
        """
<root version="2">
  <simulation min_x="-9" max_x="9" min_y="-9" max_y="9" gravity="9.81">
    <cameras unit="m">
      <camera name="a" x="1" y="2" heading="3" viewing_angle="90" range="5" colour="red"
              comm="0" min_zoom="1" max_zoom="2" zoom_steps="1"/>
    </cameras>
    <object features="1" x="-9.5" y="2" heading="30" speed="4"/>
    <object features="2" x="1" y="2" heading="30" speed="4" move="epics.movement.Waypoints">
      <waypoint x="10" y="0"/><waypoint x="9" y="0" z="0"/>
    </object>
    <event timestep="3" participant="object" event="add" name="7" x="1" y="2" heading="3"
        speed="4" move="epics.movement.Brownian"/>
    <event timestep="1" participant="object" event="error" name="7"/>
    <obstacle/>
    <visiongraph static="false" weight="1">
      <graphnode name="a"><neighbour name="b"/></graphnode>
      <graphnode name="a"><neighbour name="c" far="yes"/></graphnode>
    </visiongraph>
  </simulation>
</root>
""");
    assertEquals(
        List.of(
            "1:7: unknown attribute version=\"2\" of <root>, ignored",
            "14:5: unknown element <obstacle>, ignored",
            "3:14: unknown attribute unit=\"m\" of <cameras>, ignored",
            "4:77: unknown attribute colour=\"red\" of <camera>, ignored",
            "7:26: <object> starts outside the field at (-9.5, 2.0); it stays there, turning,"
                + " unless one step leads inside",
            "9:7: <waypoint> lies outside the field, out of reach",
            "9:53: unknown attribute z=\"0\" of <waypoint>, ignored",
            "12:19: an event's move is ignored, as in CamSim (unless a quirk of CamSim says"
                + " otherwise); fqName counts",
            "13:60: no object 7.0 is there at step 1, nothing is removed",
            "17:18: a second <graphnode> for 'a', the last one counts",
            "17:47: unknown attribute far=\"yes\" of <neighbour>, ignored",
            "15:33: unknown attribute weight=\"1\" of <visiongraph>, ignored",
            "2:57: unknown attribute gravity=\"9.81\" of <simulation>, ignored"),
        withoutFile(warnings));
  }

  @Test
  void warningMentionsQuirkAfterTemporaryFailure() {
    String event = "\n<event timestep='%d' participant='camera' event='%s' name='a' %s/>";
    read(
        scenario(
            "",
            CAMERA,
            OBJECT
                + event.formatted(1, "error", "duration='3'")
                + event.formatted(5, "change", CHANGED)
                + event.formatted(6, "error", "duration='-1'")
                + event.formatted(7, "change", CHANGED)));
    String unless = ", nothing happens (unless a quirk of CamSim lets it come back)";
    assertEquals(
        List.of(
            "3:57: camera 'a' is not online at step 5" + unless,
            "4:56: camera 'a' is not online at step 6" + unless,
            "5:57: camera 'a' is not online at step 7" + unless),
        withoutFile(warnings));
  }

  @Test
  void warnsOfEventsForOfflineCameras() {
    String event = "\n<event timestep='%d' participant='camera' event='%s' name='a' %s/>";
    read(
        scenario(
            "",
            "",
            OBJECT
                + event.formatted(5, "add", CHANGED)
                + event.formatted(4, "change", CHANGED)
                + event.formatted(5, "error", "duration='0'")
                + event.formatted(6, "error", "duration='-1'")
                + event.formatted(7, "change", CHANGED)));
    assertEquals(
        List.of(
            "3:57: camera 'a' is not online at step 4, nothing happens",
            "6:57: camera 'a' is not online at step 7, nothing happens"),
        withoutFile(warnings));
  }

  @Test
  void lastOfRepeatedGraphNodesCounts() {
    Scenario scenario =
        read(
            scenario(
                "",
                CAMERA,
                OBJECT
                    + "<visiongraph static='no'><graphnode name='a'><neighbour"
                    + " name='b'/></graphnode><graphnode name='a'><neighbour"
                    + " name='c'/></graphnode></visiongraph>"));
    VisionGraph graph = scenario.visionGraph().orElseThrow();
    assertEquals(Map.of("a", List.of("c")), graph.neighbours());
    assertFalse(graph.isStatic());
  }

  @Test
  void ignoresVisionGraphWithoutNodes() {
    Scenario scenario = read(scenario("", CAMERA, OBJECT + "<visiongraph static='true'/>"));
    assertEquals(Optional.empty(), scenario.visionGraph());
  }

  @Test
  void acceptsSchemaReferenceWithoutWarning() {
    read(
        scenario("", CAMERA, OBJECT)
            .replace(
                "<root>",
                "<root xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance'"
                    + " xsi:noNamespaceSchemaLocation='camsim.xsd'>"));
    assertEquals(List.of(), warnings);
  }

  @Test
  void ignoresPrefixedNamesWithWarnings() {
    Scenario scenario =
        read(
            scenario("", CAMERA.replace("<camera", "<camera b:x='7'"), OBJECT + "<b:camera/>")
                .replace("<root>", "<root xmlns:b='urn:b'>"));
    assertEquals(1, scenario.cameras().get(0).x());
    assertEquals(Map.of(), scenario.cameras().get(0).extras());
    assertEquals(2, warnings.size(), warnings::toString);
  }

  @Test
  void warningsStayOnOneShortLine() {
    String lines = "x&#10;error: forged" + "y".repeat(500);
    read(scenario("note='" + lines + "'", CAMERA, OBJECT));
    assertEquals(1, warnings.size());
    assertFalse(warnings.get(0).contains("\n"), warnings.get(0));
    assertTrue(withoutFile(warnings).get(0).length() < 150, warnings.get(0));
  }

  @Test
  void looksUpMovementsByShortName() {
    List<String> asked = new ArrayList<>();
    Path file =
        file(
            scenario(
                "",
                CAMERA,
                OBJECT
                    + OBJECT.replace("'1' x", "'2' move='epics.movement.Brownian' x")
                    + OBJECT.replace("'1' x", "'3' move='org.example.Own' x")
                    + OBJECT.replace("'1' x", "'4' move='' x")));
    ScenarioReader.read(file, asked::add, warnings::add);
    assertEquals(List.of("Straight", "Brownian", "org.example.Own", "Straight"), asked);
  }

  @Test
  void rejectsUnknownDefaultMovement() {
    Path file = file(scenario("", CAMERA, OBJECT));
    InputException error =
        assertThrows(
            InputException.class, () -> ScenarioReader.read(file, name -> false, warnings::add));
    assertTrue(error.getMessage().contains("expected a movement such as"), error.getMessage());
  }

  @Test
  void scenarioNameIsFileNameWithoutLastExtension() throws IOException {
    for (String name : List.of("a.b.xml", ".hidden", "plain")) {
      Path file = folder.resolve(name);
      Files.writeString(file, scenario("", CAMERA, OBJECT));
      assertEquals(
          name.equals("a.b.xml") ? "a.b" : name,
          ScenarioReader.read(file, movement -> true, warnings::add).name());
    }
  }

  static String everything() {
    try (InputStream in = ScenarioReaderTest.class.getResourceAsStream("everything.xml")) {
      return new String(in.readAllBytes(), java.nio.charset.StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String scenario(String attributes, String cameras, String rest) {
    return "<root><simulation min_x='-9' max_x='9' min_y='-9' max_y='9' "
        + attributes
        + "><cameras>"
        + cameras
        + "</cameras>"
        + rest
        + "</simulation></root>";
  }

  private Scenario read(String text) {
    return ScenarioReader.read(file(text), movement -> true, warnings::add);
  }

  private Path file(String text) {
    try {
      return Files.writeString(folder.resolve("test.xml"), text);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private List<String> withoutFile(List<String> lines) {
    return lines.stream().map(line -> line.replace(folder.resolve("test.xml") + ":", "")).toList();
  }
}
