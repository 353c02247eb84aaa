package org.hificamsim.profiling.measure;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.LabelledPhoto;
import org.hificamsim.profiling.dataset.TableLayout;
import org.hificamsim.profiling.detector.Detectors;

/**
 * What an unfinished measurement has already found: a hidden file in the data set's folder, one
 * line per photo, that a later call with the same photos and settings goes on from.
 */
final class MeasurementJournal implements Closeable {
  private static final int KEY_LENGTH = 16;

  private final Path file;
  private final TableLayout<Measurement> columns;
  private final Writer out;
  private final Map<Integer, Measurement> done;

  private MeasurementJournal(
      Path file, TableLayout<Measurement> columns, Map<Integer, Measurement> done, Writer out) {
    this.file = file;
    this.columns = columns;
    this.done = done;
    this.out = out;
  }

  static MeasurementJournal open(Dataset dataset, MeasureSettings settings) throws IOException {
    Path file = dataset.folder().resolve(".measurements-" + key(dataset, settings) + ".part");
    TableLayout<Measurement> columns = columns(settings).layout();
    Map<Integer, Measurement> done = read(file, dataset);
    new OutputFile(file).write(columns.csv(List.copyOf(done.values())));
    Writer out =
        Files.newBufferedWriter(
            file, StandardCharsets.UTF_8, StandardOpenOption.APPEND, LinkOption.NOFOLLOW_LINKS);
    return new MeasurementJournal(file, columns, new LinkedHashMap<>(done), out);
  }

  /** The columns that are filled photo by photo. */
  static MeasurementColumns columns(MeasureSettings settings) {
    return new MeasurementColumns(
        settings.pip(), settings.detectors().stream().map(Detectors::column).toList());
  }

  /** How many photos have been measured. */
  synchronized int count() {
    return done.size();
  }

  synchronized Optional<Measurement> get(int index) {
    return Optional.ofNullable(done.get(index));
  }

  /** Keeps a row, on the disk too. */
  synchronized Measurement add(int index, Measurement row) {
    try {
      done.put(index, row);
      out.write(columns.line(row));
      out.flush();
      return row;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Removes the file: the table itself has been written. */
  void finish() throws IOException {
    out.close();
    Files.deleteIfExists(file);
  }

  @Override
  public void close() throws IOException {
    out.close();
  }

  /** The whole lines of the file, by the index of their photo; a broken one ends it. */
  private static Map<Integer, Measurement> read(Path file, Dataset dataset) throws IOException {
    if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
      return Map.of();
    }
    String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
    new OutputFile(file).write(text.substring(0, text.lastIndexOf('\n') + 1));
    Map<Integer, Measurement> rows = new LinkedHashMap<>();
    try {
      Map<String, Integer> indices = indices(dataset.samples());
      for (Measurement row : MeasurementsFile.read(file)) {
        rows.put(indices.get(name(row.image(), row.object())), row);
      }
      return rows;
    } catch (InputException e) {
      return Map.of();
    }
  }

  private static Map<String, Integer> indices(List<LabelledPhoto> samples) {
    Map<String, Integer> indices = new LinkedHashMap<>();
    for (LabelledPhoto sample : samples) {
      indices.put(name(sample.image(), sample.object()), indices.size());
    }
    return indices;
  }

  private static String name(String image, String object) {
    return image + '\n' + object;
  }

  /** A digest of the settings and of every file's name, size and time. */
  private static String key(Dataset dataset, MeasureSettings settings) throws IOException {
    StringBuilder facts = new StringBuilder();
    facts.append(settings.detectors()).append(settings.test()).append(dataset.camera());
    facts.append(settings.pip());
    for (LabelledPhoto sample : dataset.samples()) {
      facts.append(sample);
      stamp(sample.file(), facts);
    }
    for (Path template : dataset.templates().values()) {
      stamp(template, facts);
    }
    byte[] text = facts.toString().getBytes(StandardCharsets.UTF_8);
    return Sha256.of(text).substring(0, KEY_LENGTH);
  }

  private static void stamp(Path file, StringBuilder facts) throws IOException {
    facts.append(file).append(Files.size(file)).append(Files.getLastModifiedTime(file).toMillis());
  }
}
