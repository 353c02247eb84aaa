package org.hificamsim.profiling.dataset;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;

/** How large a PNG or JPEG is when it is shown: turned as its EXIF says. */
record ImageHeader(int width, int height) {
  private static final byte[] PNG_END = {'I', 'E', 'N', 'D'};
  private static final byte[] JPEG_END = {(byte) 0xFF, (byte) 0xD9};
  private static final int TAIL = 64;

  /**
   * Reads the header, and checks that the file has its end.
   *
   * @throws IOException in one line, when it is no whole PNG or JPEG
   */
  static ImageHeader read(Path file) throws IOException {
    if (!Files.isRegularFile(file)) {
      throw new IOException("no such file");
    }
    try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
      Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
      if (!readers.hasNext()) {
        throw new IOException("no PNG or JPEG");
      }
      ImageReader reader = readers.next();
      try {
        reader.setInput(in, true, true);
        checkEnd(file, reader.getFormatName());
        ImageHeader stored = new ImageHeader(reader.getWidth(0), reader.getHeight(0));
        return Exif.isUpright(file) ? stored.turned() : stored;
      } finally {
        reader.dispose();
      }
    }
  }

  /** The pixels of a picture that has been read before. */
  static long pixels(Path file) {
    try {
      ImageHeader header = read(file);
      return (long) header.width * header.height;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private ImageHeader turned() {
    return new ImageHeader(/* width= */ height, /* height= */ width);
  }

  private static void checkEnd(Path file, String format) throws IOException {
    byte[] end =
        switch (format) {
          case "png" -> PNG_END;
          case "JPEG" -> JPEG_END;
          default -> throw new IOException("no PNG or JPEG but " + format);
        };
    try (RandomAccessFile bytes = new RandomAccessFile(file.toFile(), "r")) {
      byte[] tail = new byte[(int) Math.min(TAIL, bytes.length())];
      bytes.seek(bytes.length() - tail.length);
      bytes.readFully(tail);
      for (int i = 0; i + end.length <= tail.length; i++) {
        if (Arrays.equals(tail, i, i + end.length, end, 0, end.length)) {
          return;
        }
      }
    }
    throw new IOException("the file is cut short");
  }
}
