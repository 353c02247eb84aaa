package org.hificamsim.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.scenario.Scenario;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests how policies turn and zoom CamSim's cameras that have a lens. */
class OpticsTest {
  private static final String TURNING = "hfov=15;40;100,pan=-60;0;60,pixels=640";
  private static final String RANDOM_BY_AREA = "policy=random,law=constant-area," + TURNING;
  private static final String UNCHANGED = "; CamSim runs on unchanged\n";
  private static final Map<String, Double> HEADINGS =
      Map.of("A", 30.0, "B", -45.0, "C", 0.0, "D", 180.0, "E", 0.0);

  /** Replacements that make a CamSim whose {@code change} and events use radians. */
  private static final Map<String, String> IN_RADIANS =
      Map.of(
          "Math.toRadians(newHeading)", "newHeading",
          "Math.toRadians(newAngle)", "newAngle",
          "event.number(\"heading\"),\n              event.number(\"viewing_angle\"),",
              "Math.toRadians(event.number(\"heading\")),"
                  + " Math.toRadians(event.number(\"viewing_angle\")),");

  @TempDir Path folder;

  @ParameterizedTest
  @MethodSource
  void policyDecidesAsInHiFiCamSimWhileCamerasTurnFailAndJoin(
      String detection, String policy, String law) throws IOException {
    String optics = TURNING + ",law=" + law;
    CamSimRun with =
        run("with", "detection=%s,policy=%s,%s,out=results".formatted(detection, policy, optics));
    assertEquals("", with.err());
    assertSameFiles(inHiFiCamSim(detection(detection), policy, optics), with);
  }

  static Stream<Arguments> policyDecidesAsInHiFiCamSimWhileCamerasTurnFailAndJoin() {
    String density = "dori-2014:level=observe";
    return Stream.of(
        Arguments.of(density, "fixed:levels=1;pans=2", "pinhole"),
        Arguments.of(density, "random", "constant-area"),
        Arguments.of(density, "optimal", "pinhole"),
        Arguments.of(density, "one-hop", "constant-area"),
        Arguments.of("camsim-visibility", "optimal", "constant-area"),
        Arguments.of("hifi:orb-power", "greedy", "pinhole"),
        Arguments.of("hifi:orb-power", "tracker", "pinhole"),
        Arguments.of("hifi:orb-power@chance", "epsilon-greedy:epsilon=0.2", "pinhole"),
        Arguments.of("hifi:orb-power", "sarsa:gamma=0.9;epsilon=0.1", "constant-area"),
        Arguments.of("hifi:orb-power", "qb-sarsa:k=2", "pinhole"));
  }

  @Test
  void camSimLooksWherePolicyTurnsCamerasWithoutModel() throws IOException {
    CamSimRun with = run("with", "policy=epsilon-greedy," + TURNING + ",out=results");
    assertEquals("", with.err());
    Detection detection = detection("camsim-visibility");
    assertSameFiles(inHiFiCamSim(detection, "epsilon-greedy", TURNING), with);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void camerasTurnAndZoomBeforeLookingInEitherAngleUnit(boolean radians) throws IOException {
    String options = RANDOM_BY_AREA + ",out=results";
    CamSimRun with = radians ? run("with", options, Variant.of(folder, IN_RADIANS)) : turning();
    assertEquals("", with.err());
    Map<String, String[]> views = new HashMap<>();
    with.rows("results/zooms.csv").stream()
        .map(row -> row.split(","))
        .forEach(cells -> views.put(cells[1] + " " + cells[2], cells));
    Set<String> seen = new TreeSet<>();
    for (String row : with.rows("looks.csv")) {
      Look look = Look.parse(row);
      String[] view = views.get(look.step() + " " + look.camera());
      assertEquals(Double.parseDouble(view[4]), look.range(), row);
      assertEquals(
          mountedHeading(look) + Double.parseDouble(view[6]), degrees(look.heading()), 1e-9, row);
      assertEquals(Double.parseDouble(view[7]), degrees(look.angle()), 1e-9, row);
      assertEquals("0", view[8]);
      seen.add(look.camera() + view[3] + view[6]);
    }
    assertEquals(5 * 9, seen.size(), "five cameras, each at all of its views: " + seen);
  }

  /** Returns the mounted heading of the camera that looks; an event turns A in step 90. */
  private static double mountedHeading(Look look) {
    return look.camera().equals("A") && look.step() >= 90 ? 60 : HEADINGS.get(look.camera());
  }

  private static double degrees(double radians) {
    return Math.toDegrees(radians);
  }

  @Test
  void reachFollowsAngleByConstantAreaButNotByPinhole() {
    CamSimRun area = turning();
    assertEquals(Set.of(12.0, 12 * Math.sqrt(15.0 / 40), 12 * Math.sqrt(0.15)), ranges(area, "A"));
    assertEquals(Set.of(16.0, 16 * Math.sqrt(15.0 / 40), 16 * Math.sqrt(0.15)), ranges(area, "B"));
    assertEquals(Set.of(12.0), ranges(run("pinhole", "policy=random," + TURNING), "A"));
  }

  private static Set<Double> ranges(CamSimRun run, String camera) {
    Set<Double> ranges = new TreeSet<>();
    run.rows("looks.csv").stream()
        .map(Look::parse)
        .filter(look -> look.camera().equals(camera))
        .forEach(look -> ranges.add(look.range()));
    return ranges;
  }

  @Test
  void cameraCanTurnToOneDegreeLeftOfNorth() throws IOException {
    String before = Files.readString(CamSimRun.CROSSING);
    Path file = folder.resolve("left.xml");
    Files.writeString(file, before.replace("heading=\"30\"", "heading=\"-1\""));
    CamSimRun with =
        CamSimRun.of(
            folder.resolve("with"), "policy=fixed,hfov=40,pan=-30;0,out=results", file, 20);
    assertEquals("", with.err());
    with.rows("looks.csv").stream()
        .map(Look::parse)
        .filter(look -> look.camera().equals("A"))
        .forEach(look -> assertEquals(-1, Math.IEEEremainder(degrees(look.heading()), 360), 1e-9));
    assertTrue(with.rows("results/zooms.csv").get(0).endsWith(",0.0,40.0,0"));
  }

  @Test
  void resultFilesContainViewsAndOptics() {
    CamSimRun with = turning();
    assertTrue(
        with.text("results/zooms.csv")
            .startsWith("run,step,camera,level,radius,detected,pan,viewing_angle,moving\n"));
    String summary = with.text("results/summary.json").replaceAll("\\s+", "");
    assertTrue(
        summary.contains(
            "\"optics\":[{\"name\":\"bridge\",\"law\":\"constant-area\",\"pixels\":640,"
                + "\"hfov\":[15.0,40.0,100.0],\"pan\":[-60.0,0.0,60.0]}]"),
        summary);
    CamSimRun round = CamSimRun.shared("policy=random,out=results");
    assertFalse(round.text("results/summary.json").contains("optics"));
  }

  @ParameterizedTest
  @ValueSource(ints = {10, 100})
  void endOfRunRestoresCamerasUnlessEventTurnedThem(int steps) throws IOException {
    Path classes = Variant.compile(folder, "Ends.java", ENDS);
    List<String> with = camerasAtEnd("with", RANDOM_BY_AREA, classes, steps);
    assertEquals(camerasAtEnd("without", CamSimRun.WITHOUT_AGENT, classes, steps), with);
    assertEquals(steps > 55 ? 5 : 4, with.size());
  }

  private static final String ENDS =
      """
import epics.camsim.core.*;
import java.io.File;
import java.nio.file.Paths;

public class Ends {
  public static void main(String[] arguments) throws Exception {
    SimCore core = new SimCore(new File(arguments[0]), 0, Paths.get("output.csv"));
    for (int i = 0; i < Integer.parseInt(arguments[1]); i++) core.update();
    core.close_files();
    for (CameraController camera : core.getCameras()) {
      System.out.println("camera " + camera.getName() + " " + camera.getX() + " " + camera.getY()
          + " " + camera.getHeading() + " " + camera.getAngle());
    }
  }
}
""";

  /** Returns lines that describe the cameras after the end of a run. */
  private List<String> camerasAtEnd(String name, String options, Path classes, int steps) {
    CamSimRun run =
        CamSimRun.start(
            folder.resolve(name),
            options,
            List.of(classes, CamSimRun.DOUBLES),
            "Ends",
            List.of(CamSimRun.CROSSING.toString(), "" + steps));
    assertEquals("", run.err());
    return run.out().lines().filter(line -> line.startsWith("camera")).toList();
  }

  @Test
  void failureRestoresHeadingAngleAndRange() throws IOException {
    Path classes =
        Variant.of(
            folder,
            "    x = newX == -1 ? x : newX;",
            """
                if (Integer.getInteger("changes", 0) == 30) {
                  System.setProperty("changes", "31");
                  throw new IllegalStateException("stuck");
                }
                System.setProperty("changes", "" + (Integer.getInteger("changes", 0) + 1));
                x = newX == -1 ? x : newX;
            """);
    CamSimRun with = run("with", "policy=random,law=constant-area,out=results," + TURNING, classes);
    assertTrue(with.err().endsWith("stuck" + UNCHANGED), with.err());
    int steps = with.rows("results/steps.csv").size();
    assertTrue(steps > 1 && steps < 20, steps + " steps before the failure");
    CamSimRun without = CamSimRun.shared(CamSimRun.WITHOUT_AGENT);
    assertFalse(without.text("looks.csv").startsWith(with.text("looks.csv").substring(0, 5000)));
    assertEquals(aimsAfter(steps, without), aimsAfter(steps, with));
  }

  /** Returns range, heading and angle of each look after some steps. */
  private static List<String> aimsAfter(int steps, CamSimRun run) {
    return run.rows("looks.csv").stream()
        .map(Look::parse)
        .filter(look -> look.step() > steps)
        .map(look -> look.camera() + look.range() + " " + look.heading() + " " + look.angle())
        .toList();
  }

  @Test
  void reportsUnknownAngleUnitAndLetsCamSimRunOn() throws IOException {
    Path classes =
        Variant.of(
            folder,
            "angle = newAngle == -1 ? angle : Math.toRadians(newAngle);",
            "angle = angle + 0 * newAngle;");
    CamSimRun with = run("with", "policy=fixed:0," + TURNING, classes);
    assertEquals(run("without", CamSimRun.WITHOUT_AGENT, classes).all(), with.all());
    assertTrue(with.err().startsWith("hificamsim-bridge: CamSim has heading "), with.err());
    assertTrue(with.err().endsWith(", expected the same" + UNCHANGED), with.err());
    assertEquals(1, with.err().lines().count());
  }

  /** Returns a run in which cameras turn and zoom by chance. */
  private static CamSimRun turning() {
    return CamSimRun.shared(RANDOM_BY_AREA + ",out=results");
  }

  /** Runs the scenario in HiFi-CamSim, and returns the folder of its results. */
  private Path inHiFiCamSim(Detection detection, String policy, String optics) throws IOException {
    Scenario scenario =
        OwnSimulation.scenario(
            CamSimRun.CROSSING,
            BridgeOptions.parse("policy=random," + optics, OwnSimulation.CATALOGUE)
                .optics()
                .orElseThrow());
    Path engine = folder.resolve("engine");
    OwnSimulation.record(
        engine,
        scenario,
        detection,
        OwnSimulation.CATALOGUE.policies().create(policy.replace(';', ',')),
        200);
    return engine;
  }

  private static Detection detection(String name) {
    return name.endsWith("@chance")
        ? Detection.by(
            DetectionRule.parse("chance"),
            name,
            OwnSimulation.CATALOGUE.detection(name.replace("@chance", "")))
        : OwnSimulation.detection(name);
  }

  private static void assertSameFiles(Path expected, CamSimRun with) throws IOException {
    for (String file : List.of("steps.csv", "zooms.csv", "targets.csv")) {
      assertEquals(Files.readString(expected.resolve(file)), with.text("results/" + file), file);
    }
  }

  private CamSimRun run(String name, String options) {
    return CamSimRun.of(folder.resolve(name), options);
  }

  private CamSimRun run(String name, String options, Path classes) {
    return CamSimRun.start(
        folder.resolve(name),
        options,
        List.of(classes),
        "epics.camwin.Main",
        List.of("--no-gui", "-t", "200", "-o", "output.csv", CamSimRun.CROSSING.toString()));
  }
}
