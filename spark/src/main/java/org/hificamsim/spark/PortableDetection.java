package org.hificamsim.spark;

import java.io.IOException;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.model.ModelFiles;

/**
 * A detection model and its threshold as text.
 *
 * @param name in result files
 * @param model the name in the catalogue, or the content of a model file
 * @param isFile which of the two it is
 */
record PortableDetection(String name, String model, boolean isFile, double threshold)
    implements Serializable {
  static PortableDetection of(Detection detection, Catalogue catalogue) {
    DetectionModel model = detection.model();
    boolean isFile = model instanceof HiFiDetection && !isOf(catalogue, model);
    return new PortableDetection(
        detection.name(),
        isFile ? write((HiFiDetection) model) : model.name(),
        isFile,
        detection.threshold());
  }

  /** The detection with the same values. */
  Detection detection(Catalogue catalogue) {
    DetectionModel made = isFile ? read() : catalogue.detections().create(model);
    return new Detection(name, made, threshold);
  }

  private static boolean isOf(Catalogue catalogue, DetectionModel model) {
    return catalogue.detections().knows(model.name())
        && catalogue.detections().create(model.name()).equals(model);
  }

  private static String write(HiFiDetection model) {
    try (TemporaryFile file = new TemporaryFile("model.json")) {
      ModelFiles.write(model, file.path());
      return Files.readString(file.path());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private DetectionModel read() {
    try (TemporaryFile file = new TemporaryFile("model.json")) {
      Path written = Files.writeString(file.path(), model);
      return ModelFiles.read(written);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
