package org.hificamsim.tracks.place;

import static org.hificamsim.core.NamedSetting.setting;

import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.nio.file.Path;

/** Reads an SVG as walls, at the scale and place that a frame gives it. */
final class SvgReader {
  private static final double METRES_PER_PIXEL = 0.0254 / 96;

  private final Path file;
  private final LayerChoice choice;
  private final SvgTree tree;

  SvgReader(Path file, LayerChoice choice) {
    this.file = file;
    this.choice = choice;
    this.tree = SvgTree.read(file);
  }

  Drawing read(PictureFrame frame) {
    double metres = metresPerUnit(frame.scale());
    AffineTransform toMetres = new AffineTransform();
    toMetres.translate(frame.x(), frame.y());
    toMetres.scale(metres, -metres);
    double[] box = SvgViewport.viewBox(tree.root());
    toMetres.translate(box == null ? 0 : -box[0], -lowerEdge(box));
    return drawn(toMetres);
  }

  private Drawing drawn(AffineTransform toMetres) {
    Drawing drawing = new Drawing(file, choice);
    new SvgWalls(tree, drawing).draw(toMetres);
    return drawing;
  }

  /** The lower edge of the view box or of the page, or else of what is drawn, in units. */
  private double lowerEdge(double[] viewBox) {
    double height = SvgWalls.size(tree.root(), "height");
    return viewBox != null ? viewBox[1] + viewBox[3] : height > 0 ? height : bounds().getMaxY();
  }

  /** The rectangle around what is drawn, in units. */
  private Rectangle2D bounds() {
    return drawn(new AffineTransform()).bounds();
  }

  private double metresPerUnit(PlanScale scale) {
    if (scale instanceof PlanScale.PerUnit perUnit) {
      return perUnit.metres();
    }
    if (scale instanceof PlanScale.Width width) {
      return width.perUnit(file, bounds().getWidth());
    }
    return ((PlanScale.Paper) scale).ratio() * paperMetresPerUnit();
  }

  /** The size of a unit on paper, from the width of the page. */
  private double paperMetresPerUnit() {
    double width = SvgWalls.size(tree.root(), "width");
    if (!(width > 0) || !SvgLength.isPhysical(tree.root().text("width"))) {
      throw tree.root()
          .place()
          .error(
              "the page has no width in mm, cm or in, expected %s, the metres of a unit",
              setting("scale", "M"));
    }
    double[] box = SvgViewport.viewBox(tree.root());
    return new PlanScale.Width(width * METRES_PER_PIXEL)
        .perUnit(file, box == null ? width : box[2]);
  }
}
