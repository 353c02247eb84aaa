package org.hificamsim.profiling.detector;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.dataset.WholePicture;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Mat;
import org.opencv.imgcodecs.Imgcodecs;

/** A picture file, decoded when it is asked for, and released with this. */
public final class Photograph implements AutoCloseable {
  private final Path file;
  private final Mats mats = new Mats();
  private final Map<Integer, Mat> decoded = new LinkedHashMap<>();

  public Photograph(Path file) {
    this.file = file;
  }

  public Path file() {
    return file;
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
    WholePicture.check(file);
    Mat picture = mats.own(Imgcodecs.imread(file.toString(), mode));
    if (picture.empty()) {
      throw new InputException(file + ": cannot be decoded, expected a PNG or JPEG");
    }
    return picture;
  }

  @Override
  public void close() {
    mats.close();
  }
}
