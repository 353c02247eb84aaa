package org.hificamsim.presentation.picture;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntFunction;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * Writes an animation as a GIF that repeats for ever. To make the file small, all frames share one
 * palette, and each stores only its differences from the previous one. The palette has the most
 * frequent colours of a few frames, and a transparent one for what stays the same. Areas of one
 * colour keep it exactly; rare shades at edges are rounded.
 */
final class GifFile {
  private static final String STREAM_FORMAT = "javax_imageio_gif_stream_1.0";
  private static final String IMAGE_FORMAT = "javax_imageio_gif_image_1.0";
  private static final int PALETTE_FRAMES = 5;

  /** The index of the transparent colour. */
  private static final int TRANSPARENT = 255;

  private final IndexColorModel colors;
  private final Map<Integer, Integer> indexes = new HashMap<>();
  private final int delay;
  private int[] lastPixels; // null before the first frame

  private GifFile(IndexColorModel colors, int delay) {
    this.colors = colors;
    this.delay = delay;
  }

  /**
   * Writes the animation.
   *
   * @param count the number of frames, 1 or more
   * @param frames returns the frames by number, all of the same size
   * @param delay the time between two frames, hundredths of a second
   */
  static void write(OutputStream out, int count, IntFunction<BufferedImage> frames, int delay)
      throws IOException {
    List<BufferedImage> typical =
        IntStream.range(0, PALETTE_FRAMES)
            .map(i -> i * (count - 1) / (PALETTE_FRAMES - 1))
            .distinct()
            .mapToObj(frames)
            .toList();
    GifFile file = new GifFile(palette(typical), delay);
    ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
    try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
      writer.setOutput(stream);
      writer.prepareWriteSequence(file.header(writer));
      for (int i = 0; i < count; i++) {
        file.append(writer, frames.apply(i), i == 0);
      }
      writer.endWriteSequence();
    } finally {
      writer.dispose();
    }
  }

  private static IndexColorModel palette(List<BufferedImage> frames) {
    Map<Integer, Integer> counts = new TreeMap<>();
    for (BufferedImage image : frames) {
      for (int color : pixels(image)) {
        counts.merge(color, 1, Integer::sum);
      }
    }
    int[] frequent =
        counts.entrySet().stream()
            .sorted(Map.Entry.comparingByValue(Comparator.reverseOrder()))
            .mapToInt(Map.Entry::getKey)
            .limit(TRANSPARENT)
            .toArray();
    int[] palette = Arrays.copyOf(frequent, TRANSPARENT + 1);
    Arrays.fill(palette, frequent.length, TRANSPARENT, palette[0]);
    return new IndexColorModel(
        8, palette.length, palette, 0, false, TRANSPARENT, DataBuffer.TYPE_BYTE);
  }

  private static int[] pixels(BufferedImage image) {
    int width = image.getWidth();
    return image.getRGB(0, 0, width, image.getHeight(), null, 0, width);
  }

  /** Returns the header of the file, which has the palette. */
  private IIOMetadata header(ImageWriter writer) throws IOException {
    IIOMetadataNode root = new IIOMetadataNode(STREAM_FORMAT);
    String attributes = "sizeOfGlobalColorTable=256 backgroundColorIndex=0 sortFlag=FALSE";
    IIOMetadataNode table = add(root, "GlobalColorTable", attributes);
    for (int i = 0; i < colors.getMapSize(); i++) {
      Color color = new Color(colors.getRGB(i));
      String parts = "index=%s red=%s green=%s blue=%s";
      add(
          table,
          "ColorTableEntry",
          parts.formatted(i, color.getRed(), color.getGreen(), color.getBlue()));
    }
    IIOMetadata metadata = writer.getDefaultStreamMetadata(null);
    metadata.mergeTree(STREAM_FORMAT, root);
    return metadata;
  }

  private void append(ImageWriter writer, BufferedImage frame, boolean first) throws IOException {
    BufferedImage indexed = difference(frame);
    IIOMetadataNode root = new IIOMetadataNode(IMAGE_FORMAT);
    String control =
        "disposalMethod=doNotDispose userInputFlag=FALSE transparentColorFlag=TRUE"
            + " transparentColorIndex=%s delayTime=%s";
    add(root, "GraphicControlExtension", control.formatted(TRANSPARENT, delay));
    if (first) { // Netscape's extension for repeating the animation for ever
      IIOMetadataNode extensions = add(root, "ApplicationExtensions", "");
      add(extensions, "ApplicationExtension", "applicationID=NETSCAPE authenticationCode=2.0")
          .setUserObject(new byte[] {1, 0, 0});
    }
    IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(indexed), null);
    metadata.mergeTree(IMAGE_FORMAT, root);
    writer.writeToSequence(new IIOImage(indexed, null, metadata), null);
  }

  /** Adds a node with attributes {@code name=value ...}. */
  private static IIOMetadataNode add(IIOMetadataNode parent, String name, String attributes) {
    IIOMetadataNode child = new IIOMetadataNode(name);
    Pattern.compile("(\\w+)=(\\S+)")
        .matcher(attributes)
        .results()
        .forEach(pair -> child.setAttribute(pair.group(1), pair.group(2)));
    parent.appendChild(child);
    return child;
  }

  /** Returns a frame in the palette's colours, transparent where it equals the last frame. */
  private BufferedImage difference(BufferedImage frame) {
    int[] pixels = pixels(frame);
    byte[] shown = new byte[pixels.length];
    for (int i = 0; i < pixels.length; i++) {
      pixels[i] = indexes.computeIfAbsent(pixels[i], this::nearest);
      boolean same = lastPixels != null && lastPixels[i] == pixels[i];
      shown[i] = (byte) (same ? TRANSPARENT : pixels[i]);
    }
    lastPixels = pixels;
    int width = frame.getWidth();
    int height = frame.getHeight();
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_INDEXED, colors);
    image.getRaster().setDataElements(0, 0, width, height, shown);
    return image;
  }

  private int nearest(int rgb) {
    return ((byte[]) colors.getDataElements(rgb, null))[0] & 0xFF;
  }
}
