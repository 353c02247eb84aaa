package org.hificamsim.tracks.format;

import java.util.Set;
import org.hificamsim.core.file.PlainXml;
import org.xml.sax.Attributes;

/**
 * SUMO's floating car data: vehicles, persons and containers by time step, in metres and seconds.
 */
final class FcdFormat extends PlainXml implements TrackFormat {
  private static final Set<String> TARGET_ELEMENTS = Set.of("vehicle", "person", "container");

  private SampleSink samples;
  private double time = Double.NaN;

  @Override
  public Clock read(Recording recording, SampleSink sink) {
    samples = sink;
    samples.measuredIn(isGeographic(recording) ? Unit.DEG : recording.only(Unit.M));
    readFile(recording.file());
    return Clock.SECONDS;
  }

  /** Whether SUMO wrote longitude and latitude, which the file does not tell. */
  private static boolean isGeographic(Recording recording) {
    return recording.unit().filter(unit -> unit == Unit.DEG).isPresent();
  }

  @Override
  public void startElement(String uri, String local, String name, Attributes attributes) {
    if (name.equals("timestep")) {
      time = number(attributes, name, "time");
    } else if (TARGET_ELEMENTS.contains(name)) {
      sample(name, attributes);
    }
  }

  private void sample(String name, Attributes attributes) {
    if (Double.isNaN(time)) {
      throw place().error("<" + name + "> outside <timestep time=\"...\">, expected it inside");
    }
    samples.accept(
        new TrackSample(
            place(),
            text(attributes, name, "id"),
            time,
            number(attributes, name, "x"),
            number(attributes, name, "y")));
  }
}
