package org.hificamsim.presentation.replay;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.DetectedDistances;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.OnAxis;
import org.hificamsim.core.detection.ZoomLevel;

/**
 * The distances at which targets of one size are detected, by zoom level; along the heading where
 * the model depends on the bearing.
 */
final class DetectedRanges {
  private final Detection detection;
  private final double size;
  private final Map<ZoomLevel, Level> levels = new HashMap<>();

  /**
   * @param size metres
   */
  DetectedRanges(Detection detection, double size) {
    this.detection = new Detection(new OnAxis(detection.model()), detection.threshold());
    this.size = size;
  }

  /** The levels of a camera, from the narrowest. */
  List<Level> levels(int count, IntFunction<ZoomLevel> zooms) {
    return IntStream.range(0, count)
        .mapToObj(zooms)
        .map(zoom -> levels.computeIfAbsent(zoom, this::find))
        .toList();
  }

  private Level find(ZoomLevel zoom) {
    DetectedDistances distances = detection.distances(size, zoom);
    List<Interval> intervals =
        IntStream.range(0, distances.intervals())
            .mapToObj(i -> new Interval(Math.sqrt(distances.from(i)), Math.sqrt(distances.to(i))))
            .toList();
    return new Level(zoom.radius(), intervals);
  }
}
