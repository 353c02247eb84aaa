package org.hificamsim.profiling.dataset;

import com.drew.imaging.ImageMetadataReader;
import com.drew.imaging.ImageProcessingException;
import com.drew.metadata.Directory;
import com.drew.metadata.exif.ExifIFD0Directory;
import com.drew.metadata.exif.ExifSubIFDDirectory;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;

/** The size of a PNG or JPEG as it is displayed, rotated according to its EXIF data. */
record ImageHeader(int width, int height) {
  private static final byte[] PNG_END = {'I', 'E', 'N', 'D'};
  private static final byte[] JPEG_END = {(byte) 0xFF, (byte) 0xD9};
  private static final int TAIL_BYTES = 64;
  private static final double MILLIMETRE = 1e-3;

  /** The first EXIF orientation that swaps width and height. */
  private static final int FIRST_TURNED_ORIENTATION = 5;

  private static final int LAST_ORIENTATION = 8;

  /**
   * Reads the header and checks that the file is not cut short.
   *
   * @throws IOException in one line, when the file is not a complete PNG or JPEG
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
        return isTurned(file) ? stored.turned() : stored;
      } finally {
        reader.dispose();
      }
    }
  }

  /** Returns the number of pixels of a picture that has been read before. */
  static long pixels(Path file) {
    try {
      ImageHeader header = read(file);
      return (long) header.width * header.height;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the focal length in metres, possibly infinite; empty if the photo has none above 0. */
  static OptionalDouble focalLength(Path photo) {
    return directories(photo, ExifSubIFDDirectory.class).stream()
        .map(directory -> directory.getDoubleObject(ExifSubIFDDirectory.TAG_FOCAL_LENGTH))
        .filter(Objects::nonNull)
        .mapToDouble(millimetres -> millimetres * MILLIMETRE)
        .filter(metres -> metres > 0)
        .findFirst();
  }

  /** Whether the photo is displayed rotated by a quarter turn, as OpenCV reads it. */
  private static boolean isTurned(Path photo) {
    return directories(photo, ExifIFD0Directory.class).stream()
        .map(directory -> directory.getInteger(ExifIFD0Directory.TAG_ORIENTATION))
        .anyMatch(
            orientation ->
                orientation != null
                    && orientation >= FIRST_TURNED_ORIENTATION
                    && orientation <= LAST_ORIENTATION);
  }

  private static <D extends Directory> Collection<D> directories(Path photo, Class<D> kind) {
    try {
      return ImageMetadataReader.readMetadata(photo.toFile()).getDirectoriesOfType(kind);
    } catch (ImageProcessingException | IOException e) {
      return List.of();
    }
  }

  private ImageHeader turned() {
    return new ImageHeader(/* width= */ height, /* height= */ width);
  }

  private static void checkEnd(Path file, String format) throws IOException {
    boolean whole =
        switch (format) {
          case "png" -> tailHas(file, PNG_END);
          case "JPEG" -> tailHas(file, JPEG_END) || JpegEnd.isIn(file);
          default -> throw new IOException("no PNG or JPEG but " + format);
        };
    if (!whole) {
      throw new IOException("the file is cut short");
    }
  }

  private static boolean tailHas(Path file, byte[] end) throws IOException {
    try (RandomAccessFile bytes = new RandomAccessFile(file.toFile(), "r")) {
      byte[] tail = new byte[(int) Math.min(TAIL_BYTES, bytes.length())];
      bytes.seek(bytes.length() - tail.length);
      bytes.readFully(tail);
      return IntStream.rangeClosed(0, tail.length - end.length)
          .anyMatch(i -> Arrays.equals(tail, i, i + end.length, end, 0, end.length));
    }
  }
}
