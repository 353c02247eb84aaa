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
import java.util.ArrayList;
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
import org.hificamsim.profiling.measure.Measurer.MeasureSettings;

/**
 * What an unfinished measurement has already found: a hidden file in the data set's folder, one
 * line per photo, that a later call with the same photos and settings goes on from.
 */
final class MeasurementJournal implements Closeable {
  private static final int KEY_LENGTH = 16;

  private final Path file;
  private final TableLayout<Measurement> columns;
  private final Map<String, Measurement> done = new LinkedHashMap<>();
  private final Writer out;

  MeasurementJournal(Dataset dataset, MeasureSettings settings) throws IOException {
    file = dataset.folder().resolve(".measurements-" + key(dataset, settings) + ".part");
    columns = MeasurementsFile.layout(settings.pip(), settings.columns());
    read();
    new OutputFile(file).write(columns.csv(List.copyOf(done.values())));
    out = Files.newBufferedWriter(file, StandardOpenOption.APPEND, LinkOption.NOFOLLOW_LINKS);
  }

  /** Takes the whole lines of an earlier file; what a kill has left of the last is no line. */
  private void read() throws IOException {
    if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
      return;
    }
    String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
    new OutputFile(file).write(text.substring(0, text.lastIndexOf('\n') + 1));
    try {
      MeasurementsFile.read(file).forEach(row -> done.put(name(row.image(), row.object()), row));
    } catch (InputException e) {
      done.clear();
    }
  }

  private static String name(String image, String object) {
    return image + '\n' + object;
  }

  /** How many photos have been measured. */
  synchronized int count() {
    return done.size();
  }

  synchronized Optional<Measurement> get(LabelledPhoto photo) {
    return Optional.ofNullable(done.get(name(photo.image(), photo.object())));
  }

  /** Keeps a row, on the disk too. */
  synchronized Measurement add(Measurement row) {
    try {
      done.put(name(row.image(), row.object()), row);
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

  /** A digest of the settings and of every file's name, size and time. */
  private static String key(Dataset dataset, MeasureSettings settings) throws IOException {
    StringBuilder facts = new StringBuilder();
    facts.append(settings.detectors()).append(settings.test()).append(dataset.camera());
    facts.append(settings.pip()).append(dataset.samples());
    List<Path> files = new ArrayList<>(dataset.templates().values());
    dataset.samples().forEach(photo -> files.add(photo.file()));
    for (Path photo : files) {
      facts.append(photo).append(Files.size(photo)).append(Files.getLastModifiedTime(photo));
    }
    return Sha256.of(facts.toString().getBytes(StandardCharsets.UTF_8)).substring(0, KEY_LENGTH);
  }
}
