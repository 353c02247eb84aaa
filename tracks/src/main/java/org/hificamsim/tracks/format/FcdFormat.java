package org.hificamsim.tracks.format;

import java.util.Set;
import java.util.regex.Pattern;
import org.hificamsim.core.file.Fields;
import org.hificamsim.core.file.PlainXml;
import org.xml.sax.Attributes;

/**
 * SUMO's floating car data: vehicles, persons and containers by time step, in metres and seconds.
 * The comment at the beginning says whether SUMO wrote longitude and latitude.
 */
final class FcdFormat extends PlainXml implements TrackFormat {
  static final KnownFormat DECLARATION =
      new KnownFormat(
          "fcd",
          "SUMO: `<timestep time><vehicle|person|container id x y/>`",
          "s",
          "m; degrees if the header has `fcd-output.geo`, or by `{unit=deg}`",
          FcdFormat::new);

  private static final Set<String> TARGET_ELEMENTS = Set.of("vehicle", "person", "container");
  private static final Pattern GEOGRAPHIC =
      Pattern.compile("fcd-output\\.geo value=\"(?:true|1|yes|on|t|x)\"|\\bgeo=\"true\"");

  private final Times times = new Times();
  private final FcdSpeeds speeds = new FcdSpeeds();
  private SampleSink samples;
  private String timeText = "";
  private double time = Double.NaN;

  @Override
  public FormatFit fit(FileStart start, Recording recording) {
    String root = start.rootElement();
    return FormatFit.of(
        root.equals("fcd-export") || (start.isXml() && start.text().contains("<timestep ")),
        "has <" + root + "> with time steps",
        "the file %s, SUMO has <fcd-export>".formatted(start.look()));
  }

  @Override
  public Clock read(Recording recording, SampleSink sink) {
    samples = sink;
    boolean isGeographic =
        recording.unit().isEmpty()
            ? GEOGRAPHIC.matcher(recording.start().text()).find()
            : recording.unit().get() == Unit.DEG;
    samples.measuredIn(isGeographic ? Unit.DEG : recording.only(Unit.M));
    readFile(recording.file());
    if (!isGeographic) {
      speeds.sign().ifPresent(samples::doubt);
    }
    return Clock.SECONDS;
  }

  @Override
  public void startElement(String uri, String local, String name, Attributes attributes) {
    if (name.equals("timestep")) {
      timeText = attributes.getValue("time");
      time = timeText == null ? Double.NaN : times.seconds(timeText);
    } else if (TARGET_ELEMENTS.contains(name)) {
      samples.reading(() -> sample(name, attributes));
    }
  }

  private void sample(String name, Attributes attributes) {
    OddRows.part(Omission.NO_TIME, () -> requireTime(name));
    TrackSample sample =
        new TrackSample(
            place(),
            OddRows.part(Omission.NO_TARGET, () -> text(attributes, name, "id")),
            time,
            OddRows.part(Omission.NO_PLACE, () -> number(attributes, name, "x")),
            OddRows.part(Omission.NO_PLACE, () -> number(attributes, name, "y")));
    String speed = attributes.getValue("speed");
    speeds.add(sample, speed == null ? Double.NaN : Fields.value(speed));
    samples.accept(sample);
  }

  private double requireTime(String name) {
    if (!Double.isNaN(time)) {
      return time;
    }
    throw timeText == null || timeText.isEmpty()
        ? place().error("<" + name + "> outside <timestep time=\"...\">, expected it inside")
        : place().invalid("<timestep> time", timeText, times.expected(timeText));
  }
}
