package org.hificamsim.tracks.place;

import java.awt.geom.AffineTransform;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.hificamsim.tracks.place.DrawnPart.Traits;
import org.hificamsim.tracks.place.DxfEntity.Circle;
import org.hificamsim.tracks.place.DxfEntity.Insert;
import org.hificamsim.tracks.place.DxfEntity.Other;
import org.hificamsim.tracks.place.DxfEntity.Outline;

/** Draws the entities of a DXF with the blocks that they insert. */
final class DxfPlan {
  /** The greatest number of entities that are drawn by inserts. */
  private static final int MAX_INSERTED = 1_000_000;

  private static final int MAX_DEPTH = 100;

  /**
   * A block.
   *
   * @param toOrigin the transform that moves the block's base point to the origin
   */
  record Block(List<DxfEntity> entities, AffineTransform toOrigin, boolean isInOtherFile) {}

  /**
   * The surroundings in which an entity is drawn.
   *
   * @param layer layer of the innermost insert around
   * @param colour colour of the innermost insert around
   * @param blocks the names of all blocks around
   */
  private record Context(AffineTransform toMetres, String layer, int colour, List<Label> blocks) {}

  private final DxfLayers layers;
  private final Drawing drawing;
  private final Map<String, Block> blocks = new HashMap<>();
  private final Set<Block> active = new HashSet<>();
  private int inserted;

  DxfPlan(DxfLayers layers, Drawing drawing) {
    this.layers = layers;
    this.drawing = drawing;
  }

  void addBlock(String name, Block block) {
    blocks.put(name.toLowerCase(Locale.ROOT), block);
  }

  /** Draws an entity that is in no block. */
  void draw(DxfEntity entity, AffineTransform toMetres) {
    draw(entity, new Context(toMetres, DxfLayers.LAYER_OF_INSERT, 7, List.of()));
  }

  private void draw(DxfEntity entity, Context around) {
    String layer =
        entity.layer().equals(DxfLayers.LAYER_OF_INSERT) ? around.layer() : entity.layer();
    int colour = colour(entity, layer, around);
    boolean isInsert = entity.content() instanceof Insert;
    if (isInsert ? layers.isFrozen(layer) : layers.isHidden(layer)) {
      drawing.hide("on layers that are off or frozen", List.of(new Label(Label.LAYER, layer)));
    } else if (entity.content() instanceof Insert insert) {
      insert(entity, insert, new Context(around.toMetres(), layer, colour, around.blocks()));
    } else if (entity.content() instanceof Other other) {
      drawing.leaveOut(other.kind());
    } else {
      drawShape(entity, around, layer, colour);
    }
  }

  private int colour(DxfEntity entity, String layer, Context around) {
    return switch (entity.colour()) {
      case DxfEntity.COLOUR_OF_BLOCK -> around.colour();
      case DxfEntity.COLOUR_OF_LAYER -> layers.colour(layer);
      default -> entity.colour();
    };
  }

  private void drawShape(DxfEntity entity, Context around, String layer, int colour) {
    List<Label> labels = new ArrayList<>(around.blocks());
    labels.add(new Label(Label.LAYER, layer));
    labels.add(new Label(Label.COLOUR, String.valueOf(colour)));
    if (!entity.handle().isEmpty()) {
      labels.add(new Label(Label.ID, entity.handle()));
    }
    OutlineMaker maker =
        new OutlineMaker(
            drawing,
            entity.place(),
            around.toMetres(),
            new Traits(Double.POSITIVE_INFINITY, labels));
    if (entity.content() instanceof Outline outline) {
      maker.add(outline.shape(), outline.kind());
    } else if (entity.content() instanceof Circle circle) {
      maker.addCircle(circle.shape());
    }
  }

  private void insert(DxfEntity entity, Insert insert, Context around) {
    Block block = blocks.get(insert.block().toLowerCase(Locale.ROOT));
    if (block == null || block.isInOtherFile()) {
      drawing.leaveOut(block == null ? "insert of nothing" : "insert of another file");
    } else if (!active.add(block)) {
      drawing.leaveOut("insert of itself");
    } else {
      List<Label> names = new ArrayList<>(around.blocks());
      names.add(new Label(Label.BLOCK, insert.block()));
      for (int row = 0; row < insert.grid()[1]; row++) {
        for (int column = 0; column < insert.grid()[0]; column++) {
          countInserted(entity, block);
          AffineTransform transform = new AffineTransform(around.toMetres());
          transform.concatenate(insert.transform(column, row));
          transform.concatenate(block.toOrigin());
          Context inside = new Context(transform, around.layer(), around.colour(), names);
          block.entities().forEach(part -> draw(part, inside));
        }
      }
      active.remove(block);
    }
  }

  private void countInserted(DxfEntity entity, Block block) {
    inserted += 1 + block.entities().size();
    if (inserted > MAX_INSERTED || active.size() > MAX_DEPTH) {
      throw entity
          .place()
          .error(
              "INSERT draws too much, expected at most %s entities, %s blocks in each other",
              MAX_INSERTED, MAX_DEPTH);
    }
  }
}
