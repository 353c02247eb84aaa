package org.hificamsim.tracks.place;

import static org.hificamsim.core.NamedSetting.setting;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;
import org.hificamsim.core.scenario.spec.Field;

/**
 * The position of a drawing or picture on the ground.
 *
 * @param x x of the lower left corner, in metres
 * @param y y of the lower left corner, in metres
 */
public record PictureFrame(PlanScale scale, double x, double y) {
  /**
   * Returns the area that a picture shows.
   *
   * @throws org.hificamsim.core.InputException if the picture is missing or not a PNG or JPEG
   */
  public Field area(Path picture) {
    try (ImageInputStream in = ImageIO.createImageInputStream(TextLines.stream(picture))) {
      Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
      if (readers.hasNext()) {
        ImageReader reader = readers.next();
        reader.setInput(in);
        double metres = metresPerPixel(picture, reader.getWidth(0));
        double right = rounded(x + reader.getWidth(0) * metres);
        return new Field(x, right, y, rounded(y + reader.getHeight(0) * metres));
      }
    } catch (IOException e) {
      throw TextLines.unreadable(picture.toString(), 1, e);
    }
    throw new Place(picture.toString(), 1, 1)
        .error("the file is not a picture, expected a PNG or JPEG");
  }

  /** A coordinate in millimetres, as people write it, in metres. */
  private static double rounded(double metres) {
    return Math.rint(1000 * metres) / 1000;
  }

  private double metresPerPixel(Path picture, int pixels) {
    if (scale instanceof PlanScale.PerUnit perUnit) {
      return perUnit.metres();
    }
    if (scale instanceof PlanScale.Width width) {
      return width.metres() / pixels;
    }
    throw InputException.of(
        "%s: a picture has no size on paper, expected %s, the metres of a pixel",
        picture, setting("scale", "M"));
  }
}
