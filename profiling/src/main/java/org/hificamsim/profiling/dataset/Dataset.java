package org.hificamsim.profiling.dataset;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * Photos of objects with the physical properties of each (thesis 3.5).
 *
 * @param samples the samples in the order of the table
 * @param templates the close-up of each object, by the object's name
 * @param negatives photos without any of the objects
 */
public record Dataset(
    Path folder,
    PhotoCamera camera,
    List<LabelledPhoto> samples,
    Map<String, Path> templates,
    List<Path> negatives) {
  /** The table's file name. */
  public static final String TABLE = "dataset.csv";

  /** The camera's file name. */
  public static final String CAMERA = "camera.json";

  /** The file name of patches in COCO's format, which fill in for empty patch columns. */
  public static final String COCO = "coco.json";

  /** The folder with photos without any of the objects. */
  public static final String NEGATIVES = "negatives";

  public Dataset {
    samples = List.copyOf(samples);
    negatives = List.copyOf(negatives);
  }

  /** Returns the number of pixels of the largest picture. */
  public long largestPicture() {
    return Math.max(
        camera.pixels(),
        templates.values().stream().mapToLong(ImageHeader::pixels).max().orElse(0));
  }
}
