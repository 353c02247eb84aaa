package org.hificamsim.runs.output;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.NumericNode;
import java.io.IOException;
import org.hificamsim.core.file.OutputFolder;

/** Writes JSON files: indented, with a line end at the end. */
public final class JsonOutput {
  /** The number up to which doubles represent every whole number exactly. */
  private static final double MAX_WHOLE = 1L << 53;

  private JsonOutput() {}

  /** Adds a file to a folder's files. */
  public static void write(OutputFolder folder, String name, JsonNode content) throws IOException {
    folder.write(name, text(content));
  }

  /** The text of a file. */
  static String text(JsonNode content) {
    return content.toPrettyString() + "\n";
  }

  /** A number, without a fraction if it is whole. */
  static NumericNode number(double value) {
    boolean isWhole = value == Math.rint(value) && Math.abs(value) < MAX_WHOLE;
    return isWhole
        ? JsonNodeFactory.instance.numberNode((long) value)
        : JsonNodeFactory.instance.numberNode(value);
  }
}
