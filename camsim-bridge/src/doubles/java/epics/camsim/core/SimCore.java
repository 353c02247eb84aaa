package epics.camsim.core;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.w3c.dom.Element;
import org.xml.sax.SAXException;

/** Holds the simulated world, and makes its steps. */
public class SimCore {
  private static final String HEADER =
      "time;utility;communication;visible;strategy;totUtil;totComm;overlap;confidence;proportion";

  private static final String LOOKS_HEADER =
      "time,camera,object,range,x,y,returned,kept,heading,angle";

  private final ArrayList<CameraController> cameras = new ArrayList<>();
  private final ArrayList<TraceableObject> objects = new ArrayList<>();
  private final List<Attributes> events;
  private final Random turns;
  private final Path output;
  private final List<String> rows = new ArrayList<>();
  private final List<String> looks = new ArrayList<>();
  private final double minX;
  private final double maxX;
  private final double minY;
  private final double maxY;
  private int time;

  /**
   * Creates the world of a scenario file.
   *
   * @param output the file for the table of steps
   */
  public SimCore(File scenario, long seed, Path output) throws IOException {
    Element root = root(scenario);
    this.output = output;
    this.turns = new Random(seed);
    Attributes field = Attributes.all(root, "simulation").get(0);
    minX = field.number("min_x");
    maxX = field.number("max_x");
    minY = field.number("min_y");
    maxY = field.number("max_y");
    for (Attributes camera : Attributes.all(root, "camera")) {
      add(camera(camera));
    }
    for (Attributes object : Attributes.all(root, "object")) {
      add(object(object));
    }
    events = Attributes.all(root, "event");
  }

  private static Element root(File scenario) throws IOException {
    try {
      return DocumentBuilderFactory.newInstance()
          .newDocumentBuilder()
          .parse(scenario)
          .getDocumentElement();
    } catch (ParserConfigurationException | SAXException e) {
      throw new IOException(e);
    }
  }

  /** The left border of the field, in metres. */
  public double get_min_x() {
    return minX;
  }

  /** The right border of the field, in metres. */
  public double get_max_x() {
    return maxX;
  }

  /** The lower border of the field, in metres. */
  public double get_min_y() {
    return minY;
  }

  /** The upper border of the field, in metres. */
  public double get_max_y() {
    return maxY;
  }

  /** All cameras. */
  public List<CameraController> getCameras() {
    return cameras;
  }

  /** The objects in the world. */
  public List<TraceableObject> getObjects() {
    return objects;
  }

  boolean contains(double x, double y) {
    return !(x > maxX || x < minX || y > maxY || y < minY);
  }

  /** Returns y as CamSim computes it from the top left corner (behaviour 2). */
  double distanceFromTop(double y) {
    return (minY + y) * -1;
  }

  /** Makes one step. */
  public void update() {
    for (Attributes event : events) {
      if (event.integer("timestep") == time) {
        fire(event);
      }
    }
    for (TraceableObject object : objects) {
      object.move(this, turns);
    }
    for (CameraController camera : cameras) {
      if (!camera.isOffline()) {
        for (TraceableObject object : objects) {
          log(camera, object, camera.update_visiblity(object));
        }
      }
    }
    trade();
    time++;
  }

  private void log(CameraController camera, TraceableObject object, double confidence) {
    Double kept = camera.visible().get(object);
    looks.add(
        time
            + ","
            + camera.getName()
            + ","
            + object.getFeatures().get(0)
            + ","
            + camera.getRange()
            + ","
            + object.getX()
            + ","
            + object.getY()
            + ","
            + confidence
            + ","
            + (kept == null ? "" : kept)
            + ","
            + camera.getHeading()
            + ","
            + camera.getAngle());
  }

  private void trade() {
    List<CameraController> online = new ArrayList<>(cameras);
    online.removeIf(CameraController::isOffline);
    int delivered = 0;
    int sent = 0;
    for (CameraController camera : online) {
      delivered += camera.advertise();
    }
    online.forEach(CameraController::lookForSearched);
    double overlap = 0;
    double confidence = 0;
    int tracked = 0;
    int handovers = 0;
    for (int i = 0; i < online.size(); i++) {
      CameraController camera = online.get(i);
      sent += camera.sent();
      handovers += camera.settle();
      for (CameraController later : online.subList(i + 1, online.size())) {
        overlap += Overlap.of(this, camera, later);
      }
      confidence += camera.certainty(this);
      tracked += camera.tracked().size();
    }
    double utility = 0;
    for (CameraController camera : online) {
      utility += camera.utility();
    }
    double proportion = tracked == 0 || objects.isEmpty() ? 0 : (double) tracked / objects.size();
    rows.add(
        time
            + ";"
            + utility
            + ";"
            + delivered
            + ";0;0;0.0;"
            + sent
            + ";"
            + overlap
            + ";"
            + confidence
            + ";"
            + proportion);
    System.out.println("step " + time + ": " + handovers + " handovers");
  }

  private void fire(Attributes event) {
    String action = event.text("participant") + " " + event.text("event");
    if (action.equals("camera error")) {
      cameraNamed(event.text("name")).switchOff();
    } else if (action.equals("camera change")) {
      cameraNamed(event.text("name"))
          .change(
              event.number("x"),
              event.number("y"),
              event.number("heading"),
              event.number("viewing_angle"),
              event.number("range"));
    } else if (action.equals("camera add")) {
      add(camera(event));
    } else if (action.equals("object add")) {
      add(addedObject(event));
    } else if (action.equals("object error")) {
      remove(event.number("name"));
    }
  }

  private CameraController cameraNamed(String name) {
    return cameras.stream().filter(camera -> camera.getName().equals(name)).findFirst().get();
  }

  private static CameraController camera(Attributes attributes) {
    return new CameraController(
        attributes.text("name"),
        attributes.number("x"),
        attributes.number("y"),
        Math.toRadians(attributes.number("heading")),
        Math.toRadians(attributes.number("viewing_angle")),
        attributes.number("range"));
  }

  /**
   * Makes an object; one that follows waypoints takes its heading as its speed (behaviour 11, Q3).
   */
  private static TraceableObject object(Attributes attributes) {
    Point start = new Point(attributes.number("x"), attributes.number("y"));
    double heading = Math.toRadians(attributes.number("heading"));
    boolean path = attributes.text("move").endsWith("Waypoints");
    return new TraceableObject(
        attributes.number("features"),
        start,
        heading,
        path ? heading : attributes.number("speed"),
        path ? attributes.waypoints() : Collections.emptyList());
  }

  private static TraceableObject addedObject(Attributes event) {
    List<Point> path = event.waypoints();
    Point start = path.isEmpty() ? new Point(event.number("x"), event.number("y")) : path.get(0);
    double heading = Math.toRadians(event.number("heading"));
    return new TraceableObject(event.number("name"), start, heading, event.number("speed"), path);
  }

  private void add(CameraController camera) {
    for (CameraController other : cameras) {
      camera.meet(other);
      if (!other.isOffline()) {
        other.meet(camera);
      }
    }
    cameras.add(camera);
  }

  private void add(TraceableObject object) {
    objects.add(object);
    for (CameraController camera : cameras) {
      if (!camera.isOffline()) {
        camera.announce(object);
      }
    }
  }

  private void remove(double features) {
    for (TraceableObject object : new ArrayList<>(objects)) {
      if (object.getFeatures().get(0) == features) {
        objects.remove(object);
        cameras.stream().filter(c -> !c.isOffline()).forEach(c -> c.forget(object));
      }
    }
  }

  /** Writes the table of steps and, next to it, the table of looks. */
  public void close_files() throws IOException {
    write(output, HEADER, rows);
    write(output.resolveSibling("looks.csv"), LOOKS_HEADER, looks);
  }

  private static void write(Path file, String header, List<String> rows) throws IOException {
    try (PrintWriter out = new PrintWriter(Files.newBufferedWriter(file, StandardCharsets.UTF_8))) {
      out.println(header);
      rows.forEach(out::println);
    }
  }
}
