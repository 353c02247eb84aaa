package org.hificamsim.tracks.format;

import java.time.DateTimeException;
import org.hificamsim.core.file.PlainXml;
import org.xml.sax.Attributes;

/** GPX: each {@code trk} is a target, each {@code trkpt} a sample with a {@code time}. */
final class GpxFormat extends PlainXml implements TrackFormat {
  private final StringBuilder text = new StringBuilder();
  private SampleSink samples;
  private int trackCount;
  private double latitude;
  private double longitude;
  private double time;

  @Override
  public Clock read(Recording recording, SampleSink sink) {
    samples = sink;
    samples.measuredIn(recording.only(Unit.DEG));
    readFile(recording.file());
    return Clock.SECONDS;
  }

  @Override
  public void startElement(String uri, String local, String name, Attributes attributes) {
    text.setLength(0);
    if (name.equals("trk")) {
      trackCount++;
    } else if (name.equals("trkpt")) {
      latitude = number(attributes, name, "lat");
      longitude = number(attributes, name, "lon");
      time = Double.NaN;
    }
  }

  @Override
  public void characters(char[] characters, int start, int length) {
    text.append(characters, start, Math.min(length, 100));
  }

  @Override
  public void endElement(String uri, String local, String name) {
    if (name.equals("time")) {
      time = time(text.toString().strip());
    } else if (name.equals("trkpt")) {
      sample();
    }
  }

  private double time(String text) {
    try {
      return Clock.sinceEpoch(text);
    } catch (DateTimeException e) {
      throw place().error("<time> is '" + text + "', expected a time such as 2024-05-31T12:00:00Z");
    }
  }

  private void sample() {
    if (Double.isNaN(time)) {
      throw place().error("<trkpt> has no <time>, expected one: a track needs times");
    }
    samples.accept(
        new TrackSample(place(), Integer.toString(trackCount), time, longitude, latitude));
  }
}
