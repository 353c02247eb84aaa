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
 * The scenario file that CamSim was started with, as far as the bridge needs it: CamSim's cores do
 * not tell their scenario's name, nor who is to come.
 *
 * @param name the file's name without its ending
 * @param cameras names of the cameras of the start, in order
 * @param allCameras how many cameras there will ever be
 * @param allTargets how many targets there will ever be
 * @param question the attributes of its simulation: what was asked of it
 */
public record ScenarioFile(
    String name,
    List<String> cameras,
    int allCameras,
    int allTargets,
    Map<String, String> question) {
  private static final String ENDING = ".xml";
  private static final Set<String> TARGETS = Set.of("object", "object_with_waypoints");

  /** The first scenario on the JVM's command line. */
  public static Optional<ScenarioFile> onCommandLine() {
    return all().findFirst();
  }

  /**
   * The file on the JVM's command line that has these cameras.
   *
   * @param names of the cameras in the first step; empty for one whose name is not known
   */
  static Optional<ScenarioFile> with(List<String> names) {
    return all().filter(file -> file.starts(names)).findFirst();
  }

  private static Stream<ScenarioFile> all() {
    return arguments()
        .filter(argument -> argument.toLowerCase(Locale.ROOT).endsWith(ENDING))
        .flatMap(argument -> read(Path.of(argument)));
  }

  /**
   * What follows {@code java}, which not every system gives, and none where it is long; and what
   * HotSpot knows of it.
   */
  private static Stream<String> arguments() {
    return Stream.concat(
        ProcessHandle.current().info().arguments().stream().flatMap(Arrays::stream),
        Arrays.stream(System.getProperty("sun.java.command", "").split(" ")));
  }

  /** The file; nothing where it cannot be read, which is CamSim's matter. */
  static Stream<ScenarioFile> read(Path file) {
    XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    try (InputStream in = Files.newInputStream(file)) {
      String name = file.getFileName().toString();
      return Stream.of(
          read(
              name.substring(0, name.length() - ENDING.length()),
              factory.createXMLStreamReader(in)));
    } catch (IOException | XMLStreamException e) {
      return Stream.empty();
    }
  }

  private static ScenarioFile read(String name, XMLStreamReader xml) throws XMLStreamException {
    List<String> cameras = new ArrayList<>();
    int cameraEvents = 0;
    int targets = 0;
    Map<String, String> question = new HashMap<>();
    while (xml.hasNext()) {
      if (xml.next() == XMLStreamConstants.START_ELEMENT) {
        String tag = xml.getLocalName();
        for (int i = 0; tag.equals("simulation") && i < xml.getAttributeCount(); i++) {
          question.put(xml.getAttributeLocalName(i), xml.getAttributeValue(i));
        }
        if (tag.equals("camera")) {
          cameras.add(String.valueOf(xml.getAttributeValue(null, "name")));
        }
        cameraEvents += adds(xml, "camera") ? 1 : 0;
        targets += TARGETS.contains(tag) || adds(xml, "object") ? 1 : 0;
      }
    }
    return new ScenarioFile(name, cameras, cameras.size() + cameraEvents, targets, question);
  }

  private static boolean adds(XMLStreamReader xml, String participant) {
    return xml.getLocalName().equals("event")
        && participant.equals(xml.getAttributeValue(null, "participant"))
        && "add".equals(xml.getAttributeValue(null, "event"));
  }

  /** Whether a run that begins with these cameras may be one of this file. */
  boolean starts(List<String> names) {
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
