package org.hificamsim.profiling.lab;

import com.fasterxml.jackson.annotation.JsonUnwrapped;
import java.util.List;

/**
 * What a laboratory is rendered with: the experiment of thesis 3.5 with realistic imperfections,
 * each of which 0 turns off.
 *
 * @param seed of everything random
 * @param scale image width as a share of the sensor's 5184 pixels, (0, 1]
 * @param focalLengths metres
 * @param distances metres, from the camera to the object's centre
 * @param objects how many of the eight objects, from the smallest
 * @param optics the lens and the sensor
 * @param scene what stands around the object and how it is held and lit
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
   * @param vignetting share of the cos^4 fall-off towards the corners that is left, [0, 1]
   * @param distortion factor on the lens's radial distortion
   */
  public record Optics(
      double aperture, double focusError, double iso, double vignetting, double distortion) {}

  /**
   * The scene's disorder.
   *
   * @param pose standard deviation of the object's yaw and pitch, degrees; roll has half of it
   * @param offset how far the object may stand off the centre, as a share of the frame
   * @param lighting standard deviation of the brightness, as a share of it
   * @param clutter number of things in the room behind the object
   */
  public record Scene(double pose, double offset, double lighting, int clutter) {}

  public LabSettings {
    focalLengths = List.copyOf(focalLengths);
    distances = List.copyOf(distances);
  }

  /** The objects that are photographed. */
  List<LabObject> photographed() {
    return LabObject.ALL.subList(0, objects);
  }
}
