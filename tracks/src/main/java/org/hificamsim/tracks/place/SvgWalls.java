package org.hificamsim.tracks.place;

import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.hificamsim.tracks.place.DrawnPart.Traits;
import org.hificamsim.tracks.place.OutlineMaker.Kind;

/**
 * Reads the shapes of an SVG as walls, where SVG and CSS draw them: {@code line}, {@code polyline},
 * {@code polygon}, {@code rect}, {@code path}, {@code circle} and {@code ellipse}, also by {@code
 * use} and in nested drawings. Curves become chords; filled polygons, rectangles and ellipses
 * become solid, circles pillars. {@code data-height} is a height in metres, independent of the
 * scale.
 */
final class SvgWalls {
  private static final Set<String> CONTAINERS = Set.of("svg", "g", "a", "switch", "use");

  /** Elements that draw something that cannot become a wall. */
  private static final Set<String> OTHERS =
      Set.of("text", "image", "foreignObject", "video", "audio", "canvas", "iframe", "mesh");

  private static final Set<String> AREAS = Set.of("polygon", "rect", "ellipse");

  private static final String HEIGHT = "data-height";

  /** The greatest number of elements that are drawn, also by {@code use}. */
  private static final int MAX_DRAWN = 1_000_000;

  private static final int MAX_DEPTH = 200;

  private final SvgTree tree;
  private final Drawing drawing;
  private final Set<SvgNode> active = new HashSet<>();
  private int drawn;

  /**
   * The surroundings in which an element is drawn.
   *
   * @param toMetres the transform from the element's coordinates to metres
   */
  private record Context(
      AffineTransform toMetres, SvgViewport viewport, SvgStyle style, Traits traits) {
    Context moved(AffineTransform own) {
      AffineTransform transform = new AffineTransform(toMetres);
      transform.concatenate(own);
      return new Context(transform, viewport, style, traits);
    }

    Context within(SvgViewport inner) {
      return new Context(toMetres, inner, style, traits);
    }
  }

  SvgWalls(SvgTree tree, Drawing drawing) {
    this.tree = tree;
    this.drawing = drawing;
  }

  /**
   * Draws the whole SVG.
   *
   * @param toMetres the transform from units of the drawing to metres
   */
  void draw(AffineTransform toMetres) {
    SvgNode root = tree.root();
    SvgViewport page = new SvgViewport(size(root, "width"), size(root, "height"));
    SvgViewport inside = SvgViewport.inside(root, page.width(), page.height());
    Context context = new Context(toMetres, inside, SvgStyle.INITIAL, Traits.NONE);
    drawInside(root, context, 0);
  }

  /** The width or height of the drawing, in pixels; NaN if it is not given as a length. */
  static double size(SvgNode root, String attribute) {
    String text = root.text(attribute);
    if (text.isEmpty() || text.equals("auto") || text.endsWith("%")) {
      return Double.NaN;
    }
    return new SvgShapes(root, new SvgViewport(Double.NaN, Double.NaN))
        .length(attribute, Double.NaN, Double.NaN);
  }

  private void draw(SvgNode node, Context around, int depth) {
    if (++drawn > MAX_DRAWN || depth > MAX_DEPTH) {
      throw node.place()
          .error(
              "<use> draws too much, expected at most %s elements, %s in each other",
              MAX_DRAWN, MAX_DEPTH);
    }
    if (OTHERS.contains(node.name())) {
      drawing.leaveOut(node.name());
    } else if (node.isShape() || CONTAINERS.contains(node.name())) {
      Context own = around.moved(new SvgShapes(node, around.viewport()).transform());
      if (node.name().equals("svg")) {
        own = nested(node, node, own);
      }
      drawInside(node, own, depth);
    }
  }

  /** The context inside a nested drawing or symbol, whose size the element {@code sized} gives. */
  private static Context nested(SvgNode node, SvgNode sized, Context context) {
    SvgViewport outer = context.viewport();
    SvgShapes lengths = new SvgShapes(sized, outer);
    SvgShapes own = new SvgShapes(node, outer);
    double width =
        lengths.length("width", outer.width(), own.length("width", outer.width(), outer.width()));
    double height =
        lengths.length(
            "height", outer.height(), own.length("height", outer.height(), outer.height()));
    AffineTransform place =
        AffineTransform.getTranslateInstance(
            node.name().equals("svg") ? own.length("x", outer.width(), 0) : 0,
            node.name().equals("svg") ? own.length("y", outer.height(), 0) : 0);
    return context
        .moved(place)
        .moved(SvgViewport.fit(node, width, height))
        .within(SvgViewport.inside(node, width, height));
  }

  /** Draws an element whose transform the context has. */
  private void drawInside(SvgNode node, Context around, int depth) {
    Map<String, String> values = tree.rules().values(node, SvgStyle.PROPERTIES);
    if (values.getOrDefault("display", "").equals("none")) {
      hide(node, labels(node, around.traits()));
      return;
    }
    SvgStyle style = around.style().with(values);
    Traits traits = new Traits(height(node, around.traits()), labels(node, around.traits()));
    Context context = new Context(around.toMetres(), around.viewport(), style, traits);
    if (node.name().equals("use")) {
      use(node, context, depth);
    } else if (node.isShape()) {
      drawShape(node, context);
    } else {
      children(node).forEach(child -> draw(child, context, depth + 1));
    }
  }

  private void hide(SvgNode node, List<Label> labels) {
    for (int i = node.shapes(); i > 0; i--) {
      drawing.hide("hidden", labels);
    }
  }

  private double height(SvgNode node, Traits around) {
    if (!node.has(HEIGHT)) {
      return around.height();
    }
    return drawing.height(() -> DrawnPart.height(node.place(), node.text(HEIGHT)));
  }

  private static List<Label> labels(SvgNode node, Traits around) {
    List<Label> labels = new ArrayList<>(around.labels());
    for (String attribute : List.of("inkscape:label", "data-name")) {
      if (node.has(attribute) && !node.isShape()) {
        labels.add(new Label(Label.LAYER, node.text(attribute)));
      }
    }
    if (node.has("id")) {
      labels.add(new Label(node.isShape() ? Label.ID : Label.GROUP, node.text("id")));
    }
    node.classes().forEach(name -> labels.add(new Label(Label.CLASS, name)));
    return labels;
  }

  /** The children that are drawn: of a {@code switch}, the first that needs nothing special. */
  private static List<SvgNode> children(SvgNode node) {
    return !node.name().equals("switch")
        ? node.children()
        : node.children().stream()
            .filter(child -> !child.has("requiredExtensions"))
            .filter(child -> !child.name().equals("foreignObject"))
            .limit(1)
            .toList();
  }

  private void use(SvgNode use, Context context, int depth) {
    String link = use.text("href");
    SvgNode used = link.startsWith("#") ? tree.find(link.substring(1)) : null;
    if (used == null) {
      drawing.leaveOut(link.startsWith("#") ? "use of nothing" : "use of another file");
    } else if (!active.add(used)) {
      drawing.leaveOut("use of itself");
    } else {
      SvgShapes lengths = new SvgShapes(use, context.viewport());
      Context moved =
          context.moved(
              AffineTransform.getTranslateInstance(
                  lengths.length("x", context.viewport().width(), 0),
                  lengths.length("y", context.viewport().height(), 0)));
      if (used.name().equals("symbol") || used.name().equals("svg")) {
        AffineTransform own = new SvgShapes(used, context.viewport()).transform();
        drawInside(used, nested(used, use, moved.moved(own)), depth + 1);
      } else {
        draw(used, moved, depth + 1);
      }
      active.remove(used);
    }
  }

  private void drawShape(SvgNode node, Context context) {
    boolean isLine = node.name().equals("line");
    if (!context.style().draws(isLine)) {
      drawing.hide("hidden", context.traits().labels());
      return;
    }
    List<Label> labels = new ArrayList<>(context.traits().labels());
    context.style().colours(isLine).forEach(name -> labels.add(new Label(Label.COLOUR, name)));
    OutlineMaker outline =
        new OutlineMaker(
            drawing,
            node.place(),
            context.toMetres(),
            new Traits(context.traits().height(), labels));
    Shape shape = new SvgShapes(node, context.viewport()).shape();
    if (node.name().equals("circle")) {
      outline.addCircle(shape);
    } else {
      boolean isArea = AREAS.contains(node.name());
      Kind inside = context.style().isFilled() ? Kind.SOLID : Kind.BORDER;
      outline.add(shape, isArea ? inside : Kind.LINES);
    }
  }
}
