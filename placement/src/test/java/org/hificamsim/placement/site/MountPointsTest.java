package org.hificamsim.placement.site;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.hificamsim.core.Texts;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class MountPointsTest {
  private static final double SIZE = 20;
  private static final double CLEARANCE = 0.25;

  /** A margin that exceeds the rounding of a point to centimetres, in metres. */
  private static final double ROUNDING = 0.01;

  @TempDir private Path folder;

  private Scenario site(String attributes, String obstacles) throws IOException {
    return site(attributes, obstacles, "");
  }

  private Scenario site(String attributes, String obstacles, String zones) throws IOException {
    return TestSite.read(
        folder,
        """
<root>
  <simulation min_x="0" max_x="20" min_y="0" max_y="20" order="coverage" %s>
    <obstacles>%s</obstacles>
    <zones>%s</zones>
    <cameras><camera name="A" x="19.9" y="19.9" heading="0" viewing_angle="60" range="9"/></cameras>
    <objects><object x="19.7" y="19.7" heading="0" speed="1" features="1"/></objects>
  </simulation>
</root>
"""
            .formatted(attributes, obstacles, zones));
  }

  private static List<Point> points(Scenario site, boolean ceiling) {
    return MountPoints.of(site, new MountPoints.Rules(0.5, CLEARANCE, ceiling, List.of()));
  }

  private static boolean anyIn(
      List<Point> points, double minX, double minY, double maxX, double maxY) {
    Predicate<Point> inside =
        point -> point.x() > minX && point.x() < maxX && point.y() > minY && point.y() < maxY;
    return points.stream().anyMatch(inside);
  }

  /** A wall from west to east. */
  private static String wall(double y) {
    return Texts.format("<wall x1=\"0\" y1=\"%1$s\" x2=\"20\" y2=\"%1$s\"/>", y);
  }

  @Test
  void camerasHangOnRacksAsHighAsTheirMountHeightOnly() throws IOException {
    String racks =
        "<polygon points=\"4,4 8,4 8,6 4,6\" height=\"1.8\"/>"
            + "<polygon points=\"12,4 16,4 16,6 12,6\" height=\"6\"/>";
    List<Point> points = points(site("mount_height=\"3\" seen=\"whole\"", racks), false);
    assertFalse(anyIn(points, 3, 3, 9, 7));
    assertTrue(anyIn(points, 11, 3, 17, 7));
  }

  @Test
  void ceilingHasPlacesAboveLowShelves() throws IOException {
    String shelf = "<polygon points=\"4,4 8,4 8,6 4,6\" height=\"1.8\"/>";
    assertTrue(anyIn(points(site("mount_height=\"3\" seen=\"whole\"", shelf), true), 4, 4, 8, 6));
    assertFalse(anyIn(points(site("", shelf.replace(" height=\"1.8\"", "")), true), 4, 4, 8, 6));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.9, 2.4})
  void noCameraHangsInDoor(double width) throws IOException {
    String walls =
        Texts.format(
            "<polygon points=\"0,9.8 8,9.8 8,10.2 0,10.2\"/>"
                + "<polygon points=\"%1$s,9.8 20,9.8 20,10.2 %1$s,10.2\"/>",
            8 + width);
    List<Point> points = points(site("", walls), false);
    assertFalse(anyIn(points, 8, 9.8, 8 + width, 10.2));
    assertTrue(anyIn(points, 4, 9, 7, 9.8));
  }

  /** A building of 16 x 16 m in a field of 20 x 20 m, with an entrance in the south. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 2.4, 5})
  void noCameraHangsInEntranceOrOutsideOfBuildingWithAllZones(double width) throws IOException {
    String walls =
        Texts.format(
            "<wall x1=\"2\" y1=\"2\" x2=\"8\" y2=\"2\"/>"
                + "<wall x1=\"%s\" y1=\"2\" x2=\"18\" y2=\"2\"/>"
                + "<wall x1=\"18\" y1=\"2\" x2=\"18\" y2=\"18\"/>"
                + "<wall x1=\"18\" y1=\"18\" x2=\"2\" y2=\"18\"/>"
                + "<wall x1=\"2\" y1=\"18\" x2=\"2\" y2=\"2\"/>",
            8 + width);
    List<Point> inside =
        points(site("", walls, "<zone name=\"hall\" points=\"4,4 16,16\"/>"), false);
    assertFalse(inside.stream().anyMatch(point -> point.y() < 2 || point.y() > 18));
    assertFalse(inside.stream().anyMatch(point -> point.x() < 2 || point.x() > 18));
    assertFalse(anyIn(inside, 8, 1.5, 8 + width, 2.2));
    assertTrue(anyIn(inside, 5, 2, 8, 3) && anyIn(inside, 17, 5, 18, 15));
    List<Point> outside =
        points(site("", walls, "<zone name=\"yard\" points=\"4,0 16,1.5\"/>"), false);
    assertTrue(anyIn(outside, 0, 0, 20, 1));
  }

  /** The same building with walls that are as thick as they are drawn. */
  @ParameterizedTest
  @CsvSource({"1, 0.1", "3, 0.1", "3, 0.3", "5, 0.3"})
  void leavesEntranceBetweenThickWallsFree(double width, double thickness) throws IOException {
    double right = 8 + width;
    String walls =
        thickWall(2, 2, 8, 2 + thickness)
            + thickWall(right, 2, 18, 2 + thickness)
            + thickWall(18 - thickness, 2, 18, 18)
            + thickWall(2, 18 - thickness, 18, 18)
            + thickWall(2, 2, 2 + thickness, 18);
    List<Point> inside =
        points(site("", walls, "<zone name=\"hall\" points=\"4,4 16,16\"/>"), false);
    assertFalse(anyIn(inside, 8, 1.5, right, 2.1 + thickness));
    assertFalse(inside.stream().anyMatch(point -> point.y() < 2 || point.y() > 18));
    assertTrue(anyIn(inside, 5, 2, 8, 3) && anyIn(inside, 17, 5, 18, 15));
  }

  private static String thickWall(double x1, double y1, double x2, double y2) {
    return Texts.format(
        "<polygon points=\"%1$s,%2$s %3$s,%2$s %3$s,%4$s %1$s,%4$s\"/>", x1, y1, x2, y2);
  }

  @Test
  void camerasHangInNarrowCorridorsAndOnColumns() throws IOException {
    String walls = wall(9) + wall(11) + "<polygon points=\"4,4 4.4,4 4.4,4.4 4,4.4\"/>";
    List<Point> points = points(site("", walls), false);
    assertTrue(anyIn(points, 5, 9, 15, 10) && anyIn(points, 5, 10, 15, 11));
    assertTrue(anyIn(points, 3.5, 3.5, 5, 5));
  }

  @Test
  void noCameraHangsBetweenTwoLinesOfOneWall() throws IOException {
    assertFalse(anyIn(points(site("", wall(9) + wall(9.6)), false), 1, 9, 19, 9.6));
  }

  @Test
  void everyCameraHangsOnBorderOrHighEnoughObstacle() throws IOException {
    Random random = new Random(55);
    for (int trial = 0; trial < 30; trial++) {
      String obstacles =
          IntStream.range(0, 8).mapToObj(i -> box(random)).collect(Collectors.joining());
      Scenario site = site("mount_height=\"3\" seen=\"whole\"", obstacles);
      for (Point point : points(site, false)) {
        double nearest =
            site.obstacles().stream()
                .filter(obstacle -> obstacle.height() >= 3)
                .mapToDouble(obstacle -> distance((Obstacle.Polygon) obstacle, point))
                .min()
                .orElse(Double.POSITIVE_INFINITY);
        double border =
            DoubleStream.of(point.x(), point.y(), SIZE - point.x(), SIZE - point.y())
                .min()
                .orElseThrow();
        assertEquals(CLEARANCE, Math.min(nearest, border), ROUNDING, () -> point + obstacles);
      }
    }
  }

  private static String box(Random random) {
    double x = 15 * random.nextDouble();
    double y = 15 * random.nextDouble();
    double right = x + 0.5 + 4 * random.nextDouble();
    double top = y + 0.5 + 4 * random.nextDouble();
    return Texts.format(
        "<polygon points=\"%1$.3f,%2$.3f %3$.3f,%2$.3f %3$.3f,%4$.3f %1$.3f,%4$.3f\""
            + " height=\"%5$.1f\"/>",
        x, y, right, top, 1 + 4 * random.nextDouble());
  }

  /** The distance of a point from an upright rectangle; negative inside. */
  private static double distance(Obstacle.Polygon box, Point point) {
    Point least = box.points().get(0);
    Point greatest = box.points().get(2);
    double dx = Math.max(least.x() - point.x(), point.x() - greatest.x());
    double dy = Math.max(least.y() - point.y(), point.y() - greatest.y());
    return Math.min(dx, dy) > 0 ? Math.hypot(dx, dy) : Math.max(dx, dy);
  }
}
