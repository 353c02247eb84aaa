package org.hificamsim.profiling.dataset;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.hificamsim.core.InputException;

/**
 * Whether a JPEG's data go on to its last line. OpenCV fills what is missing with grey and says
 * nothing, so Java's decoder is asked: it reads everything and keeps one pixel of many.
 */
public final class WholePicture {
  private static final int SPARSE = 32;

  private WholePicture() {}

  /**
   * Reads a picture through.
   *
   * @throws InputException with the file's name, when its data break off
   */
  public static void check(Path file) {
    List<String> warnings = new ArrayList<>();
    try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
      ImageReader reader = ImageIO.getImageReaders(in).next();
      try {
        reader.setInput(in, true, true);
        reader.addIIOReadWarningListener((source, warning) -> warnings.add(warning));
        readThrough(reader);
      } finally {
        reader.dispose();
      }
    } catch (IOException | RuntimeException e) {
      throw new InputException(
          file + ": cannot be decoded, expected a PNG or JPEG: " + e.getMessage(), e);
    }
    for (String warning : warnings) {
      if (breaksOff(warning)) {
        throw new InputException(
            file + ": the picture is cut short, expected a whole one (" + warning + ")");
      }
    }
  }

  /** Other formats fail by themselves. */
  private static void readThrough(ImageReader reader) throws IOException {
    if (reader.canReadRaster()) {
      ImageReadParam sparse = reader.getDefaultReadParam();
      sparse.setSourceSubsampling(SPARSE, SPARSE, 0, 0);
      reader.readRaster(0, sparse);
    }
  }

  private static boolean breaksOff(String warning) {
    String words = warning.toLowerCase(Locale.ROOT);
    return words.contains("premature end") || words.contains("missing eoi");
  }
}
