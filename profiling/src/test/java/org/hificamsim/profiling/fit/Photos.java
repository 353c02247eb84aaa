package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.measure.Measurement;

/** Synthetic measurements of a pinhole camera, with a known g, differing objects and noise. */
public final class Photos {
  /** The camera of the thesis. */
  public static final PhotoCamera CAMERA = new PhotoCamera(0.0224, 0.015, 1296, 864);

  private final Map<String, DoubleUnaryOperator> detectors = new LinkedHashMap<>();
  private double[] lenses = {0.010, 0.024, 0.050, 0.085};
  private int objects = 8;
  private double between;
  private double within = 0.01;

  /** Adds a detector with this g. */
  public Photos detector(String name, DoubleUnaryOperator g) {
    detectors.put(name, g);
    return this;
  }

  /** Sets the number of objects. */
  public Photos objects(int count) {
    objects = count;
    return this;
  }

  /** Sets the focal lengths. */
  public Photos lenses(double... lengths) {
    lenses = lengths.clone();
    return this;
  }

  /** Sets the standard deviations between objects and within one. */
  public Photos scatter(double betweenObjects, double withinObjects) {
    between = betweenObjects;
    within = withinObjects;
    return this;
  }

  /** Returns the photos at ten distances for each object and lens; PIP is at most 1. */
  public List<Measurement> take(long seed) {
    Random random = new Random(seed);
    List<Measurement> photos = new ArrayList<>();
    for (int object = 0; object < objects; object++) {
      double q = Synthetic.SIZES[object % Synthetic.SIZES.length];
      double offset = between * random.nextGaussian();
      for (double z : lenses) {
        for (int d = 1; d <= 10; d++) {
          double side = z * q / d;
          double pip = Math.min(1, side * side / (0.0224 * 0.015));
          Map<String, Double> confidences = new LinkedHashMap<>();
          detectors.forEach(
              (name, g) ->
                  confidences.put(
                      name,
                      Math.max(
                          0,
                          Math.min(
                              1, g.applyAsDouble(pip) + offset + within * random.nextGaussian()))));
          photos.add(
              new Measurement(
                  object + "-" + z + "-" + d + ".png", "o" + object, q, d, z, pip, confidences));
        }
      }
    }
    return photos;
  }

  /** Returns a photo with another confidence of detector d. */
  public static Measurement with(Measurement photo, double confidence) {
    return new Measurement(
        photo.image(),
        photo.object(),
        photo.size(),
        photo.distance(),
        photo.focalLength(),
        photo.pip(),
        Map.of("d", confidence));
  }
}
