package org.hificamsim.tracks.format;

import java.util.Set;
import org.hificamsim.core.file.PlainXml;
import org.xml.sax.Attributes;

/** SUMO's floating car data: timesteps with vehicles, persons and containers; metres, seconds. */
final class FcdFormat extends PlainXml implements TrackFormat {
  private static final Set<String> TARGETS = Set.of("vehicle", "person", "container");

  private SampleSink samples;
  private double time = Double.NaN;

  @Override
  public Clock read(Recording recording, SampleSink sink) {
    samples = sink;
    samples.measuredIn(geographic(recording) ? Unit.DEG : recording.only(Unit.M));
    readFile(recording.file());
    return Clock.SECONDS;
  }

  /** Whether SUMO was asked for longitude and latitude, which only its user knows. */
  private static boolean geographic(Recording recording) {
    return recording.unit().filter(unit -> unit == Unit.DEG).isPresent();
  }

  @Override
  public void startElement(String uri, String local, String name, Attributes attributes) {
    if (name.equals("timestep")) {
      time = number(attributes, name, "time");
    } else if (TARGETS.contains(name)) {
      sample(name, attributes);
    }
  }

  private void sample(String name, Attributes attributes) {
    if (Double.isNaN(time)) {
      throw place().error("<" + name + "> outside <timestep time=\"...\">, expected it inside");
    }
    samples.accept(
        new Sample(
            place(),
            text(attributes, name, "id"),
            time,
            number(attributes, name, "x"),
            number(attributes, name, "y")));
  }
}
