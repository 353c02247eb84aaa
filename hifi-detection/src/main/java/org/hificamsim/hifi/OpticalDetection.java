package org.hificamsim.hifi;

import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.hifi.optics.Optics;

/** A detection model with optics, which give each zoom level a focal length. */
public interface OpticalDetection extends DetectionModel {
  /** Returns the camera's sensor and lens. */
  Optics optics();
}
