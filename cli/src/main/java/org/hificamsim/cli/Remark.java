package org.hificamsim.cli;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * An error or warning about a file, for programs.
 *
 * @param line from 1; null, and not written, where the remark is about the whole file
 */
@JsonInclude(JsonInclude.Include.NON_NULL)
record Remark(Integer line, Integer column, String message) {
  private static final Pattern PLACE = Pattern.compile("(\\d+):(\\d+): (.*)");

  /** Of the line that people get: {@code FILE:LINE:COLUMN: message}. */
  static Remark of(Path file, String text) {
    String rest = text.startsWith(file + ":") ? text.substring((file + ":").length()) : text;
    Matcher place = PLACE.matcher(rest);
    return place.matches()
        ? new Remark(
            Integer.valueOf(place.group(1)), Integer.valueOf(place.group(2)), place.group(3))
        : new Remark(null, null, rest.strip());
  }
}
