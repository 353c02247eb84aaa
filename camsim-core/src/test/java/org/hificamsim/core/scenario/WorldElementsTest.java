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
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.AgentCheck;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Floorplan;
import org.hificamsim.core.scenario.spec.Moving;
import org.hificamsim.core.scenario.spec.Occlusion;
import org.hificamsim.core.scenario.spec.OpticsLaw;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests how scenarios declare optics, obstacles, the duration of a step, the floor plan, and the
 * extent of targets.
 */
class WorldElementsTest {
  private static final String OBJECT =
      "<objects><object features='1' x='1' y='2' heading='30' speed='4'/></objects>";
  private static final String CAMERA = "<camera name='a' x='1' y='2' heading='3' optics='ptz'/>";
  private static final String PTZ =
      "<optics name='ptz' law='pinhole' pixels='1920' hfov='58 40 25 15 8' pan='-60:60:15'"
          + " pan_speed='90' zoom_time='2' moving='sees'/>";

  @TempDir Path folder;
  private final List<String> warnings = new ArrayList<>();

  @Test
  void readsOptics() {
    OpticsSpec optics = optics(PTZ);
    assertEquals(
        new OpticsSpec("ptz")
            .with(OpticsSpec.PIXELS, 1920)
            .with(OpticsSpec.ANGLES_OF_VIEW, List.of(8.0, 15.0, 25.0, 40.0, 58.0))
            .with(OpticsSpec.PANS, List.of(-60.0, -45.0, -30.0, -15.0, 0.0, 15.0, 30.0, 45.0, 60.0))
            .with(OpticsSpec.PAN_SPEED, 90)
            .with(OpticsSpec.ZOOM_TIME, 2)
            .with(OpticsSpec.MOVING, Moving.SEES),
        optics);
    assertEquals(List.of(), warnings);
  }

  @Test
  void opticsDefaultToLensThatTurnsAtOnce() {
    OpticsSpec optics = optics("<optics name='ptz' hfov='60'/>");
    assertEquals(OpticsLaw.PINHOLE, optics.law());
    assertEquals(Optional.empty(), optics.pixels());
    assertEquals(List.of(0.0), optics.pans());
    assertEquals(Moving.BLIND, optics.moving());
    assertTrue(!optics.takesTime());
  }

  /** Eq 3.1: 2 atan(w / (2 z)). */
  @Test
  void computesAnglesOfViewFromFocalLengths() {
    OpticsSpec optics =
        optics("<optics name='ptz' focal_length='0.018 0.085' sensor_width='0.0223'/>");
    assertEquals(2, optics.anglesOfView().size());
    assertEquals(14.94, optics.anglesOfView().get(0), 0.01);
    assertEquals(63.55, optics.anglesOfView().get(1), 0.01);
  }

  @Test
  void cameraWithLensNeedsNoAngleOrRange() {
    CameraSpec camera = read("<cameras>" + PTZ + CAMERA + "</cameras>" + OBJECT).cameras().get(0);
    assertEquals(58, camera.viewingAngle());
    assertEquals(0, camera.range());
  }

  @Test
  void readsObstacles() {
    Scenario scenario =
        read(
            "<obstacles><wall x1='1' y1='2' x2='3' y2='4' transmittance='0.1'/>"
                + "<polygon points='5,5 7,5 6,7'/><pillar x='-3' y='-4' radius='0.5'/></obstacles>"
                + "<cameras>"
                + PTZ
                + CAMERA.replace("x='1'", "x='0'")
                + "</cameras>"
                + OBJECT.replace("x='1'", "x='0'"));
    assertEquals(
        List.of(
            new Obstacle.Wall(1, 2, 3, 4, 0.1),
            new Obstacle.Polygon(List.of(new Point(5, 5), new Point(7, 5), new Point(6, 7)), 0),
            new Obstacle.Pillar(-3, -4, 0.5, 0)),
        scenario.obstacles());
  }

  @Test
  void readsAttributesOfSimulation() {
    Scenario scenario =
        read(
            "step='0.5' occlusion='targets' floorplan='plan.png' floorplan_min_x='-20'",
            "<cameras>" + PTZ + CAMERA + "</cameras>" + OBJECT);
    assertEquals(0.5, scenario.stepTime());
    assertEquals(Occlusion.TARGETS, scenario.occlusion());
    assertEquals(
        Optional.of(new Floorplan("plan.png", new Field(-20, 10, -10, 10))), scenario.floorplan());
  }

  @Test
  void sizeIsTheRootOfWidthTimesHeight() {
    Scenario scenario =
        read(
            "<cameras>"
                + PTZ
                + CAMERA
                + "</cameras>"
                + OBJECT.replace("speed", "width='0.5' height='1.62' speed"));
    TargetSpec target = scenario.targets().get(0);
    assertEquals(0.9, target.size(), 1e-12);
    assertEquals(0.5, target.width());
    assertEquals(Optional.of(new Extent(0.5, 1.62)), target.extent());
  }

  @Test
  void writtenScenarioReadsBackEqual() throws IOException {
    String world =
        "<obstacles><wall x1='1' y1='3' x2='3' y2='4' transmittance='0.1'/>"
            + "<polygon points='5,5 7,5 6,7'/><pillar x='-3' y='-4' radius='0.5'/></obstacles>"
            + "<cameras><zoom>2 4</zoom>"
            + PTZ
            + "<optics name='area' law='constant-area' hfov='30 180' reach='15'/>"
            + "<optics name='turning' law='round' pan='-90 0 90'/>"
            + CAMERA
            + CAMERA.replace("'a'", "'b'").replace("ptz", "area")
            + "<camera name='c' x='0' y='0' heading='0' viewing_angle='90' range='5'"
            + " optics='turning'/></cameras>"
            + OBJECT.replace("speed", "width='0.5' height='1.62' speed")
            + "<events><event timestep='3' participant='camera' event='add' name='d' x='0' y='1'"
            + " heading='0' optics='ptz'/></events>";
    Scenario scenario = read("step='0.5' occlusion='targets' floorplan='plan.png'", world);
    Path written = folder.resolve("test.xml");
    Files.writeString(written, ScenarioWriter.write(scenario));
    assertEquals(scenario, ScenarioReader.read(written, name -> true, AgentCheck.NONE, w -> {}));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "hfov='58 x'|<optics> hfov is '58 x', expected numbers between spaces, each once",
        "hfov=''|<optics> hfov is '', expected numbers",
        "hfov='58 58'|each once",
        "hfov='180'|degrees above 0 and below 180",
        "law='pinhole'|<optics> has no hfov, expected",
        "law='fish' hfov='5'|<optics> law is 'fish', expected one of round, constant-area, pinhole",
        "law='round' hfov='5'|expected none with law=\"round\"",
        "law='round' reach='5'|expected none with law=\"round\"",
        "law='constant-area' hfov='5'|<optics> has no reach, expected",
        "law='constant-area' hfov='200' reach='5'|degrees above 0 and at most 180",
        "hfov='5' pixels='0'|<optics> pixels is '0', expected a whole number from 1 to 100000",
        "hfov='5' pan='60:-60:15'|<optics> pan is '60:-60:15', expected",
        "hfov='5' pan='0:1:0'|<optics> pan is '0:1:0', expected",
        "hfov='5' pan='0:1:1e-9'|<optics> pan is '0:1:1e-9', expected",
        "hfov='5' pan='400'|degrees from -360 to 360",
        "hfov='5' pan_speed='0'|<optics> pan_speed is '0', expected a number above 0",
        "hfov='5' zoom_time='-1'|<optics> zoom_time is '-1', expected a number from 0",
        "hfov='5' moving='shut'|<optics> moving is 'shut', expected one of blind, sees",
        "focal_length='0.05'|<optics> has no sensor_width, expected",
        "focal_length='0.05' hfov='5'|expected none together with focal_length",
        "hfov='0.1:100:0.1' pan='0:100:0.5'|at most 10000 views",
        "hfov='5 50' vfov='4'|<optics> vfov is '4', expected one for each level, 2",
        "hfov='5' vfov='4' aspect='1'|<optics> aspect is '1', expected none together with vfov",
        "hfov='5' aspect='0'|<optics> aspect is '0', expected a number above 0",
        "law='constant-area' hfov='5' reach='9' tilt='0 10'|expected none with law",
        "hfov='5' tilt='80 100'|<camera> has no tilt, expected with each tilt of its optics"
      })
  void rejectsInvalidOptics(String attributes, String message) {
    assertRejected(
        "<cameras><optics name='ptz' " + attributes + "/>" + CAMERA + "</cameras>" + OBJECT,
        message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<wall x1='1' y1='5' x2='1' y2='5'/>|expected two points",
        "<wall x1='1' y1='5' x2='1'/>|<wall> has no y2, expected",
        "<wall x1='1' y1='5' x2='1' y2='6' transmittance='2'/>|transmittance is '2', expected a"
            + " number",
        "<pillar x='1' y='5' radius='0'/>|<pillar> radius is '0', expected",
        "<polygon points='1,5 2,5'/>|<polygon>",
        "<polygon points='1,5 2,5 3,5'/>|<polygon>",
        "<polygon points='5,5 7,7 7,5 5,7'/>|<polygon>",
        "<polygon points='1;5 2,5 3,6'/>|<polygon> points is '1;5 2,5 3,6', expected corners",
        "<pillar x='1' y='2' radius='1'/>|expected a place off all obstacles; (1.0, 2.0) is in or"
            + " on",
        "<wall x1='0' y1='2' x2='2' y2='2'/>|expected a place off all obstacles",
        "<wall x1='1' y1='5' x2='1' y2='6' base='2' height='1'/>|base is 2.0 and height 1.0",
        "<wall x1='1' y1='5' x2='1' y2='6' height='0'/>|<wall> height is '0', expected a number"
            + " above 0"
      })
  void rejectsInvalidObstacles(String obstacle, String message) {
    assertRejected(
        "<obstacles>" + obstacle + "</obstacles><cameras>" + PTZ + CAMERA + "</cameras>" + OBJECT,
        message);
  }

  @Test
  void readsHeights() throws IOException {
    String world =
        "<obstacles><wall x1='1' y1='3' x2='3' y2='4' height='1.8'/>"
            + "<pillar x='1' y='2' radius='0.5' base='3.5'/></obstacles><cameras>"
            + PTZ.replace("pan=", "aspect='1.5' tilt='-10:20:10' pan=")
            + CAMERA.replace("optics", "z='3' tilt='15' optics")
            + "</cameras>"
            + OBJECT.replace("speed", "seen='head' width='0.5' height='1.7' speed");
    Scenario scenario = read("seen='feet' foreshortening='cosine'", world);
    assertTrue(scenario.hasHeights());
    CameraSpec camera = scenario.cameras().get(0);
    assertEquals(3, scenario.z(camera));
    assertEquals(15, camera.tilt());
    OpticsSpec optics = camera.optics().orElseThrow();
    assertEquals(List.of(-10.0, 0.0, 10.0, 20.0), optics.tilts());
    double upright = 2 * Math.toDegrees(Math.atan(Math.tan(Math.toRadians(29)) / 1.5));
    assertEquals(upright, optics.verticalAngles().get(4), 1e-12);
    assertEquals(1.8, scenario.obstacles().get(0).height());
    Path written = folder.resolve("test.xml");
    Files.writeString(written, ScenarioWriter.write(scenario));
    assertEquals(scenario, ScenarioReader.read(written, name -> true, AgentCheck.NONE, w -> {}));
    assertTrue(!scenario.flat().hasHeights());
    assertEquals(1, scenario.flat().obstacles().size(), "nobody looks at what is overhead");
  }

  @Test
  void camerasWithoutHeightTakeMountHeight() {
    String camera = "<cameras>" + PTZ + CAMERA.replace("optics", "tilt='9' optics") + "</cameras>";
    Scenario scenario = read("mount_height='4'", camera + OBJECT);
    assertEquals(4, scenario.z(scenario.cameras().get(0)));
    InputException error =
        assertThrows(
            InputException.class,
            () -> read("mount_height='4'", camera.replace("tilt", "z='3' tilt") + OBJECT));
    assertTrue(
        error.getMessage().contains("z is '3', expected the scenario's mount_height, 4.0, or none"),
        error::getMessage);
  }

  @Test
  void rejectsTiltWithoutLens() {
    assertRejected(
        "<cameras><camera name='a' x='1' y='2' heading='3' tilt='5' range='4'"
            + " viewing_angle='9'/></cameras>"
            + OBJECT,
        "<camera> tilt is '5', expected none without optics that have law=\"pinhole\"");
  }

  @Test
  void acceptsCameraAboveShelf() {
    String above = CAMERA.replace("optics", "z='3' optics");
    String shelf = "<obstacles><pillar x='1' y='2' radius='0.5' height='2'/></obstacles>";
    String object = OBJECT.replace("x='1'", "x='4'");
    assertTrue(read(shelf + "<cameras>" + PTZ + above + "</cameras>" + object).hasHeights());
    assertRejected(
        shelf
            + "<cameras>"
            + PTZ
            + above.replace("'3' optics", "'2' optics")
            + "</cameras>"
            + object,
        "expected a place off all obstacles");
  }

  @Test
  void rejectsUnknownOpticsOfCamera() {
    assertRejected(
        "<cameras>" + PTZ + CAMERA.replace("'ptz'", "'lens'") + "</cameras>" + OBJECT,
        "<camera> optics is 'lens', expected one of ptz");
    assertRejected(
        "<cameras>" + CAMERA + "</cameras>" + OBJECT, "expected none: the file has no <optics>");
  }

  @Test
  void rejectsEventThatMovesCameraIntoPillar() {
    assertRejected(
        withPillar(change(3, "5", "5")), "<event> x is '5', expected a place off all obstacles");
  }

  @Test
  void checksMovesOfCameraInOrderOfTime() {
    assertEquals(2, read(withPillar(change(4, "1", "5") + change(3, "5", "-1"))).events().size());
    assertRejected(
        withPillar(change(4, "-1", "5") + change(3, "5", "-1")),
        "<event> x is '-1', expected a place off all obstacles; (5.0, 5.0) is in or on a solid");
  }

  /** A world with a pillar at (5, 5), a camera at (1, 2), and events. */
  private static String withPillar(String events) {
    return "<obstacles><pillar x='5' y='5' radius='1'/></obstacles><cameras>"
        + PTZ
        + CAMERA
        + "</cameras>"
        + OBJECT
        + "<events>"
        + events
        + "</events>";
  }

  private static String change(int step, String x, String y) {
    return ("<event timestep='%s' participant='camera' event='change' name='a' x='%s' y='%s'"
            + " heading='-1' viewing_angle='-1' range='-1'/>")
        .formatted(step, x, y);
  }

  @Test
  void rejectsBordersWithoutFloorplan() {
    InputException error =
        assertThrows(
            InputException.class,
            () -> read("floorplan_min_x='1'", "<cameras>" + PTZ + CAMERA + "</cameras>" + OBJECT));
    assertTrue(error.getMessage().contains("expected none without floorplan"), error::getMessage);
  }

  @Test
  void rejectsOpticsWithSameName() {
    assertRejected(
        "<cameras>" + PTZ + PTZ + CAMERA + "</cameras>" + OBJECT,
        "expected a name that no other optics have");
  }

  @Test
  void rejectsSizeTogetherWithWidthAndHeight() {
    assertRejected(
        "<cameras>"
            + PTZ
            + CAMERA
            + "</cameras>"
            + OBJECT.replace("speed", "size='1' width='0.5' height='1' speed"),
        "<object> size is '1', expected none together with width and height");
    assertRejected(
        "<cameras>" + PTZ + CAMERA + "</cameras>" + OBJECT.replace("speed", "width='1' speed"),
        "<object> has no height, expected");
  }

  @Test
  void checksOnlyWaypointsOfScriptedTargets() {
    read(
        "<obstacles><pillar x='5' y='5' radius='1'/></obstacles><cameras>"
            + PTZ
            + CAMERA
            + "</cameras><objects>"
            + "<object features='1' x='5' y='5' heading='0' speed='1' move='Scripted'>"
            + "<waypoint x='1' y='11'/><waypoint x='2' y='1'/></object></objects>");
    assertEquals(List.of(), warnings);
  }

  @Test
  void warnsOfPathThroughWall() {
    read(
        "<obstacles><wall x1='5' y1='-1' x2='5' y2='9'/></obstacles><cameras>"
            + PTZ
            + CAMERA
            + "</cameras><objects><object_with_waypoints features='1' speed='1'>"
            + "<waypoint x='3' y='3'/><waypoint x='7' y='3'/></object_with_waypoints></objects>");
    assertEquals(1, warnings.size());
    assertTrue(
        warnings
            .get(0)
            .endsWith("the way from (3.0, 3.0) to (7.0, 3.0) leads through a solid obstacle"),
        warnings::toString);
  }

  @Test
  void reportsEachIndependentFault() {
    List<String> faults = new ArrayList<>();
    Path file =
        file(
            "occlusion='walls'",
            "<obstacles><wall x1='1'/><pillar x='1' y='9' radius='-1'/></obstacles>"
                + "<cameras><optics name='ptz' hfov='999'/>"
                + CAMERA
                + "</cameras>"
                + OBJECT);
    ScenarioReader.check(
        file, name -> true, AgentCheck.NONE, w -> {}, fault -> faults.add(fault.getMessage()));
    assertEquals(4, faults.size(), faults::toString);
  }

  private OpticsSpec optics(String element) {
    return read("<cameras>" + element + CAMERA + "</cameras>" + OBJECT)
        .cameras()
        .get(0)
        .optics()
        .orElseThrow();
  }

  private void assertRejected(String world, String message) {
    InputException error = assertThrows(InputException.class, () -> read(world));
    assertTrue(error.getMessage().contains(message), error::getMessage);
    assertTrue(error.getMessage().contains("test.xml:1:"), error::getMessage);
  }

  private Scenario read(String world) {
    return read("", world);
  }

  private Scenario read(String attributes, String world) {
    return ScenarioReader.read(
        file(attributes, world), name -> true, AgentCheck.NONE, warnings::add);
  }

  private Path file(String attributes, String world) {
    Path file = folder.resolve("test.xml");
    String text =
        "<root><simulation min_x='-10' max_x='10' min_y='-10' max_y='10' "
            + attributes
            + (attributes.contains("order=") ? "" : " order='coverage'")
            + ">"
            + world
            + "</simulation></root>";
    try {
      return Files.writeString(file, text);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
