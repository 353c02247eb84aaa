package org.hificamsim.core.scenario;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.spec.EventHead;
import org.hificamsim.core.scenario.spec.EventKind;
import org.hificamsim.core.scenario.spec.ScenarioEvent;

/** The schema of scenario files, which lets an editor complete and check them. */
final class ScenarioSchema {
  private static final String HEAD =
      """
<?xml version="1.0" encoding="UTF-8"?>
<!-- Written by 'gradle scenarioFormat' from what the reader declares. -->
<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema">
  <xs:annotation>
    <xs:documentation>
      Scenario files: CamSim's format, with the zoom list of the k-coverage study and HiFi-CamSim's optional attributes.
      Lengths are in metres, time in steps. x grows to the east, y to the north; headings count clockwise from north.
      What a schema of this kind cannot say, the program checks: min below max, cameras inside the field, rising zoom radii,
      and which attributes go with which event. docs/scenario-format.md says it in full.
    </xs:documentation>
  </xs:annotation>
  <xs:element name="root" type="root">
    <xs:unique name="cameraNames">
      <xs:selector xpath="simulation/cameras/camera"/>
      <xs:field xpath="@name"/>
    </xs:unique>
    <xs:unique name="opticsNames">
      <xs:selector xpath="simulation/cameras/optics"/>
      <xs:field xpath="@name"/>
    </xs:unique>
    <xs:unique name="objectFeatures">
      <xs:selector xpath="simulation/objects/object | simulation/objects/object_with_waypoints"/>
      <xs:field xpath="@features"/>
    </xs:unique>
  </xs:element>
""";

  private static final Pattern GROUP = Pattern.compile("\\((.*)\\)([?*+]?)");
  private static final Pattern LIST = Pattern.compile("\\[(.*)](.*)");

  private final StringBuilder out = new StringBuilder(HEAD);
  private int depth = 1;

  private ScenarioSchema() {}

  /** Returns the text of the schema file. */
  static String text() {
    ScenarioSchema schema = new ScenarioSchema();
    ScenarioElements.all().forEach(schema::element);
    return schema.out.append("</xs:schema>\n").toString();
  }

  private void element(Element<?> element) {
    boolean isText = element.content().startsWith("#");
    String text = isText ? element.content().substring(1) : "";
    String kind = isText && element.attributes().isEmpty() ? "simpleType" : "complexType";
    open(kind + " name=\"" + element.name() + "\"");
    documentation(AttributeDoc.summary(element));
    if (kind.equals("simpleType")) {
      restriction(text);
    } else if (isText) {
      open("simpleContent");
      open("extension base=\"" + text + "\"");
      attributes(element);
      close("extension");
      close("simpleContent");
    } else {
      particle(element.content(), "");
      attributes(element);
    }
    close(kind);
  }

  /** Writes the content model of an element; unlike a DTD it allows any order and counts. */
  private void particle(String content, String occurs) {
    Matcher group = GROUP.matcher(content);
    if (group.matches()) {
      particle(group.group(1), occurs(group.group(2)));
    } else if (!content.isEmpty()) {
      String separator = Stream.of(" & ", " | ").filter(content::contains).findFirst().orElse(", ");
      String order = Map.of(" & ", "all", " | ", "choice", ", ", "sequence").get(separator);
      open(order + occurs);
      for (String child : content.split(Pattern.quote(separator))) {
        String name = child.replaceAll("[?*+]", "");
        String often = occurs(child.substring(name.length()));
        line("<xs:element name=\"" + name + "\" type=\"" + name + "\"" + often + "/>");
      }
      close(order);
    }
  }

  private static String occurs(String suffix) {
    return switch (suffix) {
      case "?" -> " minOccurs=\"0\"";
      case "*" -> " minOccurs=\"0\" maxOccurs=\"unbounded\"";
      case "+" -> " maxOccurs=\"unbounded\"";
      default -> "";
    };
  }

  private void attributes(Element<?> element) {
    AttributeDoc.all(element).forEach(row -> attributes(row, row.isRequired()));
    if (element == EventHead.ELEMENT) {
      eventAttributes();
    }
  }

  /** Merges attributes of one name, because kinds of events may give them different types. */
  private void eventAttributes() {
    Map<String, List<Property<?, ?>>> byName = new LinkedHashMap<>();
    Map<String, String> meanings = new LinkedHashMap<>();
    for (EventKind<?, ?> kind : ScenarioEvent.kinds()) {
      for (AttributeDoc row : AttributeDoc.all(kind.body())) {
        for (Property<?, ?> attribute : row.attributes()) {
          byName.computeIfAbsent(attribute.name(), name -> new ArrayList<>()).add(attribute);
          meanings.merge(
              attribute.name(),
              kind.participant() + " " + kind.happening() + ": " + row.meaning(),
              (first, second) -> first + ". " + second);
        }
      }
    }
    byName.forEach(
        (name, attributes) ->
            attribute(
                name,
                false,
                meanings.get(name),
                attributes.stream()
                    .map(attribute -> attribute.type().schema())
                    .distinct()
                    .collect(Collectors.joining(" | "))));
  }

  private void attributes(AttributeDoc row, boolean required) {
    String defaultText =
        required || row.defaultValue().isEmpty() ? "" : ". Default: " + row.defaultValue();
    for (Property<?, ?> attribute : row.attributes()) {
      attribute(attribute.name(), required, row.meaning() + defaultText, attribute.type().schema());
    }
  }

  private void attribute(String name, boolean required, String meaning, String schema) {
    open("attribute name=\"" + name + "\"" + (required ? " use=\"required\"" : ""));
    documentation(meaning);
    nested("simpleType", () -> type(schema));
    close("attribute");
  }

  private void type(String schema) {
    List<String> alternatives = Stream.of(schema.split(" \\| ")).distinct().toList();
    if (alternatives.size() == 1) {
      restriction(schema);
    } else {
      nested(
          "union",
          () -> alternatives.forEach(item -> nested("simpleType", () -> restriction(item))));
    }
  }

  private void restriction(String schema) {
    Matcher list = LIST.matcher(schema);
    if (list.matches()) {
      open("restriction");
      nested(
          "simpleType",
          () -> nested("list", () -> nested("simpleType", () -> restriction(list.group(1)))));
      facets(list.group(2));
    } else {
      String[] parts = schema.split(" ", 2);
      open("restriction base=\"" + parts[0] + "\"");
      facets(parts.length > 1 ? parts[1] : "");
    }
    close("restriction");
  }

  private void facets(String facets) {
    for (String facet : facets.strip().split(" ")) {
      if (!facet.isEmpty()) {
        String[] parts = facet.split("=", 2);
        line("<xs:" + parts[0] + " value=\"" + escaped(parts[1]) + "\"/>");
      }
    }
  }

  private void documentation(String markdown) {
    String text = markdown.replaceAll("\\[(.*?)]\\(.*?\\)", "$1").replaceAll("[`*]", "");
    nested(
        "annotation",
        () ->
            line(
                "<xs:documentation>"
                    + escaped(text.replace("(ours)", "(HiFi-CamSim only)"))
                    + "</xs:documentation>"));
  }

  private static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
  }

  private void nested(String name, Runnable content) {
    open(name);
    content.run();
    close(name);
  }

  private void open(String tag) {
    line("<xs:" + tag + ">");
    depth++;
  }

  private void close(String name) {
    depth--;
    line("</xs:" + name + ">");
  }

  private void line(String text) {
    out.append("  ".repeat(depth)).append(text).append('\n');
  }
}
