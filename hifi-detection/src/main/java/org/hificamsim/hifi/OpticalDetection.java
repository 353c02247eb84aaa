package org.hificamsim.hifi;

import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.hifi.optics.Optics;

/** A detection model that looks through a lens: a zoom level has a focal length for it. */
public interface OpticalDetection extends DetectionModel {
  /** The camera's sensor and lens. */
  Optics optics();
}
