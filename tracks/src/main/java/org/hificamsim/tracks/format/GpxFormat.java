package org.hificamsim.tracks.format;

import org.hificamsim.core.InputException;
import org.hificamsim.core.file.PlainXml;
import org.xml.sax.Attributes;
import org.xml.sax.helpers.AttributesImpl;

/**
 * GPX: each {@code trk} is a target, each {@code trkpt} a sample with a {@code time}. It is absent
 * between its segments. Waypoints and routes are not tracks.
 */
final class GpxFormat extends PlainXml implements TrackFormat {
  static final KnownFormat DECLARATION =
      new KnownFormat(
          "gpx",
          "`<trkpt lat lon><time>`; each `<trk>` is a target, absent between `<trkseg>`",
          "date",
          "WGS84",
          GpxFormat::new);

  private final Times times = new Times();
  private final StringBuilder text = new StringBuilder();
  private SampleSink samples;
  private InputException notTrack; // null without routes and waypoints
  private int trackCount;
  private Attributes point; // null outside <trkpt>
  private String time; // null without <time>

  @Override
  public FormatFit fit(FileStart start, Recording recording) {
    return FormatFit.of(
        start.rootElement().equals("gpx"),
        "begins with <gpx>",
        "the file %s, GPX has <gpx>".formatted(start.look()));
  }

  @Override
  public Unit usualUnit() {
    return Unit.DEG;
  }

  @Override
  public boolean hasIds() {
    return false;
  }

  @Override
  public Clock read(Recording recording, SampleSink sink) {
    samples = sink;
    samples.measuredIn(recording.only(Unit.DEG));
    readFile(recording.file());
    if (trackCount == 0 && notTrack != null) {
      throw notTrack;
    }
    return Clock.SECONDS;
  }

  @Override
  public void startElement(String uri, String local, String name, Attributes attributes) {
    text.setLength(0);
    switch (name) {
      case "trk" -> trackCount++;
      case "trkseg" -> samples.pause(target());
      case "trkpt" -> begin(attributes);
      case "rte" -> leaveOut("<rte> is a route, not a track: it has no times, expected <trk>");
      case "wpt" ->
          leaveOut("<wpt> is a waypoint, expected a <trk> with a <trkseg>, and <trkpt> in it");
      default -> {}
    }
  }

  private void begin(Attributes attributes) {
    point = new AttributesImpl(attributes);
    time = null;
  }

  private void leaveOut(String problem) {
    InputException error = place().error(problem);
    notTrack = notTrack == null ? error : notTrack;
    samples.leaveOut(Omission.NO_TRACK, () -> error);
  }

  @Override
  public void characters(char[] characters, int start, int length) {
    text.append(characters, start, Math.min(length, 100));
  }

  @Override
  public void endElement(String uri, String local, String name) {
    if (name.equals("time")) {
      time = text.toString().strip();
    } else if (name.equals("trkpt")) {
      samples.reading(this::sample);
      point = null;
    }
  }

  private void sample() {
    samples.accept(
        new TrackSample(
            place(),
            target(),
            OddRows.part(Omission.NO_TIME, this::seconds),
            OddRows.part(Omission.NO_PLACE, () -> number(point, "trkpt", "lon")),
            OddRows.part(Omission.NO_PLACE, () -> number(point, "trkpt", "lat"))));
  }

  private double seconds() {
    if (time == null) {
      throw place().error("<trkpt> has no <time>, expected one: a track needs times");
    }
    double seconds = times.seconds(time);
    if (Double.isNaN(seconds)) {
      throw place().invalid("<time>", time, times.expected(time));
    }
    return seconds;
  }

  private String target() {
    return Integer.toString(trackCount);
  }
}
