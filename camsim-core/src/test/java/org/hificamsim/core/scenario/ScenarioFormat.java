package org.hificamsim.core.scenario;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.spec.EventKind;
import org.hificamsim.core.scenario.spec.ObstacleElements;
import org.hificamsim.core.scenario.spec.ScenarioEvent;

/**
 * Generates the schema of scenario files, and the tables of the documentation, from the
 * declarations of the reader. {@code gradle scenarioFormat} writes the schema.
 */
public final class ScenarioFormat {
  private ScenarioFormat() {}

  /** Writes the schema; the argument is the folder of the whole project. */
  public static void main(String[] args) throws IOException {
    Files.writeString(schema(Path.of(args[0])), ScenarioSchema.text());
  }

  static Path schema(Path project) {
    return project.resolve("scenarios/camsim.xsd");
  }

  /**
   * Returns a table in Markdown: the attributes of an element or of all obstacles, or the events.
   */
  public static String table(String name) {
    return name.equals("events") ? events() : attributes(elements(name));
  }

  /** Returns the element of this name, or all kinds of obstacles for their holder. */
  private static List<Element<?>> elements(String name) {
    if (name.equals(ScenarioElements.OBSTACLES_HOLDER.name())) {
      return List.copyOf(ObstacleElements.ALL);
    }
    return ScenarioElements.all().stream()
        .filter(element -> element.name().equals(name))
        .limit(1)
        .toList();
  }

  /** Returns the attributes of elements; the column of names is omitted for a single element. */
  private static String attributes(List<Element<?>> elements) {
    List<List<String>> lines = new ArrayList<>();
    lines.add(List.of("element", "attribute", "value", "default"));
    for (Element<?> element : elements) {
      for (AttributeDoc row : AttributeDoc.all(element)) {
        String name = "`" + element.name() + "`";
        lines.add(List.of(name, row.named(), row.meaning(), row.defaultValue()));
      }
    }
    int first = elements.size() > 1 ? 0 : 1;
    return markdown(lines.stream().map(row -> row.subList(first, 4)).toList());
  }

  private static String events() {
    List<List<String>> lines = new ArrayList<>();
    lines.add(List.of("`participant`", "`event`", "other attributes", "what happens"));
    for (EventKind<?, ?> kind : ScenarioEvent.kinds()) {
      lines.add(
          List.of(
              "`" + kind.participant() + "`",
              "`" + kind.happening() + "`",
              attributes(kind.body()),
              AttributeDoc.summary(kind.body())));
    }
    return markdown(lines);
  }

  /** Lists attributes without the meanings that the tables of cameras and objects already give. */
  private static String attributes(Element<?> body) {
    List<AttributeDoc> effective =
        AttributeDoc.all(body).stream().filter(AttributeDoc::hasEffect).toList();
    return Stream.of(true, false)
        .map(
            required ->
                effective.stream()
                    .filter(row -> row.isRequired() == required)
                    .map(
                        row ->
                            row.named()
                                + (body.type().isRecord() ? " (" + row.meaning() + ")" : ""))
                    .collect(Collectors.joining(", ")))
        .filter(names -> !names.isEmpty())
        .collect(Collectors.joining("; optional "));
  }

  private static String markdown(List<List<String>> lines) {
    List<String> table = new ArrayList<>();
    lines.forEach(line -> table.add("| " + String.join(" | ", line) + " |\n"));
    table.add(1, "|---".repeat(lines.get(0).size()) + "|\n");
    return String.join("", table);
  }
}
