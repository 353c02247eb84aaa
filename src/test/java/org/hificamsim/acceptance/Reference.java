package org.hificamsim.acceptance;

import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.io.IOException;
import java.lang.reflect.Field;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.ScenarioFormat;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.output.Column;
import org.hificamsim.runs.output.Table;

/**
 * The parts of the documentation that follow from declarations in the code. Each stands in a page
 * between the lines {@code <!-- reference: NAME -->} and {@code <!-- end of reference -->}; {@code
 * gradle reference} writes them there.
 */
public final class Reference {
  private static final Pattern COMMAND = Pattern.compile("(?m)^  ([a-z][a-z-]+) .*");
  private static final Pattern BEGIN = Pattern.compile("<!-- reference: (.+) -->");
  private static final String END = "<!-- end of reference -->";
  private static final List<String> ELEMENTS =
      List.of("simulation", "camera", "object", "optics", "obstacles", "zone", "events");

  private Reference() {}

  /** Writes all parts into the pages of a folder. */
  public static void main(String[] args) throws IOException {
    Map<String, String> parts = parts();
    for (Path page : pages(Path.of(args[0]))) {
      Files.writeString(page, updated(Files.readString(page), parts));
    }
  }

  /** Returns the pages of a folder, sorted by name. */
  static List<Path> pages(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(file -> file.toString().endsWith(".md")).sorted().toList();
    }
  }

  /** Returns the names of the parts of a page, in their order. */
  static List<String> names(String page) {
    return page.lines().map(BEGIN::matcher).filter(Matcher::matches).map(m -> m.group(1)).toList();
  }

  /**
   * Returns a page with new parts.
   *
   * @throws IllegalArgumentException if a part is unknown or has no end
   */
  static String updated(String page, Map<String, String> parts) {
    StringBuilder updated = new StringBuilder();
    String open = null;
    for (String line : page.lines().toList()) {
      Matcher begin = BEGIN.matcher(line);
      if (begin.matches()) {
        require(open == null && parts.containsKey(begin.group(1)), line);
        open = begin.group(1);
        updated.append(line).append("\n\n").append(parts.get(open).strip()).append("\n\n");
      }
      if (line.equals(END)) {
        require(open != null, line);
        open = null;
      }
      if (open == null) {
        updated.append(line).append('\n');
      }
    }
    require(open == null, "reference: " + open);
    return updated.toString();
  }

  private static void require(boolean expected, String line) {
    if (!expected) {
      throw new IllegalArgumentException("unexpected or unfinished in a page: " + line);
    }
  }

  /** Returns every part in Markdown, by name. */
  static Map<String, String> parts() {
    Map<String, String> parts = new TreeMap<>();
    tables().forEach((file, table) -> parts.put("columns of " + file, columns(table)));
    ELEMENTS.forEach(name -> parts.put("attributes of " + name, ScenarioFormat.table(name)));
    parts.put("metrics", metrics());
    parts.put("commands", String.join("", help(2, List.of()).toList()));
    parts.put("policies", policies());
    parts.put("detection models", detections());
    return parts;
  }

  private static Map<String, Table<?>> tables() {
    Map<String, Table<?>> tables = new TreeMap<>();
    new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
            .importPackages("org.hificamsim")
            .stream()
            .flatMap(type -> type.getFields().stream())
            .filter(field -> field.getRawType().isEquivalentTo(Table.class))
            .filter(field -> field.getModifiers().contains(JavaModifier.STATIC))
            .map(Reference::table)
            .forEach(table -> tables.merge(table.file(), table, Reference::wider));
    return tables;
  }

  private static Table<?> table(JavaField constant) {
    try {
      Field field = constant.reflect();
      field.setAccessible(true);
      return (Table<?>) field.get(null);
    } catch (IllegalAccessException e) {
      throw new IllegalStateException(e);
    }
  }

  private static Table<?> wider(Table<?> first, Table<?> second) {
    return first.columns().size() < second.columns().size() ? second : first;
  }

  private static String columns(Table<?> table) {
    return markdown(
        "column",
        "unit",
        "meaning",
        table.columns().stream()
            .map(column -> List.of(code(column.name()), column.unit(), meaning(column))));
  }

  private static String meaning(Column<?> column) {
    return column.meaning();
  }

  private static String metrics() {
    return markdown(
        "metric",
        "unit",
        "meaning",
        Arrays.stream(Metric.values())
            .map(metric -> List.of(code(metric.label()), metric.unit(), metric.meaning())));
  }

  /** Returns the help of a command and of all its subcommands, each under a heading. */
  private static Stream<String> help(int depth, List<String> command) {
    String help = Cli.run(Stream.concat(command.stream(), Stream.of("--help")).toArray()).out();
    String heading = "#".repeat(depth) + " " + String.join(" ", command) + "\n\n";
    String section = (command.isEmpty() ? "" : heading) + "```text\n" + help.strip() + "\n```\n\n";
    int commands = help.indexOf("\nCommands:\n");
    Stream<String> names =
        commands < 0
            ? Stream.of()
            : COMMAND.matcher(help.substring(commands)).results().map(name -> name.group(1));
    return Stream.concat(
        Stream.of(section),
        names
            .filter(name -> !name.equals("help"))
            .flatMap(
                name ->
                    help(
                        command.isEmpty() ? depth : depth + 1,
                        Stream.concat(command.stream(), Stream.of(name)).toList())));
  }

  /** Returns the entries that come with the program; summaries of users' parts are class names. */
  private static <T> Stream<Registry.Entry<T>> builtIn(Registry<T> registry) {
    return registry.entries().stream().filter(entry -> entry.summary().contains(" "));
  }

  private static String policies() {
    Registry<ZoomPolicy> policies = Catalogue.load().policies();
    return markdown(
        "policy",
        "option",
        "meaning",
        builtIn(policies)
            .flatMap(
                policy ->
                    Stream.concat(
                        Stream.of(List.of(code(policy.name()), "", policy.summary())),
                        policies.options(policy.name()).stream().map(Reference::option))));
  }

  private static List<String> option(Options.Declared option) {
    return List.of("", code(option.key() + "=" + option.defaultValue()), option.meaning());
  }

  private static String detections() {
    Registry<DetectionModel> models = Catalogue.load().detections();
    return markdown(
        "model",
        "threshold",
        "what it is",
        builtIn(models)
            .map(model -> detection(model.name(), model.summary(), models.create(model.name()))));
  }

  private static List<String> detection(String name, String summary, DetectionModel model) {
    String equation = model instanceof HiFiDetection hifi ? "; g(p) = " + hifi.g().equation() : "";
    String threshold = String.format(Locale.ROOT, "%.4g", model.defaultThreshold());
    return List.of(code(name), threshold, summary + equation);
  }

  private static String code(String text) {
    return "`" + text + "`";
  }

  private static String markdown(
      String first, String second, String third, Stream<List<String>> rows) {
    return Stream.concat(
            Stream.of(List.of(first, second, third), List.of("---", "---", "---")), rows)
        .map(row -> "| " + String.join(" | ", row.stream().map(Reference::cell).toList()) + " |\n")
        .reduce("", String::concat);
  }

  private static String cell(String text) {
    return text.replace("|", "\\|");
  }
}
