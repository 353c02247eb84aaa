package org.hificamsim.profiling.lab;

import com.fasterxml.jackson.annotation.JsonUnwrapped;
import java.util.List;

/**
 * What a laboratory is rendered with; {@link #thesis} gives the published experiment (thesis 3.5)
 * with realistic imperfections, each of which 0 turns off.
 *
 * @param seed of everything random
 * @param scale image width as a share of the sensor's 5184 pixels, (0, 1]
 * @param focalLengths metres
 * @param distances metres, from the camera to the object's centre
 * @param objects how many of the eight objects, from the smallest
 * @param texture what is on the objects and behind them
 * @param optics the lens and the sensor
 * @param scene what stands around the object and how it is held and lit
 */
public record LabSettings(
    long seed,
    double scale,
    List<Double> focalLengths,
    List<Double> distances,
    int objects,
    Texture texture,
    @JsonUnwrapped Optics optics,
    @JsonUnwrapped Scene scene) {
  /**
   * The camera's imperfections.
   *
   * @param aperture f-numbers N of the lens, which set blur and diffraction; 0 for a pinhole. Each
   *     picture has one of them by chance
   * @param focusError standard deviation of the focused distance, as a share of it
   * @param iso sensitivity, which sets the noise; 0 for none
   * @param vignetting share of the cos^4 fall-off towards the corners that is left, [0, 1]
   * @param distortion factors on the lens's radial distortion; each picture has one by chance
   */
  public record Optics(
      List<Double> aperture,
      double focusError,
      double iso,
      double vignetting,
      List<Double> distortion) {
    public Optics {
      aperture = List.copyOf(aperture);
      distortion = List.copyOf(distortion);
    }
  }

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

  /** The experiment of thesis 3.5: 6 focal lengths, 10 distances, 8 objects. */
  public static LabSettings thesis(long seed) {
    return new LabSettings(
        seed,
        0.25,
        List.of(0.010, 0.015, 0.024, 0.050, 0.070, 0.085),
        List.of(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0),
        LabObject.ALL.size(),
        Texture.PHOTOS,
        new Optics(List.of(5.6), 0.02, 1600, 0.5, List.of(1.0)),
        new Scene(4, 0.08, 0.08, 48));
  }

  /** The same in another size. */
  public LabSettings withScale(double share) {
    return new LabSettings(seed, share, focalLengths, distances, objects, texture, optics, scene);
  }

  /** The same at other focal lengths (metres), distances (metres) and with fewer objects. */
  public LabSettings withGrid(List<Double> lengths, List<Double> ranges, int things) {
    return new LabSettings(seed, scale, lengths, ranges, things, texture, optics, scene);
  }

  /** The same with other surfaces. */
  public LabSettings with(Texture surfaces) {
    return new LabSettings(seed, scale, focalLengths, distances, objects, surfaces, optics, scene);
  }

  /** The same with another camera and scene. */
  public LabSettings with(Optics lens, Scene surroundings) {
    return new LabSettings(
        seed, scale, focalLengths, distances, objects, texture, lens, surroundings);
  }
}
