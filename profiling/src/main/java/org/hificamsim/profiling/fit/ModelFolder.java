package org.hificamsim.profiling.fit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.hifi.model.ModelFiles;

/**
 * Writes every combination of f and g as a model file that {@code run --detection} takes: {@code
 * <detector>-<f>.json} with the g on f's own predictions, {@code <detector>-<f>-gt.json} with the g
 * on measured PIP. What is refused has no file, and loses the one of an earlier fit.
 *
 * @param folder where the files go
 * @param prefix of the models' names, before a colon
 */
public record ModelFolder(Path folder, String prefix) {
  /** Writes all models that are one; returns how many. */
  public int write(FitResult result) {
    try {
      Files.createDirectories(folder);
      int written = 0;
      for (FittedModel model : FittedModel.all(result)) {
        Path file = folder.resolve(model.name() + ".json");
        if (model.fit().refused()) {
          Files.deleteIfExists(file);
        } else {
          ModelFiles.write(model.detection(prefix), file);
          written++;
        }
      }
      return written;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
