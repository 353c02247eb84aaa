package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.xml.XMLConstants;
import javax.xml.transform.Source;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;
import javax.xml.validation.Validator;
import org.hificamsim.core.Reference;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.xml.sax.SAXException;

/** Tests that {@code scenarios/camsim.xsd} accepts all scenarios and rejects broken ones. */
class ScenarioSchemaTest {
  private static final Path ROOT = Path.of(System.getProperty("hificamsim.root"));

  /** A small valid scenario that contains every text that {@link #rejectsBrokenSnippets} breaks. */
  private static final String VALID =
      """
<root>
  <simulation min_x="-10" max_x="10" min_y="-5" max_y="5" order="coverage" threshold="0.5"
      step="0.5" occlusion="targets" objective="covered:k=2">
    <obstacles>
      <wall x1="-1" y1="4" x2="1" y2="4"/>
      <polygon points="5,1 6,1 6,2" transmittance="0.5"/>
      <pillar x="8" y="0" radius="0.3"/>
    </obstacles>
    <cameras>
      <optics name="ptz" law="pinhole" pixels="1920" hfov="60 30" pan="-60:60:30" moving="sees"/>
      <zoom>2.5 5.0</zoom>
      <camera name="A" x="0" y="0" heading="90" viewing_angle="360" range="5" comm="0"/>
      <camera name="B" x="1" y="0" heading="90" viewing_angle="70" range="0"/>
      <camera name="C" x="1" y="2" heading="90" optics="ptz"/>
    </cameras>
    <objects>
      <object features="1.0" x="0" y="1" heading="0" speed="1" size="0.66"/>
      <object features="2.0" x="0" y="1" heading="0" speed="1"/>
      <object features="3.0" x="0" y="1" heading="0" speed="1" width="0.5" height="1.75"/>
      <tracks file="a.tracks"/>
    </objects>
    <events>
      <event timestep="0" participant="object" event="error" name="1.0"/>
      <event timestep="9" participant="camera" event="error" name="A" duration="-1"/>
    </events>
    <visiongraph static="false"><graphnode name="A"><neighbour name="B"/></graphnode></visiongraph>
  </simulation>
</root>
""";

  private static Schema schema;

  @BeforeAll
  static void readSchema() throws SAXException {
    SchemaFactory factory = SchemaFactory.newInstance(XMLConstants.W3C_XML_SCHEMA_NS_URI);
    schema = factory.newSchema(ROOT.resolve("scenarios/camsim.xsd").toFile());
  }

  @TestFactory
  Stream<DynamicTest> acceptsOwnScenarios() throws IOException {
    return acceptsAll(
        ROOT.resolve("scenarios"), Reference.file("own-camsim"), Reference.file("own-coverage"));
  }

  @TestFactory
  Stream<DynamicTest> acceptsPublishedScenarios() throws IOException {
    return acceptsAll(Reference.file("camsim/scenarios"), Reference.file("coverage-study"));
  }

  @Test
  void acceptsValidSnippet() {
    assertDoesNotThrow(() -> validate(new StreamSource(new StringReader(VALID))));
  }

  @ParameterizedTest(name = "{0} -> {1}")
  @CsvSource(
      delimiter = '|',
      value = {
        "min_x=\"-10\"              | ",
        "min_x=\"-10\"              | min_x=\"NaN\"",
        "max_x=\"10\"               | max_x=\"INF\"",
        "max_x=\"10\"               | max_x=\"1e999\"",
        "max_y=\"5\"                | max_y=\"five\"",
        "max_y=\"5\"                | max_y=\"2e9\"",
        "order=\"coverage\"         | order=\"random\"",
        "threshold=\"0.5\"          | threshold=\"1.5\"",
        "threshold=\"0.5\"          | treshold=\"0.5\"",
        "2.5 5.0                    | 2.5 0 5.0",
        "2.5 5.0                    | 2.5,5.0",
        "2.5 5.0                    | 2.5 2e9",
        "2.5 5.0                    | ",
        "name=\"B\" x=\"1\"         | name=\"A\" x=\"1\"",
        "viewing_angle=\"360\"      | viewing_angle=\"361\"",
        "viewing_angle=\"360\"      | viewing_angle=\"0\"",
        "range=\"5\"                | range=\"-1\"",
        "comm=\"0\"                 | comm=\"5\"",
        "features=\"2.0\"           | features=\"1\"",
        "features=\"2.0\"           | ",
        "speed=\"1\"                | speed=\"-1\"",
        "speed=\"1\"                | speed=\"1e300\"",
        "x=\"0\" y=\"1\"            | x=\"0\" y=\"1e308\"",
        "size=\"0.66\"              | size=\"0\"",
        "timestep=\"0\"             | timestep=\"0.5\"",
        "timestep=\"0\"             | timestep=\"-1\"",
        "participant=\"object\"     | participant=\"person\"",
        "event=\"error\" name=\"1.0\"| event=\"leave\" name=\"1.0\"",
        "duration=\"-1\"            | duration=\"-2\"",
        "step=\"0.5\"               | step=\"0\"",
        "occlusion=\"targets\"      | occlusion=\"walls\"",
        "y2=\"4\"                   | ",
        "5,1 6,1 6,2                | 5,1 6,1",
        "5,1 6,1 6,2                | 5 1 6 1 6 2",
        "transmittance=\"0.5\"      | transmittance=\"2\"",
        "radius=\"0.3\"             | radius=\"0\"",
        "law=\"pinhole\"            | law=\"pin-hole\"",
        "pixels=\"1920\"            | pixels=\"0\"",
        "hfov=\"60 30\"             | hfov=\"60,30\"",
        "-60:60:30                  | -60:60",
        "moving=\"sees\"            | moving=\"yes\"",
        "height=\"1.75\"            | height=\"0\"",
        "static=\"false\"           | static=\"perhaps\"",
        "<objects>                  | <objects><tracks files=\"a.tracks\"/>",
        "<events>                   | <events><waypoint x=\"0\" y=\"0\"/>",
        "name=\"1.0\"/>             | name=\"1.0\"><waypoint x=\"0\" y=\"0\"/></event>",
        "<objects>                  | <objects><person/>",
        "<root>                     | <root><simulation/>",
      })
  void rejectsBrokenSnippets(String part, String broken) {
    String text = VALID.replace(part, broken == null ? "" : broken);
    assertTrue(!text.equals(VALID), "the snippet has no such part");
    assertThrows(
        SAXException.class, () -> validate(new StreamSource(new StringReader(text))), text);
  }

  private static Stream<DynamicTest> acceptsAll(Path... folders) throws IOException {
    List<Path> scenarios = new ArrayList<>();
    for (Path folder : folders) {
      try (Stream<Path> files = Files.walk(folder)) {
        files.filter(file -> file.toString().endsWith(".xml")).forEach(scenarios::add);
      }
    }
    assertTrue(scenarios.size() > 20, "" + scenarios);
    return scenarios.stream().sorted().map(ScenarioSchemaTest::accepts);
  }

  private static DynamicTest accepts(Path file) {
    return DynamicTest.dynamicTest(
        file.getParent().getFileName() + "/" + file.getFileName(),
        () -> assertDoesNotThrow(() -> validate(new StreamSource(file.toFile()))));
  }

  private static void validate(Source scenario) throws SAXException, IOException {
    Validator validator = schema.newValidator();
    validator.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
    validator.setProperty(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
    validator.validate(scenario);
  }
}
