package org.hificamsim.profiling.check;

import static org.hificamsim.core.NamedSetting.setting;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.PlainXml;
import org.hificamsim.profiling.check.Calibration.Size;
import org.xml.sax.Attributes;

/** Reads the XML of the PETS recordings: {@code <Camera>} with three elements of numbers. */
final class TsaiFile extends PlainXml {
  private static final List<String> ELEMENTS = List.of("Geometry", "Intrinsic", "Extrinsic");
  private static final Set<String> POSITIVE =
      Set.of("width", "height", "dpx", "dpy", "focal", "sx");

  private final Set<String> found = new HashSet<>();
  private final Map<String, Double> numbers = new HashMap<>();

  /**
   * Reads the camera and the size of its picture.
   *
   * @param metres the length of a unit of its world, in metres
   * @param givenSize the size of the picture; must equal that of the file, if it has one
   */
  Calibration read(Path file, double metres, Optional<Size> givenSize) {
    readFile(file);
    for (String element : ELEMENTS) {
      if (!found.contains(element)) {
        throw InputException.of(
            "%s: there is no <%s>, expected a calibration as the PETS recordings have it,"
                + " or a matrix of three rows and four columns",
            file, element);
      }
    }
    return Calibration.tsai(
        new Vector3D(number("rx"), number("ry"), number("rz")),
        new Vector3D(number("tx"), number("ty"), number("tz")).scalarMultiply(metres),
        new Calibration.Lens(
            number("focal"),
            number("kappa1"),
            number("dpx"),
            number("dpy"),
            number("sx"),
            number("cx"),
            number("cy")),
        size(file, givenSize));
  }

  private Size size(Path file, Optional<Size> givenSize) {
    if (!numbers.containsKey("width")) {
      return givenSize.orElseThrow(
          () ->
              InputException.of(
                  "%s: <Geometry> has no width and height, expected %s",
                  file, setting("image", "WIDTHxHEIGHT")));
    }
    Size size = new Size(Math.floor(number("width")), Math.floor(number("height")));
    if (!givenSize.orElse(size).equals(size)) {
      throw InputException.of(
          "%s is %s, but %s says %s", setting("image"), givenSize.get(), file, size);
    }
    return size;
  }

  private double number(String name) {
    return numbers.get(name);
  }

  @Override
  public void startElement(String uri, String local, String element, Attributes attributes) {
    if (found.contains(element)) {
      throw place().error("a second <" + element + ">, expected one camera");
    }
    List<String> names =
        switch (element) {
          case "Geometry" ->
              attributes.getValue("width") == null
                  ? List.of("dpx", "dpy")
                  : List.of("dpx", "dpy", "width", "height");
          case "Intrinsic" -> List.of("focal", "kappa1", "sx", "cx", "cy");
          case "Extrinsic" -> List.of("tx", "ty", "tz", "rx", "ry", "rz");
          default -> List.of();
        };
    for (String name : names) {
      double value = number(attributes, element, name);
      if (POSITIVE.contains(name) && !(value > 0)) {
        throw place()
            .error("<%s> %s is %s, expected a number above 0".formatted(element, name, value));
      }
      numbers.put(name, value);
      found.add(element);
    }
  }
}
