package org.hificamsim.tracks.place;

import static org.hificamsim.core.NamedSetting.setting;

import java.awt.geom.AffineTransform;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;

/**
 * Reads an ASCII DXF as walls: lines, polylines with bulges, arcs and splines are walls, circles
 * pillars, whole ellipses and filled quadrilaterals solid; inserted blocks are drawn. Layers that
 * are off or frozen, paper space and everything else are left out, and counted. Nothing that the
 * file names is opened.
 *
 * <p>Entities outside blocks are drawn as they are read and not kept, so that large files need
 * little memory.
 */
final class DxfReader {
  /** The flag of a block that is a reference to another file. */
  private static final int IN_OTHER_FILE = 4;

  private static final int MAX_BLOCK_ENTITIES = 1_000_000;

  private final Path file;
  private final DrawingSettings settings;
  private int units;

  DxfReader(Path file, DrawingSettings settings) {
    this.file = file;
    this.settings = settings;
  }

  Drawing read() {
    if (settings.unit().isEmpty()
        && settings.frame().isPresent()
        && settings.frame().get().scale() instanceof PlanScale.Width width) {
      double inUnits = new Pass(1).draw().bounds().getWidth();
      return new Pass(width.perUnit(file, inUnits)).draw();
    }
    return new Pass(Double.NaN).draw();
  }

  /** The length of a unit in metres: from the settings, or else from the file. */
  private double metresPerUnit() {
    double metresInFile = DxfUnits.metres(units);
    if (settings.unit().isPresent()) {
      double metresOfUnit = settings.unit().get().metres();
      if (Double.isNaN(metresOfUnit)) {
        throw InputException.of(
            "%s: %s is %s, expected m, cm or mm with a DXF",
            file, setting("walls_unit"), Spelling.of(settings.unit().get()));
      }
      return metresOfUnit;
    }
    if (settings.frame().isPresent()) {
      PlanScale scale = settings.frame().get().scale();
      if (scale instanceof PlanScale.PerUnit perUnit) {
        return perUnit.metres();
      }
      metresInFile *= scale instanceof PlanScale.Paper paper ? paper.ratio() : 1;
    }
    if (Double.isNaN(metresInFile)) {
      throw InputException.of(
          "%s: the drawing has no unit ($INSUNITS), expected %s, such as mm, or %s",
          file, setting("walls_unit"), setting("scale", "M"));
    }
    return metresInFile;
  }

  /** One reading of the file. */
  private final class Pass {
    private final DxfLayers layers = new DxfLayers();
    private final Drawing drawing = new Drawing(file, settings.choice());
    private final DxfPlan plan = new DxfPlan(layers, drawing);
    private final double metres;
    private int blockEntities;

    /**
     * @param metres length of a unit; NaN to take it from the settings or the file
     */
    Pass(double metres) {
      this.metres = metres;
    }

    Drawing draw() {
      try (DxfTags tags = new DxfTags(file)) {
        for (tags.next(); !tags.is(0, "EOF"); tags.next()) {
          if (tags.is(0, "SECTION")) {
            tags.next();
            section(tags);
          } else if (tags.code() != 999) { // a comment
            throw tags.place().error("expected a section, or EOF, as in ASCII DXF");
          }
        }
      }
      return drawing;
    }

    private void section(DxfTags tags) {
      switch (tags.code() == 2 ? tags.value() : "") {
        case "HEADER" -> header(tags);
        case "TABLES" -> tables(tags);
        case "BLOCKS" -> blocks(tags);
        case "ENTITIES" -> entities(tags);
        default -> skip(tags);
      }
    }

    private void skip(DxfTags tags) {
      while (!tags.is(0, "ENDSEC")) {
        tags.next();
      }
    }

    private void header(DxfTags tags) {
      String variable = "";
      while (!tags.is(0, "ENDSEC")) {
        if (tags.code() == 9) {
          variable = tags.value();
        } else if (variable.equals("$INSUNITS") && tags.code() == 70) {
          units = tags.integer();
        } else if (variable.equals("$DWGCODEPAGE")) {
          tags.setCodePage(tags.value());
        }
        tags.next();
      }
    }

    private void tables(DxfTags tags) {
      while (!tags.is(0, "ENDSEC")) {
        if (tags.is(0, "LAYER")) {
          layers.add(DxfFields.read(tags));
        }
        tags.next();
      }
    }

    private void blocks(DxfTags tags) {
      while (!tags.is(0, "ENDSEC")) {
        if (tags.is(0, "BLOCK")) {
          block(tags);
        }
        tags.next();
      }
    }

    private void block(DxfTags tags) {
      DxfFields head = DxfFields.read(tags);
      List<DxfEntity> entities = new ArrayList<>();
      DxfEntities reader = new DxfEntities(tags);
      for (tags.next(); !tags.is(0, "ENDBLK"); tags.next()) {
        if (tags.is(0, "ENDSEC") || tags.is(0, "EOF")) {
          throw tags.place().error("block %s does not end, expected ENDBLK", head.name());
        }
        if (++blockEntities > MAX_BLOCK_ENTITIES) {
          throw tags.place()
              .error("more than %s entities in blocks, expected fewer", MAX_BLOCK_ENTITIES);
        }
        entities.add(reader.read());
      }
      AffineTransform toOrigin =
          AffineTransform.getTranslateInstance(-head.number(10, 0), -head.number(20, 0));
      plan.addBlock(
          head.name(), new DxfPlan.Block(entities, toOrigin, head.hasFlag(IN_OTHER_FILE)));
    }

    private void entities(DxfTags tags) {
      double scale = Double.isNaN(metres) ? metresPerUnit() : metres;
      AffineTransform toMetres = AffineTransform.getScaleInstance(scale, scale);
      DxfEntities reader = new DxfEntities(tags);
      for (tags.next(); !tags.is(0, "ENDSEC"); tags.next()) {
        plan.draw(reader.read(), toMetres);
      }
    }
  }
}
