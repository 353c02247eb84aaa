package org.hificamsim.placement.output;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Finds places for labels near the points that they name, so that they cover neither signs nor each
 * other.
 */
final class LabelPlaces {
  private static final int DIRECTIONS = 16;
  private static final List<Integer> DISTANCES = List.of(7, 14, 22, 32, 44, 60, 80);

  private final Rectangle2D area;
  private final List<Rectangle2D> taken = new ArrayList<>();

  /**
   * @param area the area that labels should not leave
   */
  LabelPlaces(Rectangle2D area) {
    this.area = area;
  }

  /** Keeps labels off a square around a point. */
  void avoid(Point2D point, double halfSide) {
    double side = 2 * halfSide;
    taken.add(new Rectangle2D.Double(point.getX() - halfSide, point.getY() - halfSide, side, side));
  }

  /**
   * Returns the free place for a label that is nearest to its point; else the least covered one.
   */
  Rectangle2D place(Point2D point, double width, double height) {
    Rectangle2D place =
        places(point, width, height)
            .filter(candidate -> cost(candidate) == 0)
            .findFirst()
            .orElseGet(
                () ->
                    places(point, width, height)
                        .min(Comparator.comparingDouble(this::cost))
                        .orElseThrow());
    taken.add(place);
    return place;
  }

  private static Stream<Rectangle2D> places(Point2D point, double width, double height) {
    return DISTANCES.stream()
        .flatMap(
            distance ->
                IntStream.range(0, DIRECTIONS)
                    .mapToObj(
                        direction -> {
                          double angle = 2 * Math.PI * direction / DIRECTIONS;
                          double across = (distance + width / 2) * Math.cos(angle);
                          double down = (distance + height / 2) * Math.sin(angle);
                          return new Rectangle2D.Double(
                              point.getX() + across - width / 2,
                              point.getY() + down - height / 2,
                              width,
                              height);
                        }));
  }

  private double cost(Rectangle2D place) {
    double overlap = place.getWidth() * place.getHeight() - overlap(place, area);
    return overlap + taken.stream().mapToDouble(other -> overlap(place, other)).sum();
  }

  private static double overlap(Rectangle2D place, Rectangle2D other) {
    Rectangle2D common = place.createIntersection(other);
    return common.isEmpty() ? 0 : common.getWidth() * common.getHeight();
  }
}
