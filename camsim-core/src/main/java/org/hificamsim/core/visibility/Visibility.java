package org.hificamsim.core.visibility;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;

/**
 * What a camera sees of a target. The engine, CamSim's network and the agent inside CamSim share
 * this pipeline; {@link LevelSight} has its steps.
 *
 * <ol>
 *   <li>Reach: the target is not farther away than the zoom level's radius.
 *   <li>Angle: it is {@linkplain LevelSight#isInAngle within the opening angle}; where cameras have
 *       heights, what has to be seen of it is in the lens's {@linkplain Footprint picture}.
 *   <li>Line of sight: what is in between lets something of the target through.
 *   <li>Confidence: the detection model's {@linkplain LevelSight#value value}.
 *   <li>Rule: the value, as much of it as gets through, is the threshold or more; or the
 *       {@linkplain #luck luck} of camera and target is below the chance of the value, as much as
 *       gets through.
 *   <li>Clamping: the {@linkplain LevelSight#confidence confidence} is what the model {@linkplain
 *       DetectionModel#reported reports} for the value.
 * </ol>
 */
public final class Visibility {
  private final Detection detection;
  private final boolean asInCamSim;
  private final boolean certain;
  private final Luck luck;
  private final Map<Kind, LevelSight> levels = new ConcurrentHashMap<>();

  private record Kind(ZoomLevel zoom, Body body) {}

  private Visibility(Detection detection, boolean asInCamSim, long seed) {
    this.detection = detection;
    this.asInCamSim = asInCamSim;
    this.certain = detection.certain();
    this.luck = new Luck(seed, detection.rule().memory());
  }

  /** Where nothing is left to chance, or where one seed is as good as another. */
  public static Visibility of(Detection detection) {
    return of(detection, 0);
  }

  /**
   * The border of a sector belongs to it, and so does the camera's own position.
   *
   * @param seed of the run, which decides about its luck
   */
  public static Visibility of(Detection detection, long seed) {
    return new Visibility(detection, false, seed);
  }

  /**
   * As in CamSim (behaviour 6.1 and 6.2): neither the border of a sector nor the camera's own
   * position belongs to it, and a target of confidence 0 is not seen.
   *
   * @param seed of the run, which decides about its luck
   */
  public static Visibility asInCamSim(Detection detection, long seed) {
    double threshold = Math.max(detection.threshold(), Double.MIN_VALUE);
    return new Visibility(
        detection.certain() ? new Detection(detection.model(), threshold) : detection, true, seed);
  }

  /** The detection model and the threshold, as this pipeline uses it. */
  public Detection detection() {
    return detection;
  }

  /**
   * The same as {@link #at(ZoomLevel, Body)} in a flat world.
   *
   * @param size of the targets, metres
   */
  public LevelSight at(ZoomLevel zoom, double size) {
    return at(zoom, Body.flat(size));
  }

  /** What a camera sees of targets of one kind at a zoom level; found once for all that ask. */
  public LevelSight at(ZoomLevel zoom, Body body) {
    return levels.computeIfAbsent(
        new Kind(zoom, body), kind -> new LevelSight(detection, asInCamSim, zoom, body));
  }

  /**
   * The luck of a camera with a target in one step: in [0, 1), the same whenever it is asked for; 0
   * by a threshold.
   */
  public double luck(long step, int camera, int target) {
    return certain ? 0 : luck.draw(step, camera, target);
  }

  /** How many targets a camera reports in a step that are not there: 0 or 1. */
  public int phantoms(long step, int camera) {
    double chance = detection.rule().phantoms();
    return chance > 0 && luck.draw(step, camera, -1) < chance ? 1 : 0;
  }

  /**
   * A little more than a distance that a computed one, the root of a sum of squares, is at most: no
   * coordinate of the two points differs by more, whatever was rounded.
   *
   * @param distance metres
   */
  public static double roundedUp(double distance) {
    return distance * (1 + 1e-9) + 1e-150; // squares of less may be 0
  }
}
