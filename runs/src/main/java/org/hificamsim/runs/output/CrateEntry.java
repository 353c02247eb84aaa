package org.hificamsim.runs.output;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

/** A file of results as an entity of an RO-Crate, with its size and SHA-256. */
final class CrateEntry {
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

  private CrateEntry() {}

  /** The entity of a file that exists, whose hash is known. */
  static ObjectNode of(Path file, String sha256) throws IOException {
    String name = file.getFileName().toString();
    ObjectNode entity = new ObjectMapper().createObjectNode();
    entity.put("@id", id(name)).put("@type", "File").put("name", name);
    String ending = name.substring(name.lastIndexOf('.') + 1);
    entity.put("encodingFormat", FORMATS.getOrDefault(ending, "application/octet-stream"));
    entity.put("contentSize", String.valueOf(Files.size(file)));
    entity.put("sha256", sha256);
    return entity;
  }

  /** The name as a relative URI reference. */
  static String id(String name) {
    try {
      return new URI(null, null, "/" + name, null).getRawPath().substring(1);
    } catch (URISyntaxException e) {
      throw new IllegalArgumentException(e);
    }
  }
}
