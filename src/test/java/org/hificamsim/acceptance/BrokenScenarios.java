package org.hificamsim.acceptance;

import static org.hificamsim.acceptance.BrokenScenario.change;
import static org.hificamsim.acceptance.BrokenScenario.cut;
import static org.hificamsim.acceptance.BrokenScenario.text;
import static org.hificamsim.acceptance.BrokenScenario.value;
import static org.hificamsim.acceptance.BrokenScenario.without;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Every kind of broken scenario file, each with its error line. */
final class BrokenScenarios {
  private static final String FINITE = "a finite number";
  private static final String COORDINATE = "a number from -1e9 to 1e9 (m)";
  private static final String SPEED = "a number from -1e9 to 1e9 (m a step)";
  private static final String IN_FIELD = "a number inside the field, -10.0 to 10.0";
  private static final String ANGLE = "degrees above 0 and at most 360";
  private static final String RANGE = "a number from 0 to 1e9 (m)";
  private static final String SIZE = "a number above 0 and at most 1e9 (m)";
  private static final String OR_LEAVE = ", or -1 to leave it";
  private static final String STEP = "a whole number of 0 or more";
  private static final String DURATION = "a whole number of -1 or more";
  private static final String CAMERA = "the name of a camera";
  private static final String NEW_NAME = "a camera name that is not taken";
  private static final String MOVEMENT =
      "a movement such as Straight, Waypoints, Brownian, DirectedBrownian, or one in a jar";
  private static final String XML = "not well-formed XML, expected a scenario file: ";
  private static final String DOCTYPE =
      "a document type declaration (<!DOCTYPE), expected a scenario without one";

  private static final String SIMULATION = "<simulation";
  private static final String NORTH = "<camera name=\"north\"";
  private static final String SOUTH = "<camera name=\"south\"";
  private static final String FIRST = "<object features=\"1.0\"";
  private static final String SECOND = "<object features=\"2.0\"";
  private static final String WALKER = "<object_with_waypoints";
  private static final String ADD_OBJECT = "<event timestep=\"5\"";
  private static final String ADD_CAMERA = "<event timestep=\"6\"";
  private static final String CHANGE = "<event timestep=\"7\"";
  private static final String FAIL = "<event timestep=\"8\"";
  private static final String REMOVE = "<event timestep=\"9\"";
  private static final String GRC = "<event timestep=\"10\"";
  private static final String ZOOM = "<zoom>2.0 3.5 5.0</zoom>";

  private BrokenScenarios() {}

  /**
   * @param canary a file whose content must never be seen
   */
  static List<BrokenScenario> all(Path canary) {
    return Stream.of(
            missing(),
            simulations(),
            cameras(),
            objects(),
            zooms(),
            waypoints(),
            events(),
            structure(),
            notXml(),
            entities(canary),
            encodings())
        .flatMap(List::stream)
        .toList();
  }

  private static List<BrokenScenario> missing() {
    List<BrokenScenario> all = new ArrayList<>();
    Stream.of("min_x", "max_x", "min_y", "max_y")
        .forEach(name -> all.add(without(SIMULATION, name, COORDINATE)));
    all.add(without(NORTH, "name", "a name that no other camera has"));
    all.add(without(NORTH, "x", IN_FIELD));
    all.add(without(NORTH, "y", IN_FIELD));
    all.add(without(NORTH, "heading", FINITE));
    all.add(without(NORTH, "viewing_angle", ANGLE));
    all.add(without(NORTH, "range", RANGE));
    Stream.of("features", "heading").forEach(name -> all.add(without(FIRST, name, FINITE)));
    all.add(without(WALKER, "features", FINITE));
    Stream.of("x", "y")
        .forEach(
            name -> {
              all.add(without(FIRST, name, COORDINATE));
              all.add(without("<waypoint x=\"4\" y=\"4\"", name, COORDINATE));
              all.add(without(ADD_OBJECT, name, COORDINATE));
            });
    Stream.of(FIRST, WALKER, ADD_OBJECT).forEach(tag -> all.add(without(tag, "speed", SPEED)));
    all.add(without(ADD_OBJECT, "timestep", STEP));
    all.add(without(ADD_OBJECT, "participant", "camera, object or grc"));
    all.add(without(ADD_OBJECT, "event", "add, change or error"));
    Stream.of("name", "heading").forEach(name -> all.add(without(ADD_OBJECT, name, FINITE)));
    all.add(without(ADD_CAMERA, "name", "a name that no other camera has"));
    all.add(without(ADD_CAMERA, "range", RANGE));
    all.add(without(CHANGE, "name", CAMERA));
    all.add(without(CHANGE, "x", IN_FIELD + OR_LEAVE));
    all.add(without(CHANGE, "heading", FINITE));
    all.add(without(CHANGE, "viewing_angle", ANGLE + OR_LEAVE));
    all.add(without(CHANGE, "range", RANGE + OR_LEAVE));
    all.add(without(FAIL, "name", CAMERA));
    all.add(without(FAIL, "duration", DURATION));
    all.add(without(REMOVE, "name", FINITE));
    all.add(without(GRC, "duration", DURATION));
    all.add(without("<graphnode", "name", CAMERA));
    all.add(without("<neighbour", "name", CAMERA));
    return all;
  }

  private static List<BrokenScenario> simulations() {
    List<BrokenScenario> all = new ArrayList<>();
    for (String rubbish :
        List.of(
            "", " ", "ten", "NaN", "-Infinity", "1e999", "0x1F", "1,5", "--1", "1 2", "\u0661")) {
      all.add(value(SIMULATION, "min_x", rubbish, COORDINATE));
    }
    all.add(value(SIMULATION, "max_x", "-10", "more than min_x, -10.0"));
    all.add(value(SIMULATION, "max_y", "-11.5", "more than min_y, -10.0"));
    all.add(value(SIMULATION, "min_x", "-1e308", COORDINATE));
    all.add(value(SIMULATION, "max_y", "1.1e9", COORDINATE));
    all.add(value(SIMULATION, "order", "Coverage", "one of coverage, camsim"));
    all.add(value(SIMULATION, "headings", "radians", "one of degrees, as-radians"));
    for (String rubbish : List.of("-0.1", "1.5", "NaN", "high")) {
      all.add(value(SIMULATION, "threshold", rubbish, "a number from 0 to 1"));
    }
    for (String rubbish : List.of("0", "-3", "Infinity", "1e10")) {
      all.add(value(SIMULATION, "mount_height", rubbish, SIZE));
    }
    return all;
  }

  private static List<BrokenScenario> cameras() {
    return List.of(
        value(SOUTH, "name", "north", NEW_NAME),
        value(NORTH, "x", "10.5", IN_FIELD),
        value(NORTH, "x", "NaN", IN_FIELD),
        value(NORTH, "y", "-10.001", IN_FIELD),
        value(NORTH, "y", "Infinity", IN_FIELD),
        value(NORTH, "heading", "north", FINITE),
        value(NORTH, "heading", "NaN", FINITE),
        value(NORTH, "viewing_angle", "0", ANGLE),
        value(NORTH, "viewing_angle", "361", ANGLE),
        value(NORTH, "viewing_angle", "-90", ANGLE),
        value(NORTH, "viewing_angle", "NaN", ANGLE),
        value(NORTH, "range", "-1", RANGE),
        value(NORTH, "range", "1e200", RANGE),
        value(NORTH, "range", "NaN", RANGE),
        value(NORTH, "range", "far", RANGE),
        value(NORTH, "comm", "5", "a whole number from 0 to 4"),
        value(NORTH, "comm", "Broadcast", "a whole number from 0 to 4"),
        value(SOUTH, "limit", "-1", STEP),
        value(SOUTH, "limit", "1.5", STEP));
  }

  private static List<BrokenScenario> objects() {
    String other = "features that no other object has";
    return List.of(
        value(SECOND, "features", "1.0", other),
        value(SECOND, "features", "1", other),
        value(WALKER, "features", "2.0", other),
        value(FIRST, "features", "one", FINITE),
        value(FIRST, "features", "NaN", FINITE),
        value(FIRST, "x", "1e999", COORDINATE),
        value(FIRST, "x", "-1e10", COORDINATE),
        value(FIRST, "y", "", COORDINATE),
        value(FIRST, "heading", "NaN", FINITE),
        value(FIRST, "speed", "Infinity", SPEED),
        value(FIRST, "speed", "1e300", SPEED),
        value(FIRST, "size", "0", SIZE),
        value(FIRST, "size", "2e9", SIZE),
        value(FIRST, "size", "-0.5", SIZE),
        value(FIRST, "size", "NaN", SIZE),
        value(WALKER, "size", "0", SIZE),
        value(FIRST, "mean", "NaN", COORDINATE),
        value(FIRST, "mean", "2e9", COORDINATE),
        value(FIRST, "std", "-1", RANGE),
        value(FIRST, "std", "2e9", RANGE),
        value(SECOND, "move", "epics.movement.Teleport", MOVEMENT),
        value(SECOND, "move", "waypoints", MOVEMENT),
        value(SECOND, "move", "Straight:speed=2", MOVEMENT));
  }

  private static List<BrokenScenario> zooms() {
    String many =
        IntStream.range(1, 1002).mapToObj(String::valueOf).collect(Collectors.joining(" "));
    return List.of(
        zoom("", ""),
        zoom(" \n ", ""),
        zoom("<!-- 2.5 -->", ""),
        zoom("2.0 5.0 3.5", "2.0 5.0 3.5"),
        zoom("2.0 3.5 3.50", "2.0 3.5 3.50"),
        zoom("-2.0 3.5", "-2.0 3.5"),
        zoom("0 3.5", "0 3.5"),
        zoom("2.0 NaN", "2.0 NaN"),
        zoom("2.0 2e9", "2.0 2e9"),
        zoom("2.0 Infinity", "2.0 Infinity"),
        zoom("2.0,3.5,5.0", "2.0,3.5,5.0"),
        zoom("9".repeat(999), "9".repeat(60) + "..."),
        zoom(many, many.substring(0, 60) + "..."),
        change(
            "two zoom lists",
            ZOOM,
            ZOOM + "\n      @<zoom>1 2</zoom>",
            "a second <zoom>, expected one for all cameras"));
  }

  private static BrokenScenario zoom(String text, String shown) {
    String name = "zoom list " + text.substring(0, Math.min(20, text.length()));
    String expected = "rising radii above 0 and at most 1e9 (m), between spaces, 1 to 1000";
    String message = "<zoom> is '" + shown + "', expected " + expected;
    return change(name, ZOOM, "@<zoom>" + text + "</zoom>", message);
  }

  private static List<BrokenScenario> waypoints() {
    String one = "one <waypoint>, expected none or at least two";
    return List.of(
        change(
            "a path of one waypoint",
            "<waypoint x=\"2\" y=\"2\"/>\n        <waypoint",
            "@<waypoint",
            one),
        change(
            "a walker with one waypoint",
            "<waypoint x=\"4\" y=\"4\"/>\n        <waypoint",
            "@<waypoint",
            one),
        change(
            "an event with one waypoint",
            "<waypoint x=\"6\" y=\"6\"/>\n        <waypoint",
            "@<waypoint",
            one),
        change(
            "an object with Tracks",
            FIRST,
            "<object @move=\"Tracks\" features=\"1.0\"",
            "<object> move is 'Tracks', expected " + MOVEMENT),
        change(
            "Waypoints without any",
            FIRST,
            "@<object move=\"epics.movement.Waypoints\" features=\"1.0\"",
            "movement Waypoints without <waypoint>, expected at least two of them"),
        change(
            "Scripted without any",
            FIRST,
            "@<object move=\"Scripted\" features=\"1.0\"",
            "movement Scripted without <waypoint>, expected at least two of them"),
        change(
            "an event with Waypoints without any",
            REMOVE,
            "@<event timestep=\"1\" participant=\"object\" event=\"add\" name=\"8\" x=\"0\" y=\"0\""
                + " heading=\"0\" speed=\"1\" fqName=\"epics.movement.Waypoints\"/>"
                + REMOVE,
            "movement Waypoints without <waypoint>, expected at least two of them"),
        text(
            "a walker without waypoints",
            BrokenScenario.SOUND
                .replace("<waypoint x=\"4\" y=\"4\"/>", "")
                .replace("<waypoint x=\"5\" y=\"5\"/>", "")
                .replace(WALKER, "@" + WALKER),
            "no <waypoint>, expected at least two"),
        value("<waypoint x=\"2\"", "x", "NaN", COORDINATE),
        value("<waypoint x=\"2\"", "x", "1e308", COORDINATE),
        value("<waypoint x=\"6\"", "y", "six", COORDINATE));
  }

  private static List<BrokenScenario> events() {
    return List.of(
        value(ADD_OBJECT, "timestep", "-1", STEP),
        value(ADD_OBJECT, "timestep", "1.5", STEP),
        value(ADD_OBJECT, "timestep", "2147483648", STEP),
        value(ADD_OBJECT, "timestep", "NaN", STEP),
        value(ADD_OBJECT, "participant", "robot", "camera, object or grc"),
        value(ADD_OBJECT, "event", "change", "add or error"),
        value(ADD_CAMERA, "event", "explode", "add, change or error"),
        value(GRC, "event", "add", "error"),
        value(ADD_OBJECT, "name", "1.0", "features that no object present has"),
        value(ADD_OBJECT, "name", "four", FINITE),
        value(ADD_OBJECT, "size", "-1", SIZE),
        value(ADD_OBJECT, "x", "1e308", COORDINATE),
        value(ADD_OBJECT, "speed", "-1e300", SPEED),
        value(REMOVE, "name", "4.0;5.0", FINITE),
        value(ADD_CAMERA, "name", "north", NEW_NAME),
        value(ADD_CAMERA, "x", "-11", IN_FIELD),
        value(ADD_CAMERA, "viewing_angle", "400", ANGLE),
        value(CHANGE, "name", "nobody", CAMERA),
        value(CHANGE, "x", "11", IN_FIELD + OR_LEAVE),
        value(CHANGE, "y", "NaN", IN_FIELD + OR_LEAVE),
        value(CHANGE, "viewing_angle", "0", ANGLE + OR_LEAVE),
        value(CHANGE, "range", "-2", RANGE + OR_LEAVE),
        value(CHANGE, "range", "1e200", RANGE + OR_LEAVE),
        value(FAIL, "name", "", CAMERA),
        value(FAIL, "duration", "-2", DURATION),
        value(FAIL, "duration", "long", DURATION),
        value(GRC, "duration", "1e3", DURATION),
        change(
            "an event with an unknown movement",
            "speed=\"1\" size=\"1\">",
            "speed=\"1\" @fqName=\"Teleport\">",
            "<event> fqName is 'Teleport', expected " + MOVEMENT),
        change(
            "an event with Tracks",
            "speed=\"1\" size=\"1\">",
            "speed=\"1\" @fqName=\"Tracks\">",
            "<event> fqName is 'Tracks', expected " + MOVEMENT));
  }

  private static List<BrokenScenario> structure() {
    String sound = BrokenScenario.SOUND;
    return List.of(
        text(
            "another root",
            sound.replace("<root>", "@<scenario>").replace("</root>", "</scenario>"),
            "the root element is <scenario>, expected <root>"),
        text(
            "an SVG picture",
            "@<svg xmlns=\"http://www.w3.org/2000/svg\"><circle r=\"1\"/></svg>",
            "the root element is <svg>, expected <root>"),
        text(
            "a root alone",
            "<!-- nothing -->\n@<root/>",
            "no <simulation>, expected one with min_x, max_x, min_y, max_y"),
        change(
            "two simulations",
            "</root>",
            "@<simulation min_x=\"0\" max_x=\"1\" min_y=\"0\" max_y=\"1\"/></root>",
            "a second <simulation>, expected one"));
  }

  private static List<BrokenScenario> notXml() {
    String sound = BrokenScenario.SOUND;
    return List.of(
        text("an empty file", "@", XML + "Premature end of file."),
        text("spaces alone", "  \n  @", XML + "Premature end of file."),
        text("words", "@min_x = 0", XML + "Content is not allowed in prolog."),
        text("JSON", "@{\"root\": {}}", XML + "Content is not allowed in prolog."),
        cut("cut within a tag", " heading=\"180\"", inside("cameras")),
        cut("cut within a value", "epics.movement", inside("objects")),
        cut("cut within a name", "ulation min_x", inside("root")),
        cut("cut between elements", "<objects>", inside("simulation")),
        cut("cut within the zoom list", "3.5 5.0", inside("zoom")),
        cut("cut before the end", "\n</root>", inside("root")),
        change(
            "a quote left open",
            "y=\"5\" heading",
            "y=\"5 heading=\"@180\"",
            XML
                + "Element type \"camera\" must be followed by either attribute specifications,"
                + " \">\" or \"/>\"."),
        change(
            "a value without quotes",
            "y=\"-5\"",
            "y=@-5",
            XML
                + "Open quote is expected for attribute \"y\" associated with an element type"
                + " \"camera\"."),
        change(
            "an attribute without a value",
            "y=\"-5\"",
            "y @heading2=\"1\"",
            XML
                + "Attribute name \"y\" associated with an element type \"camera\" must be followed"
                + " by the ' = ' character."),
        change(
            "no space between attributes",
            "y=\"-5\" h",
            "y=\"-5\"@h",
            XML
                + "Element type \"camera\" must be followed by either attribute specifications,"
                + " \">\" or \"/>\"."),
        change(
            "an attribute twice",
            "y=\"-5\"",
            "y=\"-5\" y=\"-6\"@",
            XML + "Attribute \"y\" was already specified for element \"camera\"."),
        change(
            "a tag in a value",
            "y=\"-5\"",
            "y=\"@<\"",
            XML
                + "The value of attribute \"y\" associated with an element type \"camera\" must not"
                + " contain the '<' character."),
        change(
            "another end tag",
            "</cameras>",
            "</@camera>",
            XML
                + "The element type \"cameras\" must be terminated by the matching end-tag"
                + " \"</cameras>\"."),
        change(
            "an end too many",
            "</events>",
            "</events></@events>",
            XML
                + "The element type \"simulation\" must be terminated by the matching end-tag"
                + " \"</simulation>\"."),
        change(
            "an ampersand alone",
            "north\" x",
            "n &@ s\" x",
            XML + "The entity name must immediately follow the '&' in the entity reference."),
        change(
            "a comment with dashes",
            "<cameras>",
            "<cameras><!-- a --@ b -->",
            XML + "The string \"--\" is not permitted within comments."),
        change(
            "a control character",
            "5.0</zoom>",
            "5.0@\u0001</zoom>",
            XML
                + "An invalid XML character (Unicode: 0x1) was found in the element content of the"
                + " document."),
        change(
            "a NUL character",
            "5.0</zoom>",
            "5.0@\0</zoom>",
            XML
                + "An invalid XML character (Unicode: 0x0) was found in the element content of the"
                + " document."),
        change(
            "a NUL character in a value",
            "north\" x",
            "no@\0rth\" x",
            XML
                + "An invalid XML character (Unicode: 0x0) was found in the value of attribute"
                + " \"name\" and element is \"camera\"."),
        change(
            "a reference to NUL",
            "5.0</zoom>",
            "5.0&#0;@</zoom>",
            XML + "Character reference \"&#0\" is an invalid XML character."),
        text(
            "two roots",
            sound + "<@root/>",
            XML + "The markup in the document following the root element must be well-formed."),
        text(
            "words after the end",
            sound + "@the end",
            XML + "Content is not allowed in trailing section."),
        text(
            "a declaration in the second line",
            "\n<?xml@ version='1.0'?><root/>",
            XML + "The processing instruction target matching \"[xX][mM][lL]\" is not allowed."),
        text(
            "XML of another time",
            "<?xml version='3.0'@?><root/>",
            XML + "XML version \"3.0\" is not supported, only XML 1.0 is supported."),
        text(
            "nested too deep",
            "<root>".repeat(32) + "@<root>",
            "<root> is nested too deep, expected at most 32 levels"));
  }

  private static String inside(String name) {
    return "the file ends inside <%s>, expected </%s>".formatted(name, name);
  }

  private static List<BrokenScenario> entities(Path canary) {
    String rest = BrokenScenario.SOUND.substring(BrokenScenario.SOUND.indexOf("<root>"));
    String used = rest.replace("3.5 5.0", "3.5 &e; 5.0");
    String laughs =
        "<!ENTITY e0 \"ha\">"
            + IntStream.range(1, 40)
                .mapToObj(i -> "<!ENTITY e%s \"&e%s;&e%s;\">".formatted(i, i - 1, i - 1))
                .collect(Collectors.joining("\n"));
    String uri = canary.toUri().toString();
    return List.of(
        text("a document type", "@<!DOCTYPE root>\n" + rest, DOCTYPE),
        text("an outside document type", "@<!DOCTYPE root SYSTEM '" + uri + "'>\n" + rest, DOCTYPE),
        text("a public one", "\n@<!DOCTYPE root PUBLIC '-//x' '" + uri + "'>\n" + rest, DOCTYPE),
        text("an inner entity", "@<!DOCTYPE root [<!ENTITY e '4'>]>\n" + used, DOCTYPE),
        text(
            "an outside entity",
            "@<!DOCTYPE root [<!ENTITY e SYSTEM '" + uri + "'>]>\n" + used,
            DOCTYPE),
        text(
            "a parameter entity",
            "@<!DOCTYPE root [<!ENTITY % p SYSTEM '" + uri + "'> %p;]>\n" + rest,
            DOCTYPE),
        text(
            "billion laughs",
            "@<!DOCTYPE root [" + laughs + "]>\n" + used.replace("&e;", "&e39;"),
            DOCTYPE),
        change(
            "an unknown entity",
            "3.5 5.0",
            "3.5 &e;@ 5.0",
            XML + "The entity \"e\" was referenced, but not declared."),
        change(
            "an unknown entity in a value",
            "north\" x",
            "&north;@\" x",
            XML + "The entity \"north\" was referenced, but not declared."));
  }

  private static List<BrokenScenario> encodings() {
    String sound = BrokenScenario.SOUND;
    String umlaut = sound.replace(NORTH, "<camera name=\"n@\u00f6rth\"");
    return List.of(
        text(
            "Latin-1 that claims to be UTF-8",
            umlaut,
            StandardCharsets.ISO_8859_1,
            "byte 0xF6 is not UTF-8, expected text in that encoding"),
        text(
            "ASCII with an umlaut",
            umlaut.replace("UTF-8", "US-ASCII"),
            "byte 0xC3 is not US-ASCII, expected text in that encoding"),
        text(
            "Latin-1 that claims nothing",
            umlaut.substring(umlaut.indexOf("<root>")),
            StandardCharsets.ISO_8859_1,
            "byte 0xF6 is not UTF-8, expected text in that encoding"),
        encoding("UTF-9", "encoding=\"UTF-9\"?>@", "The encoding \"UTF-9\" is not known."),
        encoding("no such?", "encoding=\"no such?\"?>@", "Invalid encoding name \"no such?\"."),
        encoding("", "encoding=\"\"?>@", "Invalid encoding name \"\"."),
        new BrokenScenario(
            "UTF-8 that claims to be UTF-16",
            "<?xml version=\"1.0\" encoding=\"UTF-16\"?><r/>\n".getBytes(StandardCharsets.UTF_8),
            1,
            40,
            XML + "Content is not allowed in prolog."),
        new BrokenScenario(
            "a picture", picture(), 1, 1, "byte 0x89 is not UTF-8, expected text in that encoding"),
        new BrokenScenario(
            "zeros", new byte[1000], 1, 1, XML + "Content is not allowed in prolog."));
  }

  private static BrokenScenario encoding(String declared, String marked, String message) {
    return text(
        "declared as " + declared,
        BrokenScenario.SOUND.replace("encoding=\"UTF-8\"?>", marked),
        XML + message);
  }

  private static byte[] picture() {
    return new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0, 0, 0, 13};
  }
}
