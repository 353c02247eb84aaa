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
 * What people and editors read about scenario files, from what the reader declares: the schema, and
 * the tables of the documentation. {@code gradle scenarioFormat} writes the schema.
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

  /** A table in Markdown: of an element's attributes, of all obstacles', or of the events. */
  public static String table(String of) {
    return of.equals("events") ? events() : attributes(elements(of));
  }

  /** The element of this name, or all that it holds any number of. */
  private static List<Element<?>> elements(String name) {
    if (name.equals(Scenario.OBSTACLES_HOLDER.name())) {
      return List.copyOf(ObstacleElements.ALL);
    }
    return Scenario.elements().stream().filter(one -> one.name().equals(name)).limit(1).toList();
  }

  /** The attributes of some elements; of a single one, without its name. */
  private static String attributes(List<Element<?>> elements) {
    List<List<String>> lines = new ArrayList<>();
    lines.add(List.of("element", "attribute", "value", "default"));
    for (Element<?> element : elements) {
      for (AttributeDoc row : AttributeDoc.all(element)) {
        String name = "`" + element.name() + "`";
        lines.add(List.of(name, row.named(), row.meaning(), row.standard()));
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

  /** What the tables of cameras and objects say is not said again. */
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
