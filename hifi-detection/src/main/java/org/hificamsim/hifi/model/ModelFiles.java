package org.hificamsim.hifi.model;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.core.util.Separators;
import com.fasterxml.jackson.databind.ObjectWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.json.JsonFile;

/**
 * Users' detection models in JSON files: what {@code profile fit} writes, what {@code --detection
 * FILE.json} reads, and what people edit by hand.
 *
 * <p>{@code optics}, {@code threshold}, {@code units} and {@code provenance} may be left out: the
 * lab's camera, the threshold that the catalogue derives from the line, metres, and nothing known.
 */
public final class ModelFiles {
  /** The largest file that is read. */
  public static final int MAX_BYTES = 16 << 20;

  private static final DefaultIndenter LINES = new DefaultIndenter("  ", "\n");
  private static final int ROWS_LEVEL = 3;
  private static final ObjectWriter WRITER = ModelFormat.MAPPER.writer(printer());

  private ModelFiles() {}

  /**
   * The model in a file.
   *
   * @throws InputException in one line with file, line and column, when it is no valid model
   */
  public static HiFiDetection read(Path file) {
    return JsonFile.read(file, "a model in JSON", MAX_BYTES).whole(ModelFormat::read);
  }

  /**
   * Writes a model that {@link #read} will read as an equal one. Until the whole file is there, its
   * name holds what it held before.
   *
   * @throws IllegalArgumentException when the model has a number or name that no file may hold
   * @throws InputException when the file cannot be written
   */
  public static void write(HiFiDetection model, Path file) {
    byte[] bytes = bytes(model);
    try {
      new OutputFile(file).write(out -> out.write(bytes));
    } catch (IOException e) {
      throw new InputException(
          file + ": cannot be written (" + e + "), expected a writable place", e);
    }
  }

  /**
   * The model in a file's content.
   *
   * @param file its name, for error lines
   */
  public static HiFiDetection parse(String file, byte[] bytes) {
    return JsonFile.parse(file, bytes).whole(ModelFormat::read);
  }

  /**
   * The content of a file of a model, which {@link #parse} will read as an equal one.
   *
   * @throws IllegalArgumentException when the model has a number or name that no file may hold
   */
  public static byte[] bytes(HiFiDetection model) {
    try {
      String text = WRITER.writeValueAsString(ModelFormat.json(model)) + "\n";
      byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
      if (parse(model.name(), bytes).equals(model)) {
        return bytes;
      }
    } catch (InputException | IOException e) {
      throw new IllegalArgumentException("no file can hold this model: " + e.getMessage(), e);
    }
    throw new IllegalArgumentException("no file can hold this model: " + model);
  }

  /** One property a line. */
  private static DefaultPrettyPrinter printer() {
    DefaultPrettyPrinter printer =
        new DefaultPrettyPrinter(
            Separators.createDefaultInstance()
                .withObjectFieldValueSpacing(Separators.Spacing.AFTER));
    printer.indentObjectsWith(LINES);
    printer.indentArraysWith(new RowIndenter());
    return printer;
  }

  /** Puts each row of a table on a line of its own, and its cells side by side. */
  private static final class RowIndenter extends DefaultPrettyPrinter.NopIndenter {
    private static final long serialVersionUID = 1L;

    @Override
    public void writeIndentation(JsonGenerator json, int level) throws IOException {
      if (level < ROWS_LEVEL || !json.getOutputContext().getParent().inArray()) {
        LINES.writeIndentation(json, level);
      }
    }

    @Override
    public boolean isInline() {
      return false;
    }
  }
}
