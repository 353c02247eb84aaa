package org.hificamsim.presentation.report;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/** The pictures (SVG) of a folder, compressed for a page. */
final class Pictures {
  private static final int MAX_BYTES = 3_000_000;

  private Pictures() {}

  /**
   * Each picture's {@code name} and {@code data} (zlib in Base64); no data once they are too many.
   */
  static ArrayNode of(Path folder) throws IOException {
    ArrayNode pictures = new ObjectMapper().createArrayNode();
    int bytes = 0;
    for (Path file : files(folder)) {
      String data = deflated(file);
      bytes += data.length();
      ObjectNode picture = pictures.addObject();
      picture.put("name", file.getFileName().toString());
      picture.put("data", bytes <= MAX_BYTES ? data : "");
    }
    return pictures;
  }

  private static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> all = Files.list(folder)) {
      return all.filter(file -> file.getFileName().toString().endsWith(".svg")).sorted().toList();
    }
  }

  private static String deflated(Path file) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (OutputStream out =
        new DeflaterOutputStream(bytes, new Deflater(Deflater.BEST_COMPRESSION))) {
      Files.copy(file, out);
    }
    return Base64.getEncoder().encodeToString(bytes.toByteArray());
  }
}
