package org.hificamsim.tracks.place;

import static org.hificamsim.core.NamedSetting.setting;

import java.awt.geom.Rectangle2D;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.DoubleSupplier;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.Texts;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.tracks.place.DrawnPart.Traits;

/** The content of a drawing: the shapes that were chosen as walls, and counts of all others. */
public final class Drawing {
  private static final int MAX_PARTS = 200_000;
  private static final int MAX_POINTS = 4_000_000;

  /** The greatest number of lines in the list of names of one kind. */
  private static final int MAX_NAMES = 60;

  private static final int MAX_NAME_LENGTH = 200;

  private final Path file;
  private final LayerChoice choice;
  private final List<DrawnPart> parts = new ArrayList<>();
  private final Map<Label, Integer> labels = new HashMap<>();
  private final Map<String, Integer> leftOut = new TreeMap<>();
  private final Set<String> usedNames = new TreeSet<>();
  private final Set<String> hiddenNames = new TreeSet<>();
  private InputException oddHeight; // null if all heights are right
  private WalkableArea walkableArea; // null until it is asked for
  private long points;

  Drawing(Path file, LayerChoice choice) {
    this.file = file;
    this.choice = choice;
  }

  /**
   * Adds a shape if it is chosen.
   *
   * @param place place of the shape in the file
   * @throws InputException if the drawing becomes too large
   */
  void add(Place place, DrawnShape shape, Traits traits) {
    for (Label label : traits.labels()) {
      if (!label.kind().equals(Label.ID) && label.name().length() <= MAX_NAME_LENGTH) {
        labels.merge(label, 1, Integer::sum);
      }
    }
    Set<String> matching = choice.matching(traits.labels());
    usedNames.addAll(matching);
    if (!matching.isEmpty() || choice.names().isEmpty()) {
      keep(place, new DrawnPart(shape, traits.height()));
    }
  }

  private void keep(Place place, DrawnPart part) {
    points += part.shape().points();
    if (parts.size() < MAX_PARTS && points <= MAX_POINTS) {
      parts.add(part);
    } else if (!choice.isForList()) {
      throw place.error(
          "more than %s shapes or %s points, expected fewer: choose some by %s",
          MAX_PARTS, MAX_POINTS, setting("layers"));
    }
  }

  /** Counts an element of the file that cannot become a wall. */
  void leaveOut(String kind) {
    leftOut.merge(kind, 1, Integer::sum);
  }

  /** Counts an element that is not drawn, and keeps the names by which it could be chosen. */
  void hide(String kind, List<Label> names) {
    leaveOut(kind);
    names.stream()
        .map(Label::name)
        .filter(name -> name.length() <= MAX_NAME_LENGTH && hiddenNames.size() < MAX_NAMES)
        .forEach(hiddenNames::add);
  }

  /**
   * Reads the height of a shape, in metres; infinite if it is invalid, which is counted as left
   * out.
   */
  double height(DoubleSupplier reading) {
    try {
      return reading.getAsDouble();
    } catch (InputException fault) {
      oddHeight = oddHeight == null ? fault : oddHeight;
      leaveOut("height");
      return Double.POSITIVE_INFINITY;
    }
  }

  /** The smallest rectangle around the chosen shapes. */
  Rectangle2D bounds() {
    Rectangle2D bounds = null;
    for (DrawnPart part : parts) {
      Rectangle2D around = part.shape().bounds();
      bounds = bounds == null ? around : bounds.createUnion(around);
    }
    return bounds == null ? new Rectangle2D.Double() : bounds;
  }

  /** The smallest field around the chosen shapes, in metres. */
  public Field field() {
    Rectangle2D bounds = bounds();
    return new Field(bounds.getMinX(), bounds.getMaxX(), bounds.getMinY(), bounds.getMaxY());
  }

  /** The borders of the walkable areas, each as corners without a repetition. */
  public List<List<Point>> walkableBorders() {
    return walkableArea().outerBorders();
  }

  private WalkableArea walkableArea() {
    walkableArea = walkableArea == null ? new WalkableArea(parts) : walkableArea;
    return walkableArea;
  }

  /** The chosen shapes. */
  List<DrawnPart> parts() {
    return parts;
  }

  /**
   * Returns the drawing if something was chosen.
   *
   * @throws InputException if a name chose nothing, or the file has no shape
   */
  Drawing complete() {
    choice.requireUsed(
        file.toString(),
        usedNames,
        hiddenNames,
        labels.keySet().stream().map(Label::name).distinct().sorted().toList());
    if (parts.isEmpty()) {
      throw InputException.of(
          "%s: no wall is drawn%s, expected lines, polygons or circles",
          file, leftOut().map(line -> " (" + line + ")").orElse(""));
    }
    return this;
  }

  /**
   * Returns the walls and solids, one or more.
   *
   * @param walkable whether the outermost areas are where people walk, so that their borders are
   *     walls
   * @throws InputException if all shapes are single points, or none is an area that is walkable
   */
  public List<Obstacle> obstacles(boolean walkable) {
    if (walkable && parts.stream().noneMatch(part -> part.shape() instanceof DrawnShape.Area)) {
      throw InputException.of(
          "%s: %s is given, but nothing that is drawn is an area, expected polygons or closed"
              + " lines",
          file, setting("walkable"));
    }
    List<Obstacle> obstacles =
        new ObstacleMaker().make(walkable ? walkableArea().borders() : parts);
    if (obstacles.isEmpty()) {
      throw InputException.of(
          "%s: all that is drawn are points, expected lines, polygons or circles", file);
    }
    return obstacles;
  }

  /** The elements that cannot become walls, in one line; empty if there are none. */
  public Optional<String> leftOut() {
    return leftOut.isEmpty()
        ? Optional.empty()
        : Optional.of(
            leftOut.entrySet().stream()
                    .map(entry -> entry.getValue() + " " + entry.getKey())
                    .collect(Collectors.joining(", ", "left out: ", ""))
                + (oddHeight == null ? "" : "; the first height: " + oddHeight.getMessage()));
  }

  /** The layers, classes, ids of groups and colours, in a line each with the number of shapes. */
  public List<String> labelLines() {
    Map<String, List<Label>> kinds =
        labels.keySet().stream()
            .sorted(
                Comparator.comparing(Label::kind)
                    .thenComparing(labels::get, Comparator.reverseOrder())
                    .thenComparing(Label::name))
            .collect(Collectors.groupingBy(Label::kind, TreeMap::new, Collectors.toList()));
    List<String> lines = new ArrayList<>();
    kinds.forEach(
        (kind, names) -> {
          names.stream()
              .limit(MAX_NAMES)
              .map(label -> kind + " " + label.name() + ": " + labels.get(label))
              .forEach(lines::add);
          if (names.size() > MAX_NAMES) {
            lines.add(Texts.format("%s: and %s more", kind, names.size() - MAX_NAMES));
          }
        });
    return lines;
  }
}
