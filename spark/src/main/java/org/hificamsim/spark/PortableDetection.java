package org.hificamsim.spark;

import java.io.Serializable;
import java.nio.charset.StandardCharsets;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.model.ModelFiles;

/**
 * A detection model and its threshold as text.
 *
 * @param name in result files
 * @param model the content of a model file, or the name in the catalogue of a model that is code
 * @param isFile which of the two it is
 * @param rule how a value becomes a detection
 */
record PortableDetection(String name, String model, boolean isFile, double threshold, String rule)
    implements Serializable {
  static PortableDetection of(Detection detection) {
    boolean isFile = detection.model() instanceof HiFiDetection;
    String model =
        detection.model() instanceof HiFiDetection fitted
            ? new String(ModelFiles.bytes(fitted), StandardCharsets.UTF_8)
            : detection.model().name();
    return new PortableDetection(
        detection.name(), model, isFile, detection.threshold(), detection.rule().text());
  }

  /** The detection with the same values. */
  Detection detection(Catalogue catalogue) {
    DetectionModel made =
        isFile
            ? ModelFiles.parse(name, model.getBytes(StandardCharsets.UTF_8))
            : catalogue.detections().create(model);
    DetectionRule decides = DetectionRule.parse(rule);
    return decides.certain()
        ? new Detection(name, made, threshold)
        : Detection.by(decides, name, made);
  }
}
