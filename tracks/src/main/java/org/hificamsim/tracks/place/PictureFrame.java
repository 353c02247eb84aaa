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
 * Where a drawing or a picture lies on the ground.
 *
 * @param scale metres that a pixel or unit of it is, above 0
 * @param x of its lower left corner, metres
 * @param y of its lower left corner, metres
 */
public record PictureFrame(double scale, double x, double y) {
  /**
   * The ground that a picture shows.
   *
   * @throws org.hificamsim.core.InputException when it is missing or no PNG or JPEG
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
    throw new Place(picture.toString(), 1, 1).error("no picture, expected a PNG or JPEG");
  }
}
