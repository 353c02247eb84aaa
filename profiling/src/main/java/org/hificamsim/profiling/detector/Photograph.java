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

/** A picture file, decoded when it is asked for, and released with this. */
public final class Photograph implements AutoCloseable {
  private static final int SPARSE = 32;
  private static final int SIGNATURE = 8; // bytes at a PNG's start
  private static final int TYPE = 4; // bytes
  private static final List<String> DAMAGE = List.of("premature end", "missing eoi", "corrupt");

  private final Path file;
  private final Mats mats = new Mats();
  private final Map<Integer, Mat> decoded = new LinkedHashMap<>();

  public Photograph(Path file) {
    this.file = file;
  }

  /**
   * In 8-bit grey.
   *
   * @throws InputException with the file's name, when it is no whole picture
   */
  public Mat grey() {
    return decoded.computeIfAbsent(Imgcodecs.IMREAD_GRAYSCALE, this::decode);
  }

  /**
   * In 8-bit blue, green and red.
   *
   * @throws InputException with the file's name, when it is no whole picture
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
   * Refuses a picture whose data break off or were changed. Of a JPEG, OpenCV fills what is missing
   * with grey and says nothing, so Java's decoder is asked: it reads everything and keeps one pixel
   * of many. Of a PNG, the checksum of each chunk is looked at (PNG specification, 5.3).
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
        } else if (reader.canReadRaster()) { // other formats fail by themselves
          ImageReadParam sparse = reader.getDefaultReadParam();
          sparse.setSourceSubsampling(SPARSE, SPARSE, 0, 0);
          reader.readRaster(0, sparse);
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
      if (DAMAGE.stream().anyMatch(words::contains)) {
        throw InputException.of(
            "%s: the picture is damaged, expected a whole one (%s)", file, warning);
      }
    }
  }

  private static void checkChunks(ImageInputStream in) throws IOException {
    in.seek(SIGNATURE);
    boolean last = false;
    while (!last) {
      int length = in.readInt();
      if (length < 0 || length > in.length()) { // refused before there is room for it
        throw new IOException("a chunk of " + length + " bytes");
      }
      byte[] chunk = new byte[TYPE + length];
      in.readFully(chunk);
      CRC32 sum = new CRC32();
      sum.update(chunk);
      if (in.readInt() != (int) sum.getValue()) {
        throw new IOException("a chunk is damaged");
      }
      last = new String(chunk, 0, TYPE, StandardCharsets.US_ASCII).equals("IEND");
    }
  }

  /**
   * Does a detector's work on the picture.
   *
   * @throws InputException in one line with the file and the detector, where OpenCV or the memory
   *     gives out
   */
  public <T> T lookedAt(String detector, Supplier<T> work) {
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

  /** Adds a picture to a folder's files, in the format that its name ends in. */
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
