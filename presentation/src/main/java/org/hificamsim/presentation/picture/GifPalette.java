package org.hificamsim.presentation.picture;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * At most 255 colours for all frames of an animation, and one that is transparent: the most
 * frequent colours of a few frames, after those that must not be lost. Areas of one colour keep it
 * exactly; the rare shades of edges are rounded.
 */
final class GifPalette {
  /** The index of what shows the frame before. */
  static final int TRANSPARENT = 255;

  private final int[] colors;
  private final Map<Integer, Integer> nearest = new HashMap<>();

  private GifPalette(int[] colors) {
    this.colors = colors;
  }

  /**
   * The palette of some images; equal images give equal palettes.
   *
   * @param needed colours that it has in any case, as 0xRRGGBB, fewer than 255
   */
  static GifPalette of(List<BufferedImage> samples, IntStream needed) {
    Map<Integer, Integer> counts = new HashMap<>();
    for (BufferedImage image : samples) {
      for (int color :
          image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth())) {
        counts.merge(color & 0xFFFFFF, 1, Integer::sum);
      }
    }
    IntStream frequent =
        counts.entrySet().stream()
            .sorted(
                Map.Entry.<Integer, Integer>comparingByValue(Comparator.reverseOrder())
                    .thenComparing(Map.Entry.comparingByKey()))
            .mapToInt(Map.Entry::getKey);
    return new GifPalette(
        IntStream.concat(needed, frequent).distinct().limit(TRANSPARENT).toArray());
  }

  /** The index of the colour most like this one. */
  int index(int rgb) {
    return nearest.computeIfAbsent(rgb & 0xFFFFFF, this::search);
  }

  private int search(int rgb) {
    return IntStream.range(0, colors.length)
        .boxed()
        .min(Comparator.comparingInt(i -> squaredGap(rgb, colors[i])))
        .orElseThrow();
  }

  private static int squaredGap(int a, int b) {
    int red = (a >> 16 & 255) - (b >> 16 & 255);
    int green = (a >> 8 & 255) - (b >> 8 & 255);
    int blue = (a & 255) - (b & 255);
    return red * red + green * green + blue * blue;
  }

  /** The palette as Java 2D has it. */
  IndexColorModel model() {
    byte[][] parts = new byte[3][TRANSPARENT + 1];
    for (int i = 0; i < colors.length; i++) {
      parts[0][i] = (byte) (colors[i] >> 16);
      parts[1][i] = (byte) (colors[i] >> 8);
      parts[2][i] = (byte) colors[i];
    }
    return new IndexColorModel(8, TRANSPARENT + 1, parts[0], parts[1], parts[2], TRANSPARENT);
  }
}
