package org.hificamsim.profiling.measure;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The measurements of one photo.
 *
 * @param image the photo's name in the data set
 * @param object the object that it shows
 * @param size q, in metres
 * @param distance d, in metres
 * @param focalLength z, in metres
 * @param pip the true share of the image's pixels that the object fills, (0, 1]
 * @param confidences the confidence of each detector, in [0, 1] (Eq 5.1)
 */
public record Measurement(
    String image,
    String object,
    double size,
    double distance,
    double focalLength,
    double pip,
    Map<String, Double> confidences) {
  public Measurement {
    confidences = Collections.unmodifiableMap(new LinkedHashMap<>(confidences));
  }

  /** Returns the response of the regressions, {@code -log10(PIP)} (thesis 4.3). */
  public double response() {
    return -StrictMath.log10(pip);
  }

  /** Returns the responses of all photos. */
  public static double[] responses(List<Measurement> photos) {
    return photos.stream().mapToDouble(Measurement::response).toArray();
  }

  /** Returns the predictors of all photos, each row in the order q, d, z. */
  public static double[][] predictors(List<Measurement> photos) {
    return photos.stream()
        .map(photo -> new double[] {photo.size, photo.distance, photo.focalLength})
        .toArray(double[][]::new);
  }

  /** Returns the confidence of a detector. */
  public double confidence(String detector) {
    return confidences.get(detector);
  }

  /** Returns a copy with one more detector as the last one. */
  public Measurement with(String detector, double confidence) {
    Map<String, Double> extended = new LinkedHashMap<>(confidences);
    extended.put(detector, confidence);
    return new Measurement(image, object, size, distance, focalLength, pip, extended);
  }
}
