package org.hificamsim.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.hificamsim.core.Reference;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.engine.RunCoverage;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests what cameras of CamSim see under the agent. */
class DetectionTest {
  private static CamSimRun without;

  @TempDir Path folder;

  @BeforeAll
  static void runWithoutAgent() {
    without = CamSimRun.shared(CamSimRun.WITHOUT_AGENT);
  }

  @Test
  void agentWithoutOptionsChangesNothing() {
    CamSimRun with = alone("with", CamSimRun.WITHOUT_OPTIONS);
    assertEquals(without.all(), with.all());
    assertEquals("", with.err());
    assertEquals(200, with.rows("output.csv").size());
  }

  @Test
  void camSimVisibilityReproducesCamSimNumbers() {
    CamSimRun with = run("with", "detection=camsim-visibility");
    assertEquals(without.all(), with.all());
    assertEquals("", with.err());
  }

  @ParameterizedTest
  @ValueSource(strings = {"own1006", "own1008", "own1018"})
  void camSimVisibilityReproducesCamSimNumbersForOtherScenarios(String name) {
    Path scenario = Reference.file("own-camsim/" + name + ".xml");
    CamSimRun plain =
        CamSimRun.of(folder.resolve("without"), CamSimRun.WITHOUT_AGENT, scenario, 300);
    CamSimRun with =
        CamSimRun.of(folder.resolve("with"), "detection=camsim-visibility", scenario, 300);
    assertEquals(plain.all(), with.all());
    assertTrue(with.rows("looks.csv").size() > 1000);
  }

  @Test
  void writingResultsChangesNothing() {
    CamSimRun with = CamSimRun.shared("out=results");
    assertEquals(without.all(), with.all());
    assertEquals("", with.err());
  }

  @Test
  void hiFiModelDecidesVisibilityAndConfidence() {
    CamSimRun with = CamSimRun.shared("detection=hifi:orb-lin,out=results");
    assertEquals("", with.err());
    Detection detection = OwnSimulation.detection("hifi:orb-lin");
    int visible = assertFollows(with, detection, TargetSpec.DEFAULT_SIZE);
    assertTrue(visible > 50, visible + " looks saw anything");
    assertNotEquals(without.all(), with.all());
  }

  @Test
  void thresholdAndSizeOfOptionsDecideWhatIsSeen() {
    CamSimRun with = run("with", "detection=hifi:sift-power,threshold=0.3,size=1.7");
    Detection detection = new Detection(OwnSimulation.CATALOGUE.detection("hifi:sift-power"), 0.3);
    int visible = assertFollows(with, detection, 1.7);
    assertTrue(visible > 50, visible + " looks saw anything");
  }

  @Test
  void modelMayBeFileInWorkingDirectory() throws IOException {
    Path model =
        CamSimRun.ROOT.resolve(
            "hifi-detection/src/main/resources/org/hificamsim/hifi/model/lab/surf-power.json");
    Files.createDirectories(folder.resolve("with"));
    Files.copy(model, folder.resolve("with/own.json"));
    CamSimRun with = alone("with", "detection=own.json");
    assertEquals(
        run("named", "detection=lab:surf-power").text("looks.csv"), with.text("looks.csv"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"hifi:orb-lin", "camsim-range", "camsim-visibility", "geometric"})
  void filesEqualThoseOfHiFiCamSim(String name) throws IOException {
    CamSimRun with = CamSimRun.shared("detection=" + name + ",out=results");
    Path expected = folder.resolve("engine");
    RunCoverage sums =
        OwnSimulation.record(
            expected,
            CamSimRun.CROSSING,
            List.of(),
            OwnSimulation.detection(name),
            "zoom-out",
            200);
    for (String file : List.of("steps.csv", "zooms.csv", "targets.csv")) {
      assertEquals(Files.readString(expected.resolve(file)), with.text("results/" + file), file);
    }
    String summary = with.text("results/summary.json");
    assertTrue(summary.contains("\"scenario\" : \"crossing\""), summary);
    assertTrue(summary.contains("\"detection\" : \"" + name + "\""), summary);
    assertTrue(summary.contains("\"policy\" : \"none\""), summary);
    assertTrue(summary.contains("\"steps\" : 200"), summary);
    assertTrue(summary.contains("\"detections\" : " + sums.detections() + ".0"), summary);
    assertTrue(sums.detections() > 50);
  }

  @Test
  void figuresOfFollowingTargetsEqualThoseOfHiFiCamSim() throws IOException {
    CamSimRun with = run("with", "detection=hifi:orb-lin,out=results,following=targets");
    Path expected = folder.resolve("engine");
    Detection detection = OwnSimulation.detection("hifi:orb-lin");
    OwnSimulation.record(expected, CamSimRun.CROSSING, List.of(), detection, "zoom-out", 200);
    String summary = with.text("results/summary.json");
    List<String> figures =
        Files.readString(expected.resolve("summary.json"))
            .lines()
            .filter(line -> line.matches(" *\"(time_to|.*losses|unbroken|handovers).*"))
            .toList();
    assertTrue(figures.size() > 3, figures.toString());
    for (String figure : figures) {
      assertTrue(summary.contains(figure), figure + " is missing in " + summary);
    }
  }

  @Test
  void filesRecordCamSimSightingsWithoutModel() {
    CamSimRun with = CamSimRun.shared("out=results");
    Map<Integer, Long> seen =
        with.rows("looks.csv").stream()
            .map(Look::parse)
            .filter(look -> look.kept() > 0)
            .collect(Collectors.groupingBy(Look::step, Collectors.counting()));
    for (String row : with.rows("results/steps.csv")) {
      String[] cells = row.split(",");
      double pairs = Double.parseDouble(cells[7]) * Integer.parseInt(cells[3]);
      assertEquals(seen.getOrDefault(Integer.valueOf(cells[1]), 0L), Math.round(pairs), row);
    }
  }

  /** Requires that each look follows from the logged positions; returns how many saw something. */
  private static int assertFollows(CamSimRun run, Detection detection, double size) {
    Map<String, CameraSpec> cameras =
        OwnSimulation.scenario(CamSimRun.CROSSING, List.of()).cameras().stream()
            .collect(Collectors.toMap(CameraSpec::name, Function.identity()));
    int visible = 0;
    for (String row : run.rows("looks.csv")) {
      Look look = Look.parse(row);
      CameraSpec camera = cameras.get(look.camera());
      if (camera == null || look.step() >= 90) {
        continue; // the camera came later, or an event has turned it
      }
      double expected = confidence(camera, look, detection, size);
      assertEquals(expected, look.returned(), row);
      assertEquals(expected, look.kept(), row);
      visible += expected > 0 ? 1 : 0;
    }
    return visible;
  }

  private static double confidence(CameraSpec camera, Look look, Detection detection, double size) {
    double dx = look.x() - camera.x();
    double dy = look.y() - camera.y();
    double distance = Math.sqrt(dx * dx + dy * dy);
    double bearing = Math.toDegrees(Math.atan2(dx, dy)) - camera.heading();
    double offAxis = Math.abs(Math.IEEEremainder(bearing, 360));
    if (distance > look.range() || offAxis >= camera.viewingAngle() / 2) {
      return 0;
    }
    double angle = Math.toRadians(camera.viewingAngle());
    ZoomLevel zoom = new ZoomLevel(look.range(), look.range(), look.range(), Double.NaN, angle);
    double value = detection.model().confidence(size, distance, Math.toRadians(offAxis), zoom);
    return value >= detection.threshold() ? DetectionModel.clamp(value) : 0;
  }

  private CamSimRun alone(String name, String options) {
    return CamSimRun.alone(folder.resolve(name), options, CamSimRun.CROSSING, 200);
  }

  private CamSimRun run(String name, String options) {
    return CamSimRun.of(folder.resolve(name), options);
  }

  @Test
  void attributesOfScenarioAreDefaultsOfOptions() throws IOException {
    String attributes = " detection=\"hifi:orb-lin\" threshold=\"0.2\" objective=\"covered:k=1\">";
    Path withAttributes =
        Files.writeString(
            folder.resolve("crossing.xml"),
            Files.readString(CamSimRun.CROSSING)
                .replace("max_y=\"15\">", "max_y=\"15\"" + attributes));
    String sameOptions = "detection=hifi:orb-lin,threshold=0.2,objective=covered:k=1,out=results";
    CamSimRun plain = started("plain", sameOptions, CamSimRun.CROSSING);
    assertEquals("", plain.err());
    assertEquals(plain.all(), started("asked", "out=results", withAttributes).all());
    String other = "detection=hifi:orb-power,objective=sum,out=results";
    CamSimRun before = started("before", other, withAttributes);
    assertEquals(started("other", other, CamSimRun.CROSSING).all(), before.all());
  }

  private CamSimRun started(String name, String options, Path scenario) {
    List<String> arguments = List.of("-t", "30", "-o", "output.csv", scenario.toString());
    List<Path> doubles = List.of(CamSimRun.DOUBLES);
    return CamSimRun.start(folder.resolve(name), options, doubles, "epics.camwin.Main", arguments);
  }
}
