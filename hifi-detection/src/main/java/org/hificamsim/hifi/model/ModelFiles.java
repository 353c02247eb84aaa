package org.hificamsim.hifi.model;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.core.util.Separators;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.ObjectWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.hifi.FittedDetection;
import org.hificamsim.hifi.json.JsonFile;

/**
 * Reads and writes users' detection models as JSON files, such as {@code profile fit} writes.
 *
 * <p>{@code optics}, {@code threshold}, {@code units} and {@code provenance} may be left out. The
 * defaults are the lab's camera, the threshold that the catalogue derives from the line, in metres,
 * and an unknown provenance.
 */
public final class ModelFiles {
  /** The size of the largest file that is read. */
  public static final int MAX_BYTES = 16 << 20;

  /**
   * The mapper of models' files. It is not in {@link ModelFormat}, since published models are read
   * in half the time without it.
   */
  static final ObjectMapper MAPPER = new ObjectMapper();

  private static final DefaultIndenter LINES = new DefaultIndenter("  ", "\n");
  private static final int ROW_NESTING = 3;
  private static final ObjectWriter WRITER = MAPPER.writer(printer());

  private ModelFiles() {}

  /**
   * Reads the model in a file.
   *
   * @throws InputException in one line with file, line and column, when it is not a valid model
   */
  public static FittedDetection read(Path file) {
    return JsonFile.read(file, "a model in JSON", MAX_BYTES).readWhole(ModelFormat::read);
  }

  /**
   * Writes a model, which {@link #read} returns equal. An older file is replaced only when the new
   * one is complete.
   *
   * @throws IllegalArgumentException when a number or the name of the model is not allowed in files
   * @throws InputException when the file cannot be written
   */
  public static void write(FittedDetection model, Path file) {
    byte[] bytes = bytes(model);
    try {
      new OutputFile(file).write(out -> out.write(bytes));
    } catch (IOException e) {
      throw new InputException(
          file + ": cannot be written (" + e + "), expected a writable place", e);
    }
  }

  /**
   * Reads the model in a file's content.
   *
   * @param file the file's name, for error messages
   */
  public static FittedDetection parse(String file, byte[] bytes) {
    return JsonFile.parse(file, bytes).readWhole(ModelFormat::read);
  }

  /**
   * Returns the content of a model file, from which {@link #parse} reads an equal model.
   *
   * @throws IllegalArgumentException when a number or the name of the model is not allowed in files
   */
  public static byte[] bytes(FittedDetection model) {
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

  /** Writes each property on its own line. */
  private static DefaultPrettyPrinter printer() {
    DefaultPrettyPrinter printer =
        new DefaultPrettyPrinter(
            Separators.createDefaultInstance()
                .withObjectFieldValueSpacing(Separators.Spacing.AFTER));
    printer.indentObjectsWith(LINES);
    printer.indentArraysWith(new RowIndenter());
    return printer;
  }

  /** Writes each row of a table on its own line. */
  private static final class RowIndenter extends DefaultPrettyPrinter.NopIndenter {
    private static final long serialVersionUID = 1L;

    @Override
    public void writeIndentation(JsonGenerator json, int level) throws IOException {
      if (level < ROW_NESTING || !json.getOutputContext().getParent().inArray()) {
        LINES.writeIndentation(json, level);
      }
    }

    @Override
    public boolean isInline() {
      return false;
    }
  }
}
