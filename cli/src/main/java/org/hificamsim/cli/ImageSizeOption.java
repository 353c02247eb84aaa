package org.hificamsim.cli;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.check.Calibration.Size;
import picocli.CommandLine.Option;

/** The option for the size of a recording's pictures. */
final class ImageSizeOption {
  private static final Pattern SIZE = Pattern.compile("([1-9]\\d{0,5})x([1-9]\\d{0,5})");

  @Option(names = "--image", paramLabel = "WxH")
  private Optional<String> image;

  /** The size in pixels, if it is given. */
  Optional<Size> size() {
    return image.map(ImageSizeOption::size);
  }

  private static Size size(String text) {
    Matcher size = SIZE.matcher(text);
    if (!size.matches()) {
      throw new InputException("--image is '" + text + "', expected pixels such as 1920x1080");
    }
    return new Size(Integer.parseInt(size.group(1)), Integer.parseInt(size.group(2)));
  }
}
