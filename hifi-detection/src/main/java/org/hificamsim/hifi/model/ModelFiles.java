package org.hificamsim.hifi.model;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
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

  private ModelFiles() {}

  /**
   * The model in a file.
   *
   * @throws InputException in one line with file, line and column, when it is no valid model
   */
  public static HiFiDetection read(Path file) {
    return ModelFormat.read(JsonFile.read(file, "a model in JSON", MAX_BYTES));
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

  /** The model in a resource of this class's package. */
  static HiFiDetection resource(String name) {
    try (InputStream in = ModelFiles.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new IllegalStateException("resource " + name + " is missing from this build");
      }
      return parse(name, in.readAllBytes());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * The model in a file's content.
   *
   * @param file its name, for error lines
   */
  public static HiFiDetection parse(String file, byte[] bytes) {
    return ModelFormat.read(JsonFile.parse(file, bytes));
  }

  /**
   * The content of a file of a model, which {@link #parse} will read as an equal one.
   *
   * @throws IllegalArgumentException when the model has a number or name that no file may hold
   */
  public static byte[] bytes(HiFiDetection model) {
    try {
      byte[] bytes = ModelWriter.bytes(model);
      if (parse(model.name(), bytes).equals(model)) {
        return bytes;
      }
    } catch (InputException | IOException e) {
      throw new IllegalArgumentException("no file can hold this model: " + e.getMessage(), e);
    }
    throw new IllegalArgumentException("no file can hold this model: " + model);
  }
}
