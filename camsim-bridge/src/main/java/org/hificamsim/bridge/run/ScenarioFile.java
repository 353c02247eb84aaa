package org.hificamsim.bridge.run;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * The parts of CamSim's scenario file that the bridge needs. CamSim's cores know neither the name
 * of their scenario nor the cameras and objects that will be added.
 *
 * @param name the name of the file without its extension
 * @param cameras the names of the cameras at the start, in order
 * @param allCameras the number of cameras, including those that events add
 * @param allTargets the number of targets, including those that events add
 * @param attributes the attributes of the simulation element
 */
public record ScenarioFile(
    String name,
    List<String> cameras,
    int allCameras,
    int allTargets,
    Map<String, String> attributes) {
  private static final String EXTENSION = ".xml";
  private static final Set<String> TARGETS = Set.of("object", "object_with_waypoints");

  /** Finds the first scenario on the command line of the JVM. */
  public static Optional<ScenarioFile> onCommandLine() {
    return all().findFirst();
  }

  /**
   * Finds the scenario on the command line of the JVM that has these cameras.
   *
   * @param names the names of the cameras in the first step; an unknown name is empty
   */
  static Optional<ScenarioFile> with(List<String> names) {
    return all().filter(file -> file.mayStartWith(names)).findFirst();
  }

  private static Stream<ScenarioFile> all() {
    return arguments()
        .filter(argument -> argument.toLowerCase(Locale.ROOT).endsWith(EXTENSION))
        .flatMap(argument -> read(Path.of(argument)));
  }

  /**
   * Returns the arguments of the JVM, from the process and from HotSpot. Some systems do not give
   * those of the process, and none gives a long command line.
   */
  private static Stream<String> arguments() {
    return Stream.concat(
        ProcessHandle.current().info().arguments().stream().flatMap(Arrays::stream),
        Arrays.stream(System.getProperty("sun.java.command", "").split(" ")));
  }

  /** Reads a file; returns an empty stream if it is not readable, which CamSim reports. */
  static Stream<ScenarioFile> read(Path file) {
    XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    try (InputStream in = Files.newInputStream(file)) {
      String name = file.getFileName().toString();
      return Stream.of(
          read(
              name.substring(0, name.length() - EXTENSION.length()),
              factory.createXMLStreamReader(in)));
    } catch (IOException | XMLStreamException e) {
      return Stream.empty();
    }
  }

  private static ScenarioFile read(String name, XMLStreamReader xml) throws XMLStreamException {
    List<String> cameras = new ArrayList<>();
    int cameraEvents = 0;
    int targets = 0;
    Map<String, String> attributes = new HashMap<>();
    while (xml.hasNext()) {
      if (xml.next() == XMLStreamConstants.START_ELEMENT) {
        String tag = xml.getLocalName();
        for (int i = 0; tag.equals("simulation") && i < xml.getAttributeCount(); i++) {
          attributes.put(xml.getAttributeLocalName(i), xml.getAttributeValue(i));
        }
        if (tag.equals("camera")) {
          cameras.add(String.valueOf(xml.getAttributeValue(null, "name")));
        }
        cameraEvents += adds(xml, "camera") ? 1 : 0;
        targets += TARGETS.contains(tag) || adds(xml, "object") ? 1 : 0;
      }
    }
    return new ScenarioFile(name, cameras, cameras.size() + cameraEvents, targets, attributes);
  }

  private static boolean adds(XMLStreamReader xml, String participant) {
    return xml.getLocalName().equals("event")
        && participant.equals(xml.getAttributeValue(null, "participant"))
        && "add".equals(xml.getAttributeValue(null, "event"));
  }

  /** Returns whether a run that begins with these cameras may be a run of this file. */
  boolean mayStartWith(List<String> names) {
    if (names.size() < cameras.size() || names.size() > allCameras) {
      return false;
    }
    for (int i = 0; i < cameras.size(); i++) {
      if (!names.get(i).isEmpty() && !names.get(i).equals(cameras.get(i))) {
        return false;
      }
    }
    return true;
  }
}
