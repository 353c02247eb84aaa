package org.hificamsim.presentation.plot;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.apache.batik.svggen.SVGGraphics2D;
import org.hificamsim.core.file.OutputFolder;
import org.w3c.dom.Document;
import org.w3c.dom.Element;

/** Writes pictures as PNG for screens, and as SVG and PDF for papers. It needs no display. */
public final class FigureFile {
  /** The default number of pixels per point of a PNG. */
  public static final int SCALE = 2;

  /** The formats, by the ends of file names. */
  public static final List<String> FORMATS = List.of("png", "svg", "pdf");

  /**
   * The quality of PNG by {@link ImageWriteParam}, from 0, the smallest file, to 1, the fastest.
   */
  private static final float PNG_QUALITY = 0.2f;

  private static final String SVG = "http://www.w3.org/2000/svg";

  /**
   * The document type, which is removed from files because some readers would load the DTD from the
   * network.
   */
  private static final Pattern DOCTYPE = Pattern.compile("<!DOCTYPE[^>]*>\\s*");

  static {
    System.setProperty("java.awt.headless", "true");
    paintOnce();
  }

  private FigureFile() {}

  /** Paints once in one thread, because two that start at once can deadlock (JDK-6995195). */
  private static void paintOnce() {
    Graphics2D graphics = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
    prepare(graphics, 1, 1);
    graphics.setFont(Fonts.TEXT);
    graphics.drawString("a", 0, 1);
    graphics.dispose();
  }

  /**
   * The files of a figure. Figures that share no panel can be drawn at the same time.
   *
   * @param files the bytes of each file, in the order of {@link #FORMATS}
   */
  public record Drawn(List<byte[]> files) {
    /** Writes {@code name.png}, {@code name.svg} and {@code name.pdf}. */
    public void write(OutputFolder folder, String name) throws IOException {
      for (int i = 0; i < files.size(); i++) {
        try (OutputStream out = folder.stream(name + "." + FORMATS.get(i))) {
          out.write(files.get(i));
        }
      }
    }
  }

  /** Writes {@code name.png}, {@code name.svg} and {@code name.pdf}. */
  public static void write(OutputFolder folder, String name, Figure figure) throws IOException {
    draw(figure, Optional.empty()).write(folder, name);
  }

  /** Draws a figure at a width in print; if that is empty, at the size for screens. */
  public static Drawn draw(Figure figure, Optional<PrintWidth> width) {
    Figure laidOut = width.map(print -> print.of(figure)).orElse(figure);
    SVGGraphics2D graphics = painted(laidOut);
    Element root = graphics.getRoot();
    width.ifPresent(
        print -> {
          root.setAttribute("viewBox", "0 0 " + laidOut.width() + " " + laidOut.height());
          root.setAttribute("width", print.millimetres() + "mm");
          root.setAttribute("height", print.printed(laidOut.height(), laidOut) + "mm");
        });
    try {
      ByteArrayOutputStream png = new ByteArrayOutputStream();
      png(png, laidOut, width.map(PrintWidth::pixels).orElse(SCALE * laidOut.width()));
      ByteArrayOutputStream svg = new ByteArrayOutputStream();
      stream(graphics, root, svg);
      ByteArrayOutputStream pdf = new ByteArrayOutputStream();
      PdfFile.write(pdf, laidOut, width.map(PrintWidth::points).orElse((double) laidOut.width()));
      return new Drawn(List.of(png.toByteArray(), svg.toByteArray(), pdf.toByteArray()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Writes a PNG image with {@link #SCALE} pixels per point. */
  public static void png(OutputStream out, Paintable picture) throws IOException {
    png(out, picture, SCALE * picture.width());
  }

  /**
   * Writes a PNG image.
   *
   * @param width the width in pixels
   */
  public static void png(OutputStream out, Paintable picture, int width) throws IOException {
    compress(image(picture, width), out);
  }

  /**
   * Paints a picture on white.
   *
   * @param width the width in pixels; the height follows
   */
  public static BufferedImage image(Paintable picture, int width) {
    double scale = (double) width / picture.width();
    int height = (int) Math.round(scale * picture.height());
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    graphics.scale(scale, scale);
    paint(picture, graphics);
    graphics.dispose();
    return image;
  }

  /** Writes a picture in one of the {@link #FORMATS}. */
  public static void write(OutputStream out, String format, Paintable picture) throws IOException {
    switch (format) {
      case "png" -> png(out, picture);
      case "svg" -> svg(out, picture);
      case "pdf" -> PdfFile.write(out, picture, picture.width());
      default -> throw new IllegalArgumentException(format);
    }
  }

  static void paint(Paintable picture, Graphics2D graphics) {
    prepare(graphics, picture.width(), picture.height());
    picture.paint(graphics);
  }

  private static void prepare(Graphics2D graphics, int width, int height) {
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    graphics.setColor(Color.WHITE);
    graphics.fill(new Rectangle2D.Double(0, 0, width, height));
  }

  /** Writes a PNG within 5 % of the smallest size, in a quarter of the time. */
  private static void compress(BufferedImage image, OutputStream out) throws IOException {
    ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
    try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
      ImageWriteParam settings = writer.getDefaultWriteParam();
      settings.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
      settings.setCompressionQuality(PNG_QUALITY);
      writer.setOutput(stream);
      writer.write(null, new IIOImage(image, null, null), settings);
    } finally {
      writer.dispose();
    }
  }

  /** Writes a PDF document whose text can be searched. */
  public static void pages(OutputStream out, List<? extends Paintable> pages) throws IOException {
    PdfFile.write(out, pages);
  }

  /** Writes an SVG document. */
  public static void svg(OutputStream out, Paintable picture) throws IOException {
    SVGGraphics2D graphics = painted(picture);
    stream(graphics, graphics.getRoot(), out);
  }

  private static SVGGraphics2D painted(Paintable picture) {
    SVGGraphics2D graphics = new SVGGraphics2D(new SvgContext(document()), false);
    graphics.setSVGCanvasSize(new Dimension(picture.width(), picture.height()));
    paint(picture, graphics);
    return graphics;
  }

  private static void stream(SVGGraphics2D graphics, Element root, OutputStream out)
      throws IOException {
    StringWriter text = new StringWriter();
    graphics.stream(root, text, true, false);
    out.write(DOCTYPE.matcher(text.toString()).replaceFirst("").getBytes(StandardCharsets.UTF_8));
  }

  private static Document document() {
    try {
      return DocumentBuilderFactory.newInstance()
          .newDocumentBuilder()
          .getDOMImplementation()
          .createDocument(SVG, "svg", null);
    } catch (ParserConfigurationException e) {
      throw new IllegalStateException("every Java platform has an XML parser", e);
    }
  }
}
