package org.hificamsim.profiling.detector;

import static org.hificamsim.core.NamedSetting.setting;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.CvException;
import org.opencv.core.Mat;
import org.opencv.core.MatOfByte;
import org.opencv.imgcodecs.Imgcodecs;

/** A picture file that is decoded on demand. {@link #close} releases the decoded pictures. */
public final class Photograph implements AutoCloseable {
  private static final int SUBSAMPLING = 32;
  private static final int PNG_SIGNATURE_BYTES = 8;
  private static final int CHUNK_TYPE_BYTES = 4;
  private static final List<String> DAMAGE_WARNINGS =
      List.of("premature end", "missing eoi", "corrupt");

  private final Path file;
  private final Mats mats = new Mats();
  private final Map<Integer, Mat> decoded = new LinkedHashMap<>();

  public Photograph(Path file) {
    this.file = file;
  }

  /**
   * Returns the picture in 8-bit grey.
   *
   * @throws InputException with the file's name, when it is not a complete picture
   */
  public Mat grey() {
    return decoded.computeIfAbsent(Imgcodecs.IMREAD_GRAYSCALE, this::decode);
  }

  /**
   * Returns the picture in 8-bit blue, green and red.
   *
   * @throws InputException with the file's name, when it is not a complete picture
   */
  public Mat colour() {
    return decoded.computeIfAbsent(Imgcodecs.IMREAD_COLOR, this::decode);
  }

  private Mat decode(int mode) {
    checkWhole();
    Mat picture = mats.own(Imgcodecs.imread(file.toString(), mode));
    if (picture.empty()) {
      throw new InputException(file + ": cannot be decoded, expected a PNG or JPEG");
    }
    return picture;
  }

  /**
   * Rejects a truncated or damaged picture. OpenCV silently fills missing parts of a JPEG with
   * grey, so JPEGs are also read with Java's decoder, subsampled to save memory. For PNGs, the
   * checksum of each chunk is verified (PNG specification, 5.3).
   */
  private void checkWhole() {
    List<String> warnings = new ArrayList<>();
    try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
      ImageReader reader = ImageIO.getImageReaders(in).next();
      try {
        reader.setInput(in, true, true);
        reader.addIIOReadWarningListener((source, warning) -> warnings.add(warning));
        if (reader.getFormatName().equalsIgnoreCase("png")) {
          checkChunks(in);
        } else if (reader.canReadRaster()) { // decoding of other formats fails later
          ImageReadParam subsampled = reader.getDefaultReadParam();
          subsampled.setSourceSubsampling(SUBSAMPLING, SUBSAMPLING, 0, 0);
          reader.readRaster(0, subsampled);
        }
      } finally {
        reader.dispose();
      }
    } catch (IOException | RuntimeException e) {
      throw new InputException(
          file + ": cannot be decoded, expected a PNG or JPEG: " + e.getMessage(), e);
    }
    for (String warning : warnings) {
      String words = warning.toLowerCase(Locale.ROOT);
      if (DAMAGE_WARNINGS.stream().anyMatch(words::contains)) {
        throw InputException.of(
            "%s: the picture is damaged, expected a whole one (%s)", file, warning);
      }
    }
  }

  private static void checkChunks(ImageInputStream in) throws IOException {
    in.seek(PNG_SIGNATURE_BYTES);
    boolean last = false;
    while (!last) {
      int length = in.readInt();
      if (length < 0 || length > in.length()) { // checked before memory is allocated
        throw new IOException("a chunk of " + length + " bytes");
      }
      byte[] chunk = new byte[CHUNK_TYPE_BYTES + length];
      in.readFully(chunk);
      CRC32 sum = new CRC32();
      sum.update(chunk);
      if (in.readInt() != (int) sum.getValue()) {
        throw new IOException("a chunk is damaged");
      }
      last = new String(chunk, 0, CHUNK_TYPE_BYTES, StandardCharsets.US_ASCII).equals("IEND");
    }
  }

  /**
   * Runs a detector on the picture.
   *
   * @throws InputException in one line with the file and the detector, when OpenCV fails or memory
   *     runs out
   */
  public <T> T detect(String detector, Supplier<T> work) {
    try {
      return work.get();
    } catch (CvException | OutOfMemoryError e) {
      String reason = String.valueOf(e.getMessage()).lines().findFirst().orElse("").strip();
      throw InputException.of(
              "%s: %s fails, expected a picture that it can take (%s). Maybe there is too"
                  + " little memory: use smaller photos, fewer %s or other %s",
              file, detector, reason, setting("threads"), setting("detectors"))
          .because(e);
    }
  }

  /** Writes a picture to a folder, in the format of the ending of its name. */
  public static void write(OutputFolder folder, String name, Mat picture) {
    try (Mats mats = new Mats()) {
      MatOfByte bytes = mats.own(new MatOfByte());
      if (!Imgcodecs.imencode(name.substring(name.lastIndexOf('.')), picture, bytes)) {
        throw new IllegalStateException("OpenCV cannot encode " + name);
      }
      folder.write(name, bytes.toArray());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() {
    mats.close();
  }
}
