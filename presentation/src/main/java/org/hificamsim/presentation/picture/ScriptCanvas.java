package org.hificamsim.presentation.picture;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Composite;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Paint;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.TexturePaint;
import java.awt.font.FontRenderContext;
import java.awt.geom.AffineTransform;
import java.awt.geom.Arc2D;
import java.awt.geom.Area;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A canvas by which the scripts of pages paint with Java 2D, in points. It has the part of {@code
 * CanvasRenderingContext2D} that {@code scene.js} uses, and the functions that this expects of its
 * host. Class and fields are public, because scripts require it.
 */
public final class ScriptCanvas {
  private static final Pattern FONT = Pattern.compile("(bold )?([\\d.]+)px .*");
  private static final FontRenderContext TEXT = new FontRenderContext(null, true, true);
  private static final int TILE_PIXELS_PER_POINT = 8;

  /**
   * The least number of pixels of the longer side of an image of cells. Each cell has many pixels,
   * because viewers of SVG files blur them.
   */
  private static final int CELL_IMAGE_PIXELS = 1600;

  /** A colour such as {@code #000000}, or a result of {@link #pattern}. */
  public Object fillStyle = "#000000";

  public String strokeStyle = "#000000";
  public double globalAlpha = 1;

  /** {@code source-over}, or {@code destination-out}, which subtracts from a mask. */
  public String globalCompositeOperation = "source-over";

  public double lineWidth = 1;
  public String lineCap = "butt";
  public String lineJoin = "miter";
  public String font = "10px sans-serif";
  public String textAlign = "left";
  public boolean imageSmoothingEnabled = true;

  private final Graphics2D graphics;

  /** The area that fills change instead of the picture; null for a canvas that paints. */
  private final Area mask;

  private final Deque<ScriptCanvas> saved = new ArrayDeque<>();
  private float[] dash = {};
  private Path2D path = new Path2D.Double();
  private Area clip;

  ScriptCanvas(Graphics2D graphics) {
    this(graphics, null);
  }

  private ScriptCanvas(Graphics2D graphics, Area mask) {
    this.graphics = graphics;
    this.mask = mask;
  }

  public void save() {
    ScriptCanvas copy = new ScriptCanvas(graphics, mask);
    copy.copyState(this);
    saved.push(copy);
  }

  public void restore() {
    copyState(saved.pop());
  }

  private void copyState(ScriptCanvas other) {
    fillStyle = other.fillStyle;
    strokeStyle = other.strokeStyle;
    globalAlpha = other.globalAlpha;
    globalCompositeOperation = other.globalCompositeOperation;
    lineWidth = other.lineWidth;
    lineCap = other.lineCap;
    lineJoin = other.lineJoin;
    font = other.font;
    textAlign = other.textAlign;
    imageSmoothingEnabled = other.imageSmoothingEnabled;
    dash = other.dash;
    clip = other.clip;
  }

  public void setLineDash(double[] lengths) {
    dash = new float[lengths.length];
    for (int i = 0; i < dash.length; i++) {
      dash[i] = (float) lengths[i];
    }
  }

  public void beginPath() {
    path = new Path2D.Double(Path2D.WIND_NON_ZERO);
  }

  public void moveTo(double x, double y) {
    path.moveTo(x, y);
  }

  public void lineTo(double x, double y) {
    path.lineTo(x, y);
  }

  /** Adds an arc from an angle to a greater one, radians clockwise from the right. */
  public void arc(double x, double y, double r, double from, double to) {
    double start = -Math.toDegrees(from);
    double extent = -Math.toDegrees(to - from);
    path.append(new Arc2D.Double(x - r, y - r, 2 * r, 2 * r, start, extent, Arc2D.OPEN), true);
  }

  public void rect(double x, double y, double width, double height) {
    path.append(new Rectangle2D.Double(x, y, width, height), false);
  }

  public void closePath() {
    path.closePath();
  }

  /** Limits painting to the path, until {@link #restore}. */
  public void clip() {
    clip = clipped(path);
  }

  private Area clipped(Shape shape) {
    Area area = new Area(shape);
    if (clip != null) {
      area.intersect(clip);
    }
    return area;
  }

  public void fill() {
    fill("nonzero");
  }

  /** Fills the path by a rule, {@code nonzero} or {@code evenodd}. */
  public void fill(String rule) {
    path.setWindingRule(rule.equals("evenodd") ? Path2D.WIND_EVEN_ODD : Path2D.WIND_NON_ZERO);
    fill(path);
  }

  public void fillRect(double x, double y, double width, double height) {
    fill(new Rectangle2D.Double(x, y, width, height));
  }

  private void fill(Shape shape) {
    Shape inside = clip == null ? shape : clipped(shape);
    if (mask == null) {
      graphics.setPaint(fillStyle instanceof Paint paint ? paint : color(fillStyle.toString()));
      blended(() -> graphics.fill(inside));
    } else if (globalCompositeOperation.equals("destination-out")) {
      mask.subtract(new Area(inside));
    } else {
      mask.add(new Area(inside));
    }
  }

  public void stroke() {
    stroke(path);
  }

  private void stroke(Shape shape) {
    graphics.setColor(color(strokeStyle));
    int cap = lineCap.equals("round") ? BasicStroke.CAP_ROUND : BasicStroke.CAP_BUTT;
    int join = lineJoin.equals("round") ? BasicStroke.JOIN_ROUND : BasicStroke.JOIN_MITER;
    graphics.setStroke(
        new BasicStroke((float) lineWidth, cap, join, 10, dash.length == 0 ? null : dash, 0));
    Shape before = graphics.getClip();
    if (clip != null) {
      graphics.clip(clip);
    }
    blended(() -> graphics.draw(shape));
    graphics.setClip(before);
  }

  public void fillText(String text, double x, double y) {
    graphics.setFont(font());
    graphics.setColor(color(fillStyle.toString()));
    graphics.drawString(text, (float) left(text, x), (float) y);
  }

  public void strokeText(String text, double x, double y) {
    stroke(font().createGlyphVector(TEXT, text).getOutline((float) left(text, x), (float) y));
  }

  private double left(String text, double x) {
    double width = font().getStringBounds(text, TEXT).getWidth();
    return switch (textAlign) {
      case "center" -> x - width / 2;
      case "right" -> x - width;
      default -> x;
    };
  }

  private Font font() {
    Matcher parts = FONT.matcher(font);
    if (!parts.matches()) {
      throw new IllegalArgumentException(font);
    }
    int style = parts.group(1) == null ? Font.PLAIN : Font.BOLD;
    return new Font(Font.SANS_SERIF, style, 1).deriveFont(Float.parseFloat(parts.group(2)));
  }

  public void drawImage(Object image, double x, double y, double width, double height) {
    BufferedImage pixels = (BufferedImage) image;
    graphics.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION,
        imageSmoothingEnabled
            ? RenderingHints.VALUE_INTERPOLATION_BILINEAR
            : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
    AffineTransform place = AffineTransform.getTranslateInstance(x, y);
    place.scale(width / pixels.getWidth(), height / pixels.getHeight());
    blended(() -> graphics.drawImage(pixels, place, null));
  }

  private void blended(Runnable painting) {
    Composite before = graphics.getComposite();
    graphics.setComposite(AlphaComposite.getInstance(AlphaComposite.SRC_OVER, (float) globalAlpha));
    painting.run();
    graphics.setComposite(before);
  }

  static Color color(String style) {
    return Color.decode(style);
  }

  /** Returns a paint that repeats a square tile. */
  public Object pattern(double side, Consumer<ScriptCanvas> paint) {
    int pixels = (int) Math.round(TILE_PIXELS_PER_POINT * side);
    BufferedImage tile = new BufferedImage(pixels, pixels, BufferedImage.TYPE_INT_ARGB);
    Graphics2D tiled = tile.createGraphics();
    tiled.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    tiled.scale(TILE_PIXELS_PER_POINT, TILE_PIXELS_PER_POINT);
    paint.accept(new ScriptCanvas(tiled));
    tiled.dispose();
    return new TexturePaint(tile, new Rectangle2D.Double(0, 0, side, side));
  }

  /**
   * Returns an image of cells.
   *
   * @param colourOf returns the red, green and blue of a cell, by rows from the lower left; null
   *     for none
   */
  public Object cells(int columns, int rows, IntFunction<List<Number>> colourOf) {
    int edge = Math.max(1, CELL_IMAGE_PIXELS / Math.max(columns, rows));
    BufferedImage image =
        new BufferedImage(edge * columns, edge * rows, BufferedImage.TYPE_INT_ARGB);
    Graphics2D pixels = image.createGraphics();
    for (int cell = 0; cell < columns * rows; cell++) {
      List<Number> colour = colourOf.apply(cell);
      if (colour != null) {
        int[] rgb = colour.stream().mapToInt(Number::intValue).toArray();
        pixels.setColor(new Color(rgb[0], rgb[1], rgb[2]));
        pixels.fillRect(edge * (cell % columns), edge * (rows - 1 - cell / columns), edge, edge);
      }
    }
    pixels.dispose();
    return image;
  }

  /**
   * Fills the area that a mask covers.
   *
   * @param mask paints on a canvas that stores shapes instead of pixels
   */
  public void through(ScriptCanvas context, Consumer<ScriptCanvas> mask, Object style) {
    ScriptCanvas cover = new ScriptCanvas(graphics, new Area());
    mask.accept(cover);
    context.fillStyle = style;
    context.fill(cover.mask);
  }
}
