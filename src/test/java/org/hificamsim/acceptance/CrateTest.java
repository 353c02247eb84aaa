package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that folders of results contain their inputs and are RO-Crates 1.1. */
class CrateTest {
  private static final String CRATE = "ro-crate-metadata.json";

  @TempDir Path folder;

  @Test
  void runListsFilesWithHashes() throws Exception {
    Path out = folder.resolve("run");
    command("run", Cli.scenario("ring-random"), "--steps", 5, "--record", "--out", out);
    Map<String, JsonNode> entities = entities(out);
    Set<String> files = files(out);
    assertTrue(files.containsAll(List.of("steps.csv", "report.html", "scenario-ring-random.xml")));
    files.remove(CRATE);
    assertEquals(files, references(entities.get("./").get("hasPart")));
    for (String file : files) {
      byte[] content = Files.readAllBytes(out.resolve(file));
      JsonNode entity = entities.get(file);
      assertEquals("File", entity.get("@type").asText());
      assertEquals(sha256(content), entity.get("sha256").asText(), file);
      assertEquals(content.length, entity.get("contentSize").asInt());
    }
  }

  @Test
  void runNamesCommandProgramAndInputs() throws Exception {
    Path out = folder.resolve("run");
    command(
        "run", Cli.scenario("ring-random"), "--seed", 7, "--repeat", 3, "--steps", 5, "--out", out);
    Map<String, JsonNode> entities = entities(out);
    JsonNode action = entities.get("#run");
    assertTrue(action.get("description").asText().startsWith("./hificamsim run "));
    assertFalse(
        Instant.parse(action.get("endTime").asText())
            .isBefore(Instant.parse(action.get("startTime").asText())));
    assertEquals("Thesis", entities.get("#thesis").get("@type").asText());
    assertEquals("#hificamsim", action.get("instrument").get("@id").asText());
    assertTrue(entities.get("#hificamsim").hasNonNull("softwareVersion"));
    assertTrue(
        references(action.get("object"))
            .containsAll(List.of("scenario-ring-random.xml", "detection-hifi-orb-lin.json")));
  }

  @Test
  void copiedScenarioGivesSameResults() throws Exception {
    Path first = folder.resolve("first");
    command(
        "run", Cli.scenario("cluster-random"), "--order", "camsim", "--steps", 40, "--out", first);
    Path again = folder.resolve("again");
    Path scenario = folder.resolve("cluster-random.xml");
    Files.copy(first.resolve("scenario-cluster-random.xml"), scenario);
    command(
        "run",
        scenario,
        "--detection",
        first.resolve("detection-hifi-orb-lin.json"),
        "--steps",
        40,
        "--out",
        again);
    for (String file : List.of("steps.csv", "summary.json", "scenario-cluster-random.xml")) {
      String before = Files.readString(first.resolve(file));
      String detectedByOption =
          before.replace("detection_from\" : \"default", "detection_from\" : \"option");
      assertEquals(detectedByOption, Files.readString(again.resolve(file)));
    }
  }

  @Test
  void comparisonsAreCrates() throws Exception {
    Path out = folder.resolve("compare");
    command(
        "compare",
        Cli.scenario("ring-random"),
        Cli.scenario("lattice-random"),
        "--steps",
        5,
        "--repeat",
        2,
        "--latex",
        "--out",
        out);
    Set<String> inputs = references(entities(out).get("#run").get("object"));
    assertTrue(
        inputs.containsAll(List.of("scenario-ring-random.xml", "scenario-lattice-random.xml")));
    assertTrue(files(out).contains("summary.tex"));
    Path sensitivity = SensitivityCommandTest.swept().folder();
    assertEquals(Set.of(), missing(entities(sensitivity)), "what is referred to but not described");
  }

  @Test
  void omitsFilesOfEarlierRun() throws Exception {
    Path out = folder.resolve("run");
    command("run", Cli.scenario("ring-random"), "--steps", 5, "--out", out);
    Files.writeString(out.resolve("notes.txt"), "mine");
    command("run", Cli.scenario("lattice-random"), "--steps", 5, "--out", out);
    Set<String> parts = references(entities(out).get("./").get("hasPart"));
    assertTrue(parts.contains("scenario-lattice-random.xml"));
    assertFalse(parts.contains("notes.txt"));
    assertFalse(parts.contains("scenario-ring-random.xml"));
  }

  @Test
  void removesFilesOfEarlierComparison() throws Exception {
    Path out = folder.resolve("compare");
    List<Object> words = new ArrayList<>(List.of("compare", "--steps", 5, "--repeat", 2));
    words.addAll(List.of("--out", out, Cli.scenario("ring-random")));
    command(Stream.concat(words.stream(), Stream.of("--latex")).toArray());
    Files.writeString(out.resolve("notes.txt"), "mine");
    assertTrue(files(out).containsAll(List.of("summary.tex", "scenario-ring-random.xml")));
    words.set(words.size() - 1, Cli.scenario("lattice-random"));
    command(words.toArray());
    Set<String> files = files(out);
    assertTrue(files.remove("notes.txt"));
    assertTrue(files.remove("scenario-ring-random.xml"));
    assertTrue(files.remove(CRATE));
    assertEquals(files, references(entities(out).get("./").get("hasPart")));
    assertFalse(Files.readString(out.resolve("report.html")).contains("ring-random"));
  }

  /** The copies of inputs are there to be run again, perhaps into the same folder. */
  @Test
  void keepsInputInTheFolder() throws Exception {
    Path out = folder.resolve("run");
    command("run", Cli.scenario("ring-random"), "--steps", 5, "--out", out);
    Path input = out.resolve("scenario-ring-random.xml");
    byte[] content = Files.readAllBytes(input);
    command("run", input, "--steps", 5, "--out", out);
    assertArrayEquals(content, Files.readAllBytes(input));
  }

  @Test
  void runAfterComparisonHasItsOwnPage() throws Exception {
    Path out = folder.resolve("compare");
    command("compare", Cli.scenario("ring-random"), "--steps", 5, "--repeat", 2, "--out", out);
    command("run", Cli.scenario("ring-random"), "--steps", 5, "--record", "--out", out);
    assertFalse(files(out).contains("summary.csv"));
    assertTrue(Files.readString(out.resolve("report.html")).contains("runPage("));
  }

  private static void command(Object... words) {
    Cli cli = Cli.run(words);
    assertEquals(0, cli.exit(), cli.err());
  }

  /** The entities by identifier, checked as the specification demands. */
  private static Map<String, JsonNode> entities(Path out) throws IOException {
    JsonNode crate = new ObjectMapper().readTree(out.resolve(CRATE).toFile());
    assertEquals("https://w3id.org/ro/crate/1.1/context", crate.at("/@context/0").asText());
    Map<String, JsonNode> entities = new TreeMap<>();
    for (JsonNode entity : crate.get("@graph")) {
      assertTrue(entity.hasNonNull("@type"), entity.toString());
      assertEquals(null, entities.put(entity.get("@id").asText(), entity), "twice: " + entity);
    }
    JsonNode descriptor = entities.get(CRATE);
    assertEquals("CreativeWork", descriptor.get("@type").asText());
    assertEquals("./", descriptor.get("about").get("@id").asText());
    assertEquals("https://w3id.org/ro/crate/1.1", descriptor.get("conformsTo").get("@id").asText());
    JsonNode root = entities.get("./");
    assertEquals("Dataset", root.get("@type").asText());
    Instant.parse(root.get("datePublished").asText());
    for (String name : List.of("name", "description", "license")) {
      assertTrue(root.hasNonNull(name), name);
    }
    assertEquals(Set.of(), missing(entities));
    return entities;
  }

  /**
   * Returns the files that the crate refers to but that are missing; web addresses do not count.
   */
  private static Set<String> missing(Map<String, JsonNode> entities) {
    Set<String> all = new TreeSet<>();
    entities.values().forEach(entity -> entity.forEach(value -> all.addAll(references(value))));
    all.removeIf(id -> id.startsWith("https://") || entities.containsKey(id));
    return all;
  }

  private static Set<String> references(JsonNode node) {
    Set<String> ids = new HashSet<>();
    List<JsonNode> all = new ArrayList<>();
    (node.isArray() ? node : new ObjectMapper().createArrayNode().add(node)).forEach(all::add);
    all.stream()
        .filter(entity -> entity.has("@id"))
        .forEach(entity -> ids.add(entity.get("@id").asText()));
    return ids;
  }

  private static Set<String> files(Path out) throws IOException {
    try (Stream<Path> files = Files.list(out)) {
      Set<String> names = new HashSet<>();
      files.forEach(file -> names.add(file.getFileName().toString()));
      assertTrue(names.remove(".hificamsim.sha256"), "the record of what was written");
      return names;
    }
  }

  private static String sha256(byte[] content) throws Exception {
    return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content));
  }
}
