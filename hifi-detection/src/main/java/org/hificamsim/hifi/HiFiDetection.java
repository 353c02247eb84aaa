package org.hificamsim.hifi;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.detection.Conditions;
import org.hificamsim.core.detection.Scatter;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.optics.Optics;

/**
 * The high-fidelity detection model: confidence {@code g(f(q, d, z))} (thesis 3.4, Table 6.1), with
 * any feature abstraction f and any detector model g. It looks at size, distance and zoom, and not
 * at the bearing; with {@linkplain CovariateTerm covariates} (chapter 9) at the camera's
 * conditions, too.
 *
 * @param name the name on the command line and in result files
 * @param f predicts the share of the image that the target fills
 * @param g turns that share into a confidence
 * @param covariates what conditions do to the share, each condition once
 * @param optics gives the zoom level's focal length
 * @param defaultThreshold the confidence from which a target counts as detected
 * @param rmse root mean squared error of the confidences about g, above 0, where it is known
 * @param fitted what the numbers were fitted on, where it is known
 * @param provenance where the numbers come from
 */
public record HiFiDetection(
    String name,
    FeatureAbstraction f,
    DetectorModel g,
    List<CovariateTerm> covariates,
    Optics optics,
    double defaultThreshold,
    OptionalDouble rmse,
    Optional<FittedOn> fitted,
    Provenance provenance)
    implements OpticalDetection {
  /** Puts conditions into the one order. */
  public HiFiDetection {
    covariates =
        covariates.stream().sorted(Comparator.comparing(CovariateTerm::condition)).toList();
  }

  /** A model without covariates. */
  public HiFiDetection(
      String name,
      FeatureAbstraction f,
      DetectorModel g,
      Optics optics,
      double defaultThreshold,
      OptionalDouble rmse,
      Optional<FittedOn> fitted,
      Provenance provenance) {
    this(name, f, g, List.of(), optics, defaultThreshold, rmse, fitted, provenance);
  }

  /** A model of which it is not known what it was fitted on. */
  public HiFiDetection(
      String name,
      FeatureAbstraction f,
      DetectorModel g,
      Optics optics,
      double defaultThreshold,
      OptionalDouble rmse,
      Provenance provenance) {
    this(name, f, g, optics, defaultThreshold, rmse, Optional.empty(), provenance);
  }

  /** A model of whose fit no scatter is known. */
  public HiFiDetection(
      String name,
      FeatureAbstraction f,
      DetectorModel g,
      Optics optics,
      double defaultThreshold,
      Provenance provenance) {
    this(name, f, g, optics, defaultThreshold, OptionalDouble.empty(), provenance);
  }

  /** The same under another name. */
  public HiFiDetection named(String other) {
    return new HiFiDetection(
        other, f, g, covariates, optics, defaultThreshold, rmse, fitted, provenance);
  }

  @Override
  public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
    double pip = f.pip(size, distance, optics.focalLength(zoom));
    return g.confidence(covariates.isEmpty() ? pip : pip * factor(zoom.conditions()));
  }

  /** How many times as large a target's share counts under these conditions. */
  public double factor(Conditions conditions) {
    double shift = 0;
    for (CovariateTerm term : covariates) {
      shift += term.shift(conditions);
    }
    return StrictMath.exp(shift);
  }

  /** The fit's own scatter (Table 6.1), about the confidence where no target is in the image. */
  @Override
  public Optional<Scatter> scatter() {
    return rmse.isPresent()
        ? Optional.of(new Scatter(g.confidence(0), rmse.getAsDouble()))
        : Optional.empty();
  }
}
