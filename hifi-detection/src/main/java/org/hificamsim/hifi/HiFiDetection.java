package org.hificamsim.hifi;

import java.util.Optional;
import org.hificamsim.core.detection.Scatter;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.optics.Optics;

/**
 * The high-fidelity detection model: confidence {@code g(f(q, d, z))} (thesis 3.4, Table 6.1), with
 * any feature abstraction f and any detector model g. It looks at size, distance and zoom, and not
 * at the bearing.
 *
 * @param name the name on the command line and in result files
 * @param f predicts the share of the image that the target fills
 * @param g turns that share into a confidence
 * @param optics gives the zoom level's focal length
 * @param defaultThreshold the confidence from which a target counts as detected
 * @param residuals how measured confidences scatter about g, where it is known
 * @param fitted what the numbers were fitted on, where it is known
 * @param provenance where the numbers come from
 */
public record HiFiDetection(
    String name,
    FeatureAbstraction f,
    DetectorModel g,
    Optics optics,
    double defaultThreshold,
    Optional<Residuals> residuals,
    Optional<FittedOn> fitted,
    Provenance provenance)
    implements OpticalDetection {
  /** The same under another name. */
  public HiFiDetection named(String other) {
    return new HiFiDetection(other, f, g, optics, defaultThreshold, residuals, fitted, provenance);
  }

  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    return g.confidence(f.pip(size, distance, optics.focalLength(zoom)));
  }

  /** The fit's own scatter, about the confidence where no target is in the image. */
  @Override
  public Optional<Scatter> scatter() {
    return residuals.map(one -> one.about(g));
  }
}
