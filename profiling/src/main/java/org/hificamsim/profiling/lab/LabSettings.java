package org.hificamsim.profiling.lab;

import com.fasterxml.jackson.annotation.JsonUnwrapped;
import java.util.List;

/**
 * The settings of the rendered laboratory: the experiment of thesis 3.5 with realistic
 * imperfections. A value of 0 turns an imperfection off.
 *
 * @param seed the seed of all random numbers
 * @param scale image width as a share of the sensor's 5184 pixels, (0, 1]
 * @param focalLengths the focal lengths, in metres
 * @param distances the distances from the camera to the object's centre, in metres
 * @param objects the number of objects, of the eight taken from the smallest
 * @param optics the lens and the sensor
 * @param scene the surroundings, pose and lighting of the object
 */
public record LabSettings(
    long seed,
    double scale,
    List<Double> focalLengths,
    List<Double> distances,
    int objects,
    @JsonUnwrapped Optics optics,
    @JsonUnwrapped Scene scene) {
  /**
   * The camera's imperfections.
   *
   * @param aperture f-number N of the lens, which sets blur and diffraction; 0 for a pinhole
   * @param focusError standard deviation of the focused distance, as a share of it
   * @param iso sensitivity, which sets the noise; 0 for none
   * @param vignetting the strength of the cos^4 fall-off towards the corners, [0, 1]
   * @param distortion a factor on the lens's radial distortion
   */
  public record Optics(
      double aperture, double focusError, double iso, double vignetting, double distortion) {}

  /**
   * The scene's disorder.
   *
   * @param pose standard deviation of the object's yaw and pitch, in degrees; roll has half of it
   * @param offset the largest distance of the object from the centre, as a share of the frame
   * @param lighting standard deviation of the brightness, as a share of it
   * @param clutter number of things in the room behind the object
   */
  public record Scene(double pose, double offset, double lighting, int clutter) {}

  public LabSettings {
    focalLengths = List.copyOf(focalLengths);
    distances = List.copyOf(distances);
  }

  /** Returns the objects that are photographed. */
  List<LabObject> photographed() {
    return LabObject.ALL.subList(0, objects);
  }
}
