package org.hificamsim.runs.output;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.runs.RunPlan;

/**
 * Writes {@code ro-crate-metadata.json}: a folder of results as an RO-Crate 1.1, which says what
 * was run, with what, on which input, and what each file holds. It is made last, of the files that
 * are there; like {@code manifest.json} it has times in it. What is the same in all crates is the
 * resource {@code crate.json}.
 */
public final class CrateFile {
  private static final Map<String, String> FORMATS =
      Map.ofEntries(
          Map.entry("csv", "text/csv"),
          Map.entry("gz", "application/gzip"),
          Map.entry("html", "text/html"),
          Map.entry("json", "application/json"),
          Map.entry("parquet", "application/vnd.apache.parquet"),
          Map.entry("pdf", "application/pdf"),
          Map.entry("png", "image/png"),
          Map.entry("svg", "image/svg+xml"),
          Map.entry("tex", "application/x-tex"),
          Map.entry("xml", "application/xml"));

  private final JsonNode crate;
  private final ArrayNode graph;
  private final ResultFolder folder;
  private final JsonNode manifest;

  private CrateFile(ResultFolder folder) throws IOException {
    this.folder = folder;
    this.manifest = folder.json(ResultFolder.MANIFEST);
    this.crate = new ObjectMapper().readTree(Io.resource(CrateFile.class, "crate.json"));
    this.graph = (ArrayNode) crate.get("@graph");
  }

  /**
   * Adds the file to those of a folder that are to be committed, {@code manifest.json} among them.
   *
   * @param plans that were run
   */
  public static void write(OutputFolder folder, List<RunPlan> plans) throws IOException {
    CrateFile file = new CrateFile(new ResultFolder(folder.drafts()));
    file.describe(folder.hashes(), plans);
    folder.write(ResultFolder.CRATE, file.crate.toPrettyString() + "\n");
  }

  private void describe(Map<String, String> hashes, List<RunPlan> plans) throws IOException {
    List<String> files = List.copyOf(hashes.keySet());
    root(files, plans);
    List<Detection> detections = plans.stream().map(RunPlan::detection).distinct().toList();
    action(files, detections.size());
    detections(detections);
    program();
    settings(plans);
    for (Map.Entry<String, String> file : hashes.entrySet()) {
      file(file.getKey(), file.getValue());
    }
  }

  /** A file of results with its size and hash. */
  private void file(String name, String sha256) throws IOException {
    String ending = name.substring(name.lastIndexOf('.') + 1);
    entity(id(name), "File")
        .put("name", name)
        .put("encodingFormat", FORMATS.getOrDefault(ending, "application/octet-stream"))
        .put("contentSize", String.valueOf(Files.size(folder.path().resolve(name))))
        .put("sha256", sha256);
  }

  private void root(List<String> files, List<RunPlan> plans) throws IOException {
    ObjectNode root = entity("./", "Dataset");
    String scenarios = list(plans.stream().map(plan -> plan.scenario().name()).toList());
    root.put("name", "HiFi-CamSim: " + word(0) + " of " + scenarios);
    root.put(
        "description",
        "Detections: "
            + list(plans.stream().map(plan -> plan.detection().name()).toList())
            + ". Policies: "
            + list(plans.stream().map(RunPlan::policy).toList())
            + ". Made with: "
            + folder.command());
    root.put("datePublished", manifest.path("started").asText());
    refer(root.putObject("license"), "#licence");
    refer(root.putObject("citation"), "#thesis");
    refer(root.putObject("mentions"), "#run");
    refer(root.putArray("hasPart"), files);
  }

  /** What the command did, as the profile "Process Run Crate" has it. */
  private void action(List<String> files, int detections) throws IOException {
    ObjectNode action = entity("#run", "CreateAction");
    action.put("name", "hificamsim " + word(0));
    action.put("description", folder.command());
    Instant started = Instant.parse(manifest.path("started").asText());
    long millis = Math.round(1000 * manifest.path("seconds").asDouble());
    action.put("startTime", started.toString());
    action.put("endTime", started.plusMillis(millis).toString());
    refer(action.putObject("instrument"), "#hificamsim");
    ArrayNode inputs = action.putArray("object");
    refer(inputs, files.stream().filter(InputFiles::isInput).toList());
    refer(inputs, List.of("#seeds", "#steps", "#repeats"));
    refer(inputs, IntStream.rangeClosed(1, detections).mapToObj(i -> "#detection-" + i).toList());
    refer(
        action.putArray("result"),
        files.stream().filter(name -> !InputFiles.isInput(name)).toList());
  }

  private void program() throws IOException {
    ObjectNode program = entity("#hificamsim", "SoftwareApplication");
    program.put("name", "HiFi-CamSim");
    program.put("softwareVersion", folder.version());
    if (manifest.has("commit")) {
      program.put("identifier", "git commit " + manifest.path("commit").asText());
    }
    refer(program.putObject("softwareRequirements"), "#java");
    ObjectNode java = entity("#java", "SoftwareApplication");
    java.put("name", "Java virtual machine");
    java.put("softwareVersion", manifest.path("java").asText());
    java.put("operatingSystem", manifest.path("system").asText());
  }

  private void settings(List<RunPlan> plans) {
    value("#seeds", "seeds", span(plans.stream().mapToLong(RunPlan::seed), plans));
    value("#steps", "steps of each run", list(plans.stream().map(RunPlan::steps).toList()));
    value("#repeats", "runs of each case", list(plans.stream().map(RunPlan::repeats).toList()));
  }

  /** Each detection with its threshold, and where a fitted model's numbers come from. */
  private void detections(List<Detection> detections) {
    for (int i = 0; i < detections.size(); i++) {
      Detection one = detections.get(i);
      String source =
          one.model() instanceof HiFiDetection fitted ? fitted.provenance().source() : "";
      value("#detection-" + (i + 1), "detection " + one.name(), rule(one))
          .put("description", source.isEmpty() ? "a rule in the program" : "model from " + source);
    }
  }

  private static String rule(Detection detection) {
    return detection.certain()
        ? "threshold " + detection.threshold()
        : detection.rule().text() + ", half of the time at " + detection.threshold();
  }

  private static String span(LongStream first, List<RunPlan> plans) {
    long last = plans.stream().mapToLong(plan -> plan.seed(plan.repeats() - 1)).max().orElse(0);
    return first.min().orElse(0) + " to " + last;
  }

  private ObjectNode value(String id, String name, String value) {
    return entity(id, "PropertyValue").put("name", name).put("value", value);
  }

  private ObjectNode entity(String id, String type) {
    return graph.addObject().put("@id", id).put("@type", type);
  }

  private static void refer(ObjectNode node, String id) {
    node.put("@id", id);
  }

  private static void refer(ArrayNode list, List<String> names) {
    names.forEach(name -> refer(list.addObject(), name.startsWith("#") ? name : id(name)));
  }

  /** The name as a relative URI reference. */
  private static String id(String name) {
    try {
      return new URI(null, null, "/" + name, null).getRawPath().substring(1);
    } catch (URISyntaxException e) {
      throw new IllegalArgumentException(e);
    }
  }

  private String word(int i) {
    return manifest.path("command").path(i).asText();
  }

  private static String list(List<?> values) {
    return values.stream().distinct().map(String::valueOf).collect(Collectors.joining(", "));
  }
}
