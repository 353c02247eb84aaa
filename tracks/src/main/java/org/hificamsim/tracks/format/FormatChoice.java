package org.hificamsim.tracks.format;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.NamedSetting;

/**
 * The format in which a recording is read: the one that the user names, or the only one that its
 * beginning fits.
 *
 * @param reason how the format was recognised; empty if the user names it
 */
public record FormatChoice(
    Recording recording, KnownFormat known, TrackFormat reader, Optional<String> reason) {
  /** The name by which users leave the choice to the file. */
  public static final String AUTO = "auto";

  /** A format, and whether a file fits it. */
  private record Candidate(KnownFormat known, TrackFormat reader, FormatFit fit) {
    static Candidate of(KnownFormat known, FileStart start, Recording recording) {
      TrackFormat reader = known.maker().get();
      boolean isAsked = recording.columns().isEmpty() || reader.namesColumns();
      FormatFit fit =
          isAsked ? reader.fit(start, recording) : FormatFit.no("it has no names of columns");
      return new Candidate(known, reader, fit);
    }

    String words() {
      return known.name() + " (" + fit.reason() + ")";
    }
  }

  /**
   * Chooses the format of a recording.
   *
   * @param name the name of a format, or {@link #AUTO}
   * @throws InputException if no format has the name, or if not exactly one fits the file
   */
  public static FormatChoice of(String name, Recording recording) {
    if (!name.equals(AUTO)) {
      KnownFormat known = KnownFormat.registry().create(name);
      return new FormatChoice(recording, known, known.maker().get(), Optional.empty());
    }
    FileStart start = recording.start();
    List<Candidate> fitting = fitting(start, recording);
    if (fitting.size() != 1) {
      throw fitting.isEmpty() ? none(start) : several(start, fitting);
    }
    Candidate only = fitting.get(0);
    return new FormatChoice(
        recording, only.known(), only.reader(), Optional.of(only.fit().reason()));
  }

  private static List<Candidate> fitting(FileStart start, Recording recording) {
    return KnownFormat.all().stream()
        .map(known -> Candidate.of(known, start, recording))
        .filter(candidate -> candidate.fit().fits())
        .toList();
  }

  private static InputException none(FileStart start) {
    String columns =
        start.isTable()
            ? ", or %s, which say what the columns of a table are%s"
                .formatted(
                    setting(
                        "columns",
                        start.hasNumbers() ? "time=1,id=2,x=3,y=4" : "time=...,id=...,x=...,y=..."),
                    start.hasNumbers()
                        ? ", numbered from 1"
                        : " (" + String.join(", ", start.rows().get(0).texts()) + ")")
            : "";
    return start
        .place()
        .error(
            "the file %s, which fits no format, expected %s, one of %s%s",
            start.look(), setting("format"), names(KnownFormat.all().stream()), columns);
  }

  private static InputException several(FileStart start, List<Candidate> fitting) {
    return start
        .place()
        .error(
            "the file may be %s, expected %s, one of %s",
            fitting.stream().map(Candidate::words).collect(Collectors.joining(" or ")),
            setting("format"),
            names(fitting.stream().map(Candidate::known)));
  }

  private static String names(Stream<KnownFormat> formats) {
    return formats.map(KnownFormat::name).collect(Collectors.joining(", "));
  }

  /** The unit of positions: the user's, or the usual one of the format. */
  public Unit unit() {
    return recording.unit().orElse(reader.usualUnit());
  }

  /**
   * Reads the recording.
   *
   * @throws InputException with the place; says so if the file does not look like the format
   */
  public Clock read(SampleSink samples) {
    try {
      return reader.read(recording, samples);
    } catch (InputException fault) {
      throw wrongFormat(fault);
    }
  }

  /**
   * Returns the error that the file looks like another format, if it does; else the fault, with the
   * format if the user did not name it.
   */
  public InputException wrongFormat(InputException fault) {
    if (reason.isPresent()) {
      String file = recording.file().toString();
      String message = fault.message(NamedSetting.MARKED);
      return InputException.of(
              "%s (read as %s, because the file %s)",
              message.startsWith(file) ? message : file + ": " + message,
              known.name(),
              reason.get())
          .because(fault);
    }
    FileStart start = recording.start();
    FormatFit fit = known.maker().get().fit(start, recording);
    if (fit.isReadable()) {
      return fault;
    }
    List<Candidate> others = fitting(start, recording);
    String better =
        others.isEmpty() ? "" : ", or the format " + names(others.stream().map(Candidate::known));
    return start
        .place()
        .error("%s, expected a file in the format %s%s", fit.reason(), known.name(), better)
        .because(fault);
  }

  /** Returns the line that says which format was recognised and why; empty if the user named it. */
  public Optional<String> line() {
    return reason.map(
        words ->
            "format: %s (%s %s)".formatted(known.name(), recording.file().getFileName(), words));
  }
}
