package org.hificamsim.presentation.report;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.Deflater;
import org.hificamsim.presentation.replay.Deflated;

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
      String data = Deflated.base64(Deflater.BEST_COMPRESSION, out -> Files.copy(file, out));
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
}
