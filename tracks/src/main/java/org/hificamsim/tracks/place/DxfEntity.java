package org.hificamsim.tracks.place;

import java.awt.Shape;
import java.awt.geom.AffineTransform;
import org.hificamsim.core.Place;

/**
 * An entity that a DXF draws.
 *
 * @param colour number of the AutoCAD Color Index; 0 for the colour of the block, 256 for that of
 *     the layer
 * @param handle the id of the entity; empty if it has none
 * @param content the shape or block that is drawn
 */
record DxfEntity(Place place, String layer, int colour, String handle, Content content) {
  static final int COLOUR_OF_BLOCK = 0;
  static final int COLOUR_OF_LAYER = 256;

  /** The content of an entity. */
  sealed interface Content {}

  /** An outline, in units of the file. */
  record Outline(Shape shape, OutlineMaker.Kind kind) implements Content {}

  /** A circle, in units of the file. */
  record Circle(Shape shape) implements Content {}

  /**
   * A block that is drawn at places of a grid.
   *
   * @param toParent the transform of the first place, without the scale
   * @param scale scale of the block in x and y
   * @param grid the numbers of columns and rows
   * @param spacing distances between columns and between rows
   */
  record Insert(
      String block, AffineTransform toParent, double[] scale, int[] grid, double[] spacing)
      implements Content {
    /** The transform of the block in a column and row. */
    AffineTransform transform(int column, int row) {
      AffineTransform transform = new AffineTransform(toParent);
      transform.translate(column * spacing[0], row * spacing[1]);
      transform.scale(scale[0], scale[1]);
      return transform;
    }
  }

  /**
   * An entity that cannot become a wall.
   *
   * @param kind name of the kind, for messages
   */
  record Other(String kind) implements Content {}
}
