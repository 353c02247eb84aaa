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
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.RunPlan;

/**
 * Writes {@code ro-crate-metadata.json}, which describes a folder of results as an RO-Crate 1.1:
 * the command, the program, the inputs, and each file. The settings are in the files that it names.
 * It is written after all other files, and contains times like {@code manifest.json}. The parts
 * that all crates have in common are in the resource {@code crate.json}.
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

  private CrateFile() {}

  /**
   * Adds the file to those of a folder that are to be committed; {@code manifest.json} has to be
   * among them.
   *
   * @param plans the plans that were run
   */
  public static void write(OutputFolder folder, List<RunPlan> plans) throws IOException {
    JsonNode crate = new ObjectMapper().readTree(Io.resource(CrateFile.class, "crate.json"));
    ArrayNode graph = (ArrayNode) crate.get("@graph");
    ResultFolder drafts = new ResultFolder(folder.drafts());
    JsonNode manifest = drafts.json(ResultFolder.MANIFEST);
    Map<String, String> hashes = folder.hashes();
    String commandName = manifest.path("command").path(0).asText();
    ObjectNode root = entity(graph, "./");
    root.put("name", "HiFi-CamSim: " + commandName + " of " + scenarios(plans));
    root.put("description", description(plans) + ". Made with: " + drafts.command());
    root.put("datePublished", manifest.path("started").asText());
    refer(root.putArray("hasPart"), hashes.keySet().stream());
    ObjectNode action = entity(graph, "#run"); // defined by the profile "Process Run Crate"
    action.put("name", "hificamsim " + commandName);
    action.put("description", drafts.command());
    describe(action, manifest, hashes.keySet());
    ObjectNode program = entity(graph, "#hificamsim");
    program.put("softwareVersion", drafts.version());
    if (manifest.has("commit")) {
      program.put("identifier", "git commit " + manifest.path("commit").asText());
    }
    for (String name : hashes.keySet()) {
      long size = Files.size(drafts.path().resolve(name));
      describe(graph.addObject().put("@id", id(name)), name, size).put("sha256", hashes.get(name));
    }
    folder.write(ResultFolder.CRATE, crate.toPrettyString() + "\n");
  }

  private static void describe(ObjectNode action, JsonNode manifest, Set<String> files) {
    Instant started = Instant.parse(manifest.path("started").asText());
    long millis = Math.round(1000 * manifest.path("seconds").asDouble());
    action.put("startTime", started.toString());
    action.put("endTime", started.plusMillis(millis).toString());
    refer(action.putArray("object"), files.stream().filter(InputFiles::isInput));
    refer(action.putArray("result"), files.stream().filter(name -> !InputFiles.isInput(name)));
  }

  private static ObjectNode describe(ObjectNode file, String name, long size) {
    String ending = name.substring(name.lastIndexOf('.') + 1);
    return file.put("@type", "File")
        .put("name", name)
        .put("encodingFormat", FORMATS.getOrDefault(ending, "application/octet-stream"))
        .put("contentSize", String.valueOf(size));
  }

  private static ObjectNode entity(ArrayNode graph, String id) {
    for (JsonNode entity : graph) {
      if (entity.path("@id").asText().equals(id)) {
        return (ObjectNode) entity;
      }
    }
    throw new IllegalStateException(id);
  }

  private static String scenarios(List<RunPlan> plans) {
    return list(plans.stream().map(plan -> plan.scenario().name()));
  }

  private static String description(List<RunPlan> plans) {
    return "Detections: "
        + list(plans.stream().map(plan -> plan.detection().name()))
        + ". Policies: "
        + list(plans.stream().map(RunPlan::policy));
  }

  private static String list(Stream<String> values) {
    return values.distinct().collect(Collectors.joining(", "));
  }

  private static void refer(ArrayNode list, Stream<String> files) {
    files.forEach(name -> list.addObject().put("@id", id(name)));
  }

  /** Writes a name as a relative URI reference. */
  private static String id(String name) {
    try {
      return new URI(null, null, "/" + name, null).getRawPath().substring(1);
    } catch (URISyntaxException e) {
      throw new IllegalArgumentException(e);
    }
  }
}
