package org.hificamsim.profiling.check;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.PlainXml;
import org.hificamsim.tracks.format.Unit;
import org.xml.sax.Attributes;

/**
 * Reads the XML of the PETS recordings: {@code <Camera>} with {@code <Geometry width height dpx
 * dpy>}, {@code <Intrinsic focal kappa1 cx cy sx>} and {@code <Extrinsic tx ty tz rx ry rz>}.
 */
final class TsaiFile extends PlainXml {
  private static final List<String> ELEMENTS = List.of("Geometry", "Intrinsic", "Extrinsic");

  private final Unit unit;
  private final List<String> found = new ArrayList<>();
  private Optional<ImageSize> said = Optional.empty();
  private double dpx;
  private double dpy;
  private double[] intrinsic = {};
  private TsaiCamera.Extrinsic extrinsic;

  TsaiFile(Unit unit) {
    this.unit = unit;
  }

  /**
   * The camera and its picture.
   *
   * @param image that somebody says; must be that of the file, where it has one
   */
  CalibratedPicture read(Path file, Optional<ImageSize> image) {
    readFile(file);
    for (String element : ELEMENTS) {
      if (!found.contains(element)) {
        throw new InputException(
            "%s: there is no <%s>, expected a calibration as the PETS recordings have it, or a"
                    .formatted(file, element)
                + " matrix of three rows and four columns");
      }
    }
    ImageSize size = size(file, image);
    return new CalibratedPicture(
        new TsaiCamera(
            extrinsic,
            new TsaiCamera.Intrinsic(
                intrinsic[0], intrinsic[1], dpx, dpy, intrinsic[2], intrinsic[3], intrinsic[4])),
        size.width(),
        size.height());
  }

  private ImageSize size(Path file, Optional<ImageSize> image) {
    if (said.isPresent() && image.isPresent() && !said.equals(image)) {
      throw new InputException(
          "--image is %s, but %s says %s".formatted(image.get(), file, said.get()));
    }
    return said.or(() -> image)
        .orElseThrow(
            () ->
                new InputException(
                    file + ": <Geometry> has no width and height, expected --image WIDTHxHEIGHT"));
  }

  @Override
  public void startElement(String uri, String local, String name, Attributes attributes) {
    if (found.contains(name)) {
      throw place().error("a second <" + name + ">, expected one camera");
    }
    switch (name) {
      case "Geometry" -> geometry(attributes);
      case "Intrinsic" -> intrinsic(attributes);
      case "Extrinsic" -> extrinsic(attributes);
      default -> {
        return;
      }
    }
    found.add(name);
  }

  private void geometry(Attributes attributes) {
    dpx = positive(attributes, "Geometry", "dpx");
    dpy = positive(attributes, "Geometry", "dpy");
    if (attributes.getValue("width") != null) {
      said =
          Optional.of(
              new ImageSize(
                  (int) positive(attributes, "Geometry", "width"),
                  (int) positive(attributes, "Geometry", "height")));
    }
  }

  private void intrinsic(Attributes attributes) {
    intrinsic =
        new double[] {
          positive(attributes, "Intrinsic", "focal"),
          number(attributes, "Intrinsic", "kappa1"),
          positive(attributes, "Intrinsic", "sx"),
          number(attributes, "Intrinsic", "cx"),
          number(attributes, "Intrinsic", "cy")
        };
  }

  private void extrinsic(Attributes attributes) {
    Vector3D shift =
        new Vector3D(
            number(attributes, "Extrinsic", "tx"),
            number(attributes, "Extrinsic", "ty"),
            number(attributes, "Extrinsic", "tz"));
    extrinsic =
        new TsaiCamera.Extrinsic(
            number(attributes, "Extrinsic", "rx"),
            number(attributes, "Extrinsic", "ry"),
            number(attributes, "Extrinsic", "rz"),
            shift.scalarMultiply(unit.metres()));
  }

  private double positive(Attributes attributes, String element, String name) {
    double value = number(attributes, element, name);
    if (!(value > 0)) {
      throw place()
          .error("<%s> %s is %s, expected a number above 0".formatted(element, name, value));
    }
    return value;
  }
}
