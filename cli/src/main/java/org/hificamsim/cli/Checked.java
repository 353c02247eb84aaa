package org.hificamsim.cli;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.Place;
import org.hificamsim.core.scenario.Scenario;

/**
 * What {@code validate} finds out about one file.
 *
 * @param scenario empty where there are errors
 * @param errors lines with their place
 * @param warnings lines with their place, most of them
 */
record Checked(Path file, Optional<Scenario> scenario, List<String> errors, List<String> warnings) {
  private static final int MAX = 100;

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

  /** The same for programs. */
  record Entry(
      String file, boolean valid, String description, List<Remark> errors, List<Remark> warnings) {}

  boolean valid() {
    return errors.isEmpty();
  }

  /** The same with warnings as errors. */
  Checked strict() {
    List<String> all = new ArrayList<>(warnings.stream().map(ScenarioOptions::asError).toList());
    all.addAll(errors);
    return new Checked(file, scenario, all, List.of());
  }

  void print(PrintWriter out, PrintWriter err) {
    lines(err, "warning: ", warnings);
    lines(err, "error: ", errors);
    if (valid()) {
      out.println(file + ": ok, " + Descriptions.of(scenario.orElseThrow()));
    }
  }

  private void lines(PrintWriter err, String start, List<String> lines) {
    lines.stream().limit(MAX).forEach(line -> err.println(start + Place.printable(line)));
    if (lines.size() > MAX) {
      err.println(start + file + ": " + (lines.size() - MAX) + " more, expected none");
    }
  }

  Entry entry() {
    return new Entry(
        file.toString(),
        valid(),
        scenario.map(Descriptions::of).orElse(""),
        errors.stream().map(line -> Remark.of(file, line)).toList(),
        warnings.stream().map(line -> Remark.of(file, line)).toList());
  }
}
