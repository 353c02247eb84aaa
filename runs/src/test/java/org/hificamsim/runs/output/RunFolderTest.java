package org.hificamsim.runs.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Following;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.Traffic;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the whole content of a folder of runs. */
class RunFolderTest {
  private static final String SITE =
      """
<root>
  <simulation min_x="0" max_x="12" min_y="0" max_y="8" order="coverage" detection="geometric">
    <cameras>
      <optics name="ptz" law="pinhole" pixels="640" hfov="20 40 60" pan="-40 0 40" pan_speed="20" zoom_time="2"/>
      <optics name="fixed" pixels="800" hfov="90" reach="7"/>
      <camera name="west" x="0.1" y="4.1" heading="90" viewing_angle="60" range="9" optics="ptz"/>
      <camera name="north" x="6.1" y="7.9" heading="180" viewing_angle="90" range="6" optics="fixed"/>
    </cameras>
    <objects>
      <object features="1" x="3" y="4" speed="1" heading="90"/>
    </objects>
    <events>
      <event timestep="2" participant="camera" event="error" name="north" duration="-1"/>
      <event timestep="3" participant="object" event="add" name="2.0" x="9" y="1" speed="0.5" heading="0"/>
    </events>
  </simulation>
</root>
""";
  private static final int STEPS = 5;
  private static final int REPEATS = 2;

  @TempDir static Path folder;
  private static Scenario scenario;

  @BeforeAll
  static void readScenario() throws IOException {
    scenario = read(Files.writeString(folder.resolve("site.xml"), SITE));
  }

  private static Scenario read(Path file) {
    return ScenarioReader.read(file, Catalogue.load().movements().names()::contains, warning -> {});
  }

  private static RunPlan plan(String detection, String policy, int repeats) {
    return new RunPlan(
        scenario,
        DetectionSpec.parse(detection, Catalogue.load()::detection)
            .detection(Settings.NONE, scenario),
        policy,
        STEPS,
        7,
        repeats);
  }

  private static Path run(String name, RunPlan plan, Detail detail) throws IOException {
    Path out = folder.resolve(name);
    try (OutputFolder files = new OutputFolder(out);
        RunFolder output =
            new RunFolder(files, plan.detection(), detail, TableFormat.named("csv"))) {
      List<RunResult> results =
          new RunExecutor(Catalogue.load()).execute(plan, run -> List.of(output.listener(run)));
      Instant started = Instant.now().minusSeconds(90);
      ManifestFile.write(files, List.of("run", "it's here.xml"), started, plan.work());
      InputFiles.write(files, List.of(plan));
      output.finish(plan, results);
      CrateFile.write(files, List.of(plan));
      output.commit();
    }
    return out;
  }

  private static List<Map<String, String>> rows(Path file) throws IOException {
    List<String> lines = Files.readAllLines(file);
    String[] names = lines.get(0).split(",");
    List<Map<String, String>> rows = new ArrayList<>();
    for (String line : lines.subList(1, lines.size())) {
      Map<String, String> row = new HashMap<>();
      String[] cells = line.split(",", -1);
      for (int i = 0; i < names.length; i++) {
        row.put(names[i], cells[i]);
      }
      rows.add(row);
    }
    return rows;
  }

  @Test
  void tablesHaveRowsForStepsCamerasAndTargets() throws IOException {
    Path out = run("tables", plan("geometric", "fixed", REPEATS), Detail.VIEWS);
    List<Map<String, String>> steps = rows(out.resolve("steps.csv"));
    List<Map<String, String>> zooms = rows(out.resolve("zooms.csv"));
    List<Map<String, String>> targets = rows(out.resolve("targets.csv"));
    assertEquals(STEPS * REPEATS, steps.size());
    for (Map<String, String> step : steps) {
      long present =
          targets.stream()
              .filter(row -> row.get("run").equals(step.get("run")))
              .filter(row -> row.get("step").equals(step.get("step")))
              .count();
      assertEquals(step.get("targets"), String.valueOf(present));
    }
    assertEquals(
        REPEATS * 2, targets.stream().filter(row -> row.get("target").equals("2.0")).count());
    List<String> north =
        zooms.stream()
            .filter(row -> row.get("camera").equals("north") && row.get("run").equals("1"))
            .map(row -> row.get("step"))
            .toList();
    assertEquals(List.of("0", "1"), north, "until the camera fails");
    Map<String, String> west = zooms.get(0);
    assertEquals("west", west.get("camera"));
    assertEquals("20.0", west.get("viewing_angle"));
    assertEquals("1", west.get("moving"), "for two seconds");
    assertEquals("0", zooms.get(zooms.size() - 1).get("moving"));
    assertEquals(0, Math.abs(Double.parseDouble(west.get("pan"))) % 40, 1e-9);
    assertEquals("4.0", targets.get(0).get("y"));
  }

  @Test
  void summaryHasMeansIntervalsAndAllRuns() throws IOException {
    RunPlan plan = plan("geometric", "random", REPEATS);
    Path out = run("summary", plan, Detail.STEPS);
    assertFalse(Files.exists(out.resolve("zooms.csv")));
    JsonNode summary = json(out.resolve("summary.json"));
    List<Map<String, String>> steps = rows(out.resolve("steps.csv"));
    double all = 0;
    for (int run = 0; run < REPEATS; run++) {
      String number = String.valueOf(run);
      double sum =
          steps.stream()
              .filter(row -> row.get("run").equals(number))
              .mapToDouble(row -> Double.parseDouble(row.get("k_min")))
              .sum();
      JsonNode entry = summary.get("runs").get(run);
      assertEquals(sum, entry.get("performance").asDouble());
      assertTrue(entry.get("performance").isIntegralNumber());
      assertEquals(run, entry.get("run").asInt());
      assertEquals(7 + run, entry.get("seed").asInt());
      all += sum;
    }
    assertEquals(all / REPEATS, summary.get("performance").asDouble());
    assertTrue(summary.get("performance").isFloatingPointNumber());
    JsonNode interval = summary.get("interval_95").get("performance");
    assertEquals(2, interval.size());
    JsonNode single =
        json(run("single", plan("geometric", "random", 1), Detail.STEPS).resolve("summary.json"));
    assertTrue(single.get("performance").isIntegralNumber());
    assertTrue(single.get("score").isIntegralNumber());
    assertFalse(single.has("interval_95"));
    assertEquals(single.get("runs").get(0).get("performance"), single.get("performance"));
  }

  @Test
  void summaryHasSettingsAndLens() throws IOException {
    JsonNode summary =
        json(
            run("settings", plan("geometric@0.5", "fixed", 1), Detail.STEPS)
                .resolve("summary.json"));
    assertEquals("site", summary.get("scenario").asText());
    assertEquals(2, summary.get("cameras").asInt());
    assertEquals(STEPS, summary.get("steps").asInt());
    assertTrue(summary.get("steps").isIntegralNumber());
    assertEquals(0.5, summary.get("threshold").asDouble());
    assertEquals("fixed", summary.get("policy").asText());
    assertEquals(
        "cameras on the target with the fewest (k_min)", summary.get("score_words").asText());
    JsonNode ptz = summary.get("optics").get(0);
    assertEquals(
        "{\"name\":\"ptz\",\"law\":\"pinhole\",\"pixels\":640,\"hfov\":[20.0,40.0,60.0],"
            + "\"pan\":[-40.0,0.0,40.0],\"pan_speed\":20.0,\"zoom_time\":2.0,\"moving\":\"blind\"}",
        ptz.toString());
    assertEquals(
        "{\"name\":\"fixed\",\"law\":\"pinhole\",\"pixels\":800,\"hfov\":[90.0],\"reach\":7.0,"
            + "\"pan\":[0.0]}",
        summary.get("optics").get(1).toString());
    assertTrue(summary.get("mount_height").isNull());
    assertEquals(0, summary.get("focal_lengths").size());
  }

  @Test
  void crateDescribesFilesAndRun() throws IOException {
    Path out = run("crate", plan("hifi:orb-lin", "fixed", REPEATS), Detail.ZOOMS);
    Map<String, JsonNode> entities = new HashMap<>();
    for (JsonNode entry : json(out.resolve("ro-crate-metadata.json")).get("@graph")) {
      entities.put(entry.get("@id").asText(), entry);
    }
    List<String> results =
        List.of("manifest.json", "steps.csv", "summary.json", "targets.csv", "zooms.csv");
    List<String> inputs = List.of("detection-hifi-orb-lin.json", "scenario-site.xml");
    for (String name : Stream.concat(results.stream(), inputs.stream()).toList()) {
      JsonNode file = entities.get(name);
      String type =
          name.endsWith("csv") ? "text/csv" : "application/" + name.replaceAll(".*\\.", "");
      assertEquals(type, file.get("encodingFormat").asText());
      assertEquals(Files.size(out.resolve(name)), file.get("contentSize").asLong());
      assertEquals(name, file.get("name").asText());
      assertTrue(file.get("sha256").asText().matches("[0-9a-f]{64}"));
    }
    JsonNode root = entities.get("./");
    assertEquals("HiFi-CamSim: run of site", root.get("name").asText());
    assertEquals(
        "Detections: hifi:orb-lin. Policies: fixed. Made with: ./hificamsim run 'it'\\''s"
            + " here.xml'",
        root.get("description").asText());
    assertEquals(7, root.get("hasPart").size());
    JsonNode action = entities.get("#run");
    assertEquals(results, ids(action.get("result")));
    assertEquals(inputs, ids(action.get("object")));
    Instant start = Instant.parse(action.get("startTime").asText());
    Instant end = Instant.parse(action.get("endTime").asText());
    assertTrue(!end.isBefore(start.plusSeconds(90)) && end.isBefore(start.plusSeconds(900)));
    assertEquals("development", entities.get("#hificamsim").get("softwareVersion").asText());
    assertTrue(
        entities
            .get("#hificamsim")
            .get("identifier")
            .asText()
            .matches("git commit [0-9a-f]{40}.*"));
    assertEquals("#licence", id(root.get("license")));
    assertEquals("#thesis", id(root.get("citation")));
    assertEquals("#run", id(root.get("mentions")));
    assertEquals("#hificamsim", id(action.get("instrument")));
    assertEquals("#vejdanparast", id(entities.get("#thesis").get("author")));
    JsonNode crate = entities.get("ro-crate-metadata.json");
    assertEquals("./", id(crate.get("about")));
    assertEquals("https://w3id.org/ro/crate/1.1", id(crate.get("conformsTo")));
    assertEquals("Person", entities.get("#vejdanparast").get("@type").asText());
    assertEquals("CreativeWork", entities.get("#licence").get("@type").asText());
    assertEquals(action.get("startTime"), root.get("datePublished"));
  }

  private static String id(JsonNode reference) {
    return reference.get("@id").asText();
  }

  private static List<String> ids(JsonNode references) {
    List<String> ids = new ArrayList<>();
    references.forEach(entry -> ids.add(id(entry)));
    return ids;
  }

  @Test
  void writesListOfSettingsOfSeveralPlans() throws IOException {
    Scenario plain =
        read(Path.of(System.getProperty("hificamsim.root", "."), "scenarios", "ring-random.xml"));
    RunPlan lens =
        new RunPlan(plain, plan("hifi:orb-lin", "fixed", 1).detection(), "fixed", STEPS, 7, 1);
    Path out = folder.resolve("plans");
    try (OutputFolder output = new OutputFolder(out)) {
      SettingsFile.write(output, List.of(plan("geometric", "fixed", 1), lens));
      output.commit(List.of());
    }
    JsonNode settings = json(out.resolve("settings.json"));
    assertEquals("site", settings.get(0).get("scenario").asText());
    JsonNode second = settings.get(1);
    assertFalse(second.has("optics"));
    assertTrue(second.get("zooms").size() > 1);
    assertEquals(second.get("zooms").size(), second.get("focal_lengths").size());
    assertTrue(second.get("mount_height").asDouble() > 0);
    assertEquals("cameras", second.get("score_unit").asText());
    assertEquals(Detail.VIEWS, Detail.full(scenario));
    assertEquals(Detail.ZOOMS, Detail.full(plain));
  }

  @Test
  void summaryHasProofOfEachRun() throws IOException {
    JsonNode optimal =
        json(run("proof", plan("geometric", "optimal", 1), Detail.STEPS).resolve("summary.json"));
    JsonNode claims = optimal.get("runs").get(0);
    JsonNode fixed =
        json(run("none", plan("geometric", "fixed", 1), Detail.STEPS).resolve("summary.json"));
    List<String> more = new ArrayList<>();
    claims.fieldNames().forEachRemaining(more::add);
    fixed.get("runs").get(0).fieldNames().forEachRemaining(more::remove);
    assertFalse(more.isEmpty(), "no proof in " + claims);
  }

  @Test
  void singleRunWritesSameFilesAsExecutor() throws IOException {
    RunPlan plan = plan("geometric", "random", 1);
    Path whole = run("whole", plan, Detail.VIEWS);
    Path out = folder.resolve("single-run");
    try (SingleRun single = new SingleRun(out, 0, plan.detection(), Detail.VIEWS, Following.NONE)) {
      assertEquals(0, single.steps());
      RunResult result = new RunExecutor(Catalogue.load()).repeat(plan, 0, List.of(single));
      assertEquals(STEPS, single.steps());
      single.commit(plan, Traffic.NONE, Optional.empty());
      assertEquals(plan.seed(), result.seed());
    }
    for (String name : List.of("steps.csv", "zooms.csv", "targets.csv")) {
      assertEquals(Files.readString(whole.resolve(name)), Files.readString(out.resolve(name)));
    }
    assertEquals(
        json(whole.resolve("summary.json")).get("performance"),
        json(out.resolve("summary.json")).get("performance"));
    assertFalse(OutputFolder.isOutputFolder(out.resolve("none")));
    assertFalse(Files.exists(out.resolve(".hificamsim")), "its lock is gone");
  }

  @Test
  void writesColumnsOfDetectionByChance() throws IOException {
    Path out = run("chance", plan("hifi:orb-lin@chance", "fixed", 1), Detail.ZOOMS);
    String crate = Files.readString(out.resolve("ro-crate-metadata.json"));
    assertTrue(crate.contains("Detections: hifi:orb-lin@chance"), crate);
    Map<String, String> step = rows(out.resolve("steps.csv")).get(0);
    assertTrue(step.containsKey("least_chance"));
    double chance = Double.parseDouble(rows(out.resolve("targets.csv")).get(0).get("chance_1"));
    assertTrue(chance >= Double.parseDouble(step.get("least_chance")) && chance <= 1);
  }

  @Test
  void writesInputsThatGiveSameRun() throws IOException {
    RunPlan fitted = plan("hifi:orb-lin@0.4", "fixed", 1);
    RunPlan other = plan("hifi:sift-lin", "fixed", 1);
    Path first = inputs("one", fitted, fitted);
    assertEquals(List.of("detection-hifi-orb-lin.json", "scenario-site.xml"), names(first));
    assertTrue(
        Files.readString(first.resolve("scenario-site.xml"))
            .contains("detection=\"detection-hifi-orb-lin.json@0.4\""));
    assertTrue(
        Files.readString(inputs("rule", plan("geometric", "fixed", 1)).resolve("scenario-site.xml"))
            .contains("detection=\"geometric@"));
    Path both = inputs("both", fitted, other);
    assertEquals(
        List.of("detection-hifi-orb-lin.json", "detection-hifi-sift-lin.json", "scenario-site.xml"),
        names(both));
    assertFalse(Files.readString(both.resolve("scenario-site.xml")).contains("detection="));
    Scenario changed = scenario.with(Scenario.STEPS, 99);
    RunPlan variant = new RunPlan(changed, fitted.detection(), "fixed", STEPS, 7, 1);
    assertEquals(
        List.of("detection-hifi-orb-lin.json", "scenario-site-2.xml", "scenario-site.xml"),
        names(inputs("variants", fitted, variant)));
  }

  private static Path inputs(String name, RunPlan... plans) throws IOException {
    Path out = folder.resolve("inputs-" + name);
    try (OutputFolder output = new OutputFolder(out)) {
      InputFiles.write(output, List.of(plans));
      output.commit(List.of());
    }
    return out;
  }

  /** The names of a folder's files without the record of their hashes. */
  static List<String> names(Path out) throws IOException {
    try (Stream<Path> files = Files.list(out)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> !name.startsWith(".hificamsim"))
          .sorted()
          .toList();
    }
  }

  @Test
  void removesResultsOfEarlierCommandButNotInputs() throws IOException {
    Path out = run("again", plan("geometric", "fixed", REPEATS), Detail.VIEWS);
    Files.writeString(out.resolve("mine.csv"), "mine");
    run("again", plan("hifi:orb-lin", "fixed", 1), Detail.STEPS);
    assertEquals(
        List.of(
            "detection-hifi-orb-lin.json",
            "manifest.json",
            "mine.csv",
            "ro-crate-metadata.json",
            "scenario-site.xml",
            "steps.csv",
            "summary.json"),
        names(out));
  }

  @Test
  void releasesLockOfFolderAfterFailure() throws IOException {
    Path out = Files.createDirectory(folder.resolve("taken"));
    Files.writeString(out.resolve("summary.json"), "mine");
    RunPlan plan = plan("geometric", "fixed", 1);
    assertThrows(RuntimeException.class, () -> run("taken", plan, Detail.STEPS));
    Files.delete(out.resolve("summary.json"));
    assertTrue(names(run("taken", plan, Detail.STEPS)).contains("summary.json"));
  }

  private static JsonNode json(Path file) throws IOException {
    return new ObjectMapper().readTree(file.toFile());
  }
}
