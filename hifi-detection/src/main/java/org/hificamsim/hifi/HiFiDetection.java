package org.hificamsim.hifi;

import java.util.Optional;
import org.hificamsim.core.detection.Scatter;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.optics.Optics;

/**
 * The high-fidelity detection model: confidence {@code g(f(q, d, z))} (thesis 3.4, Table 6.1), with
 * any feature abstraction f and any detector model g. It depends on size, distance and zoom, not on
 * the bearing.
 *
 * @param name the name on the command line and in result files
 * @param f predicts the share of the image that the target fills
 * @param g turns that share into a confidence
 * @param optics determine the focal length of a zoom level
 * @param defaultThreshold the confidence from which a target counts as detected
 * @param residuals how measured confidences scatter about g, if known
 * @param fitted the data that the numbers were fitted on, if known
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
    implements FittedDetection {
  @Override
  public HiFiDetection named(String newName) {
    return new HiFiDetection(
        newName, f, g, optics, defaultThreshold, residuals, fitted, provenance);
  }

  @Override
  public String equation() {
    return "g(p) = " + g.equation();
  }

  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    return g.confidence(f.pip(size, distance, optics.focalLength(zoom)));
  }

  /** Returns the scatter of the fit, which starts from the confidence at a PIP of 0. */
  @Override
  public Optional<Scatter> scatter() {
    return residuals.map(known -> known.about(g));
  }
}
