package org.hificamsim.tracks.place;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;
import org.hificamsim.core.scenario.spec.Field;

/**
 * The position of a drawing or picture on the ground.
 *
 * @param scale metres per pixel or unit of the drawing, above 0
 * @param x of the lower left corner, metres
 * @param y of the lower left corner, metres
 */
public record PictureFrame(double scale, double x, double y) {
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
        return new Field(x, x + reader.getWidth(0) * scale, y, y + reader.getHeight(0) * scale);
      }
    } catch (IOException e) {
      throw TextLines.unreadable(picture.toString(), 1, e);
    }
    throw new Place(picture.toString(), 1, 1)
        .error("the file is not a picture, expected a PNG or JPEG");
  }
}
