package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;

/**
 * A scenario file with one fault, and the expected error.
 *
 * @param name a description of the fault
 * @param line the line of the fault, from 1
 * @param column the column of the fault, from 1
 * @param message the error message after the place
 */
record BrokenScenario(String name, byte[] content, int line, int column, String message) {
  /** The mark of the place that the error must name, which is removed from the file. */
  private static final char MARK = '@';

  /** A valid scenario. */
  static final String SOUND =
      """
<?xml version="1.0" encoding="UTF-8"?>
<root>
  <simulation min_x="-10" max_x="10" min_y="-10" max_y="10" order="coverage"
      headings="degrees" threshold="0.3" mount_height="3">
    <cameras>
      <zoom>2.0 3.5 5.0</zoom>
      <camera name="north" x="0" y="5" heading="180" viewing_angle="90" range="5" comm="0"/>
      <camera name="south" x="0" y="-5" heading="0" viewing_angle="360" range="7" limit="2"/>
    </cameras>
    <objects>
      <object features="1.0" x="1" y="1" heading="30" speed="1" size="0.66" mean="0" std="1"/>
      <object features="2.0" x="2" y="2" heading="6" speed="1" move="epics.movement.Waypoints">
        <waypoint x="2" y="2"/>
        <waypoint x="3" y="3"/>
      </object>
      <object_with_waypoints features="3.0" speed="1" size="0.5">
        <waypoint x="4" y="4"/>
        <waypoint x="5" y="5"/>
      </object_with_waypoints>
    </objects>
    <events>
      <event timestep="5" participant="object" event="add" name="4.0" x="1" y="1"
          heading="0" speed="1" size="1">
        <waypoint x="6" y="6"/>
        <waypoint x="7" y="7"/>
      </event>
      <event timestep="6" participant="camera" event="add" name="late" x="1" y="1"
          heading="0" viewing_angle="90" range="5"/>
      <event timestep="7" participant="camera" event="change" name="late" x="2" y="-1"
          heading="-1" viewing_angle="-1" range="30"/>
      <event timestep="8" participant="camera" event="error" name="late" duration="-1"/>
      <event timestep="9" participant="object" event="error" name="4.0"/>
      <event timestep="10" participant="grc" event="error" name="g" duration="5"/>
    </events>
    <visiongraph static="false">
      <graphnode name="north">
        <neighbour name="south"/>
      </graphnode>
    </visiongraph>
  </simulation>
</root>
""";

  /** Returns a file of this text, which has a mark before the place of the fault. */
  static BrokenScenario text(String name, String marked, String message) {
    return text(name, marked, StandardCharsets.UTF_8, message);
  }

  /** Returns a file of this text in another encoding. */
  static BrokenScenario text(String name, String marked, Charset charset, String message) {
    int at = marked.indexOf(MARK);
    assertTrue(at >= 0 && at == marked.lastIndexOf(MARK), name + ": one mark");
    String before = marked.substring(0, at);
    int line = 1 + (int) before.chars().filter(c -> c == '\n').count();
    int column = at - before.lastIndexOf('\n');
    String text = before + marked.substring(at + 1);
    return new BrokenScenario(name, text.getBytes(charset), line, column, message);
  }

  /** Returns the valid scenario with a part replaced; the replacement contains the mark. */
  static BrokenScenario change(String name, String from, String to, String message) {
    return text(name, SOUND.replace(only(from), to), message);
  }

  /** Returns the valid scenario, cut off before this part, where the error must be. */
  static BrokenScenario cut(String name, String before, String message) {
    return text(name, SOUND.substring(0, SOUND.indexOf(only(before))) + MARK, message);
  }

  /** Returns the valid scenario without an attribute of the tag with this beginning. */
  static BrokenScenario without(String tag, String attribute, String expected) {
    String whole = tag(tag);
    String less = whole.replaceFirst("\\s" + attribute + "=\"[^\"]*\"", "");
    assertTrue(less.length() < whole.length(), tag + " without " + attribute);
    return change(
        tag + " without " + attribute,
        whole,
        MARK + less,
        "<%s> has no %s, expected %s".formatted(name(tag), attribute, expected));
  }

  /**
   * Returns the valid scenario with another value of an attribute of the tag with this beginning.
   */
  static BrokenScenario value(String tag, String attribute, String value, String expected) {
    String whole = tag(tag);
    String changed =
        whole.replaceFirst(
            "(\\s)" + attribute + "=\"[^\"]*\"", "$1" + MARK + attribute + "=\"" + value + "\"");
    assertTrue(changed.indexOf(MARK) > 0, tag + " with " + attribute);
    return change(
        "%s with %s=\"%s\"".formatted(tag, attribute, value),
        whole,
        changed,
        "<%s> %s is '%s', expected %s".formatted(name(tag), attribute, value, expected));
  }

  private static String tag(String start) {
    int at = SOUND.indexOf(only(start));
    return SOUND.substring(at, SOUND.indexOf('>', at) + 1);
  }

  private static String name(String tag) {
    return tag.substring(1).split("\\s")[0];
  }

  private static String only(String part) {
    assertEquals(SOUND.indexOf(part), SOUND.lastIndexOf(part), "more than once: " + part);
    assertTrue(SOUND.contains(part), "not there: " + part);
    return part;
  }

  @Override
  public String toString() {
    return name;
  }
}
