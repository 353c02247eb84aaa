package org.hificamsim.presentation.picture;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * Writes an animation as GIF: one palette, and of each frame what differs from the one before. It
 * goes on for ever.
 */
final class GifFile {
  private static final String HEAD = "javax_imageio_gif_stream_1.0";
  private static final String FORMAT = "javax_imageio_gif_image_1.0";
  private static final int SAMPLES = 5;

  private final GifPalette palette;
  private final IndexColorModel colors;
  private final int delay;
  private int[] before;

  private GifFile(GifPalette palette, int delay) {
    this.palette = palette;
    this.colors = palette.model();
    this.delay = delay;
  }

  /**
   * Writes the animation.
   *
   * @param count of frames, 1 or more
   * @param frames all of the same size
   * @param delay between two frames, hundredths of a second
   */
  static void write(OutputStream out, int count, IntFunction<BufferedImage> frames, int delay)
      throws IOException {
    List<BufferedImage> samples =
        IntStream.range(0, SAMPLES)
            .map(i -> i * (count - 1) / (SAMPLES - 1))
            .distinct()
            .mapToObj(frames)
            .toList();
    GifFile file = new GifFile(GifPalette.of(samples, CoverClass.shades()), delay);
    ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
    try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
      writer.setOutput(stream);
      writer.prepareWriteSequence(file.head(writer));
      for (int i = 0; i < count; i++) {
        file.append(writer, frames.apply(i), i == 0);
      }
      writer.endWriteSequence();
    } finally {
      writer.dispose();
    }
  }

  /** What stands before all frames: the palette. */
  private IIOMetadata head(ImageWriter writer) throws IOException {
    IIOMetadata metadata = writer.getDefaultStreamMetadata(null);
    IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(HEAD);
    IIOMetadataNode table = child(root, "GlobalColorTable");
    table.setAttribute("sizeOfGlobalColorTable", Integer.toString(colors.getMapSize()));
    table.setAttribute("backgroundColorIndex", "0");
    table.setAttribute("sortFlag", "FALSE");
    while (table.hasChildNodes()) {
      table.removeChild(table.getFirstChild());
    }
    for (int i = 0; i < colors.getMapSize(); i++) {
      IIOMetadataNode entry = new IIOMetadataNode("ColorTableEntry");
      entry.setAttribute("index", Integer.toString(i));
      entry.setAttribute("red", Integer.toString(colors.getRed(i)));
      entry.setAttribute("green", Integer.toString(colors.getGreen(i)));
      entry.setAttribute("blue", Integer.toString(colors.getBlue(i)));
      table.appendChild(entry);
    }
    metadata.setFromTree(HEAD, root);
    return metadata;
  }

  private void append(ImageWriter writer, BufferedImage frame, boolean first) throws IOException {
    BufferedImage indexed = difference(frame);
    IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(indexed), null);
    IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(FORMAT);
    IIOMetadataNode control = child(root, "GraphicControlExtension");
    control.setAttribute("disposalMethod", "doNotDispose");
    control.setAttribute("userInputFlag", "FALSE");
    control.setAttribute("transparentColorFlag", "TRUE");
    control.setAttribute("transparentColorIndex", Integer.toString(GifPalette.TRANSPARENT));
    control.setAttribute("delayTime", Integer.toString(delay));
    if (first) {
      repeatForEver(child(root, "ApplicationExtensions"));
    }
    metadata.setFromTree(FORMAT, root);
    writer.writeToSequence(new IIOImage(indexed, null, metadata), null);
  }

  /** Netscape's extension: a loop without an end. */
  private static void repeatForEver(IIOMetadataNode extensions) {
    IIOMetadataNode netscape = new IIOMetadataNode("ApplicationExtension");
    netscape.setAttribute("applicationID", "NETSCAPE");
    netscape.setAttribute("authenticationCode", "2.0");
    netscape.setUserObject(new byte[] {1, 0, 0});
    extensions.appendChild(netscape);
  }

  /** The frame in the palette's colours; transparent where the frame before had the same. */
  private BufferedImage difference(BufferedImage frame) {
    int width = frame.getWidth();
    int height = frame.getHeight();
    int[] pixels = frame.getRGB(0, 0, width, height, null, 0, width);
    byte[] indexes = new byte[pixels.length];
    for (int i = 0; i < pixels.length; i++) {
      pixels[i] = palette.index(pixels[i]);
      boolean same = before != null && before[i] == pixels[i];
      indexes[i] = (byte) (same ? GifPalette.TRANSPARENT : pixels[i]);
    }
    before = pixels;
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_INDEXED, colors);
    image.getRaster().setDataElements(0, 0, width, height, indexes);
    return image;
  }

  private static IIOMetadataNode child(IIOMetadataNode parent, String name) {
    for (int i = 0; i < parent.getLength(); i++) {
      if (parent.item(i).getNodeName().equals(name)) {
        return (IIOMetadataNode) parent.item(i);
      }
    }
    IIOMetadataNode child = new IIOMetadataNode(name);
    parent.appendChild(child);
    return child;
  }
}
