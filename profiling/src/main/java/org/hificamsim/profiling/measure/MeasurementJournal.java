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
 * Saves the rows of an unfinished measurement in a hidden file of the data set's folder, so that a
 * later call with the same photos and settings can resume it.
 */
final class MeasurementJournal implements Closeable {
  private static final int KEY_LENGTH = 16;

  private final Path file;
  private final TableLayout<Measurement> columns;
  private final Map<String, Measurement> measured = new LinkedHashMap<>();
  private final Writer out;

  MeasurementJournal(Dataset dataset, MeasureSettings settings) throws IOException {
    file = dataset.folder().resolve(".measurements-" + key(dataset, settings) + ".part");
    columns = MeasurementsFile.layout(settings.pip(), settings.columns());
    read();
    new OutputFile(file).write(columns.csv(List.copyOf(measured.values())));
    out = Files.newBufferedWriter(file, StandardOpenOption.APPEND, LinkOption.NOFOLLOW_LINKS);
  }

  /** Reads the rows of an earlier call. A killed process may have left an incomplete last line. */
  private void read() throws IOException {
    if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
      return;
    }
    String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
    new OutputFile(file).write(text.substring(0, text.lastIndexOf('\n') + 1));
    try {
      MeasurementsFile.read(file)
          .forEach(row -> measured.put(rowKey(row.image(), row.object()), row));
    } catch (InputException e) {
      measured.clear();
    }
  }

  private static String rowKey(String image, String object) {
    return image + '\n' + object;
  }

  /** Returns the number of photos that have been measured. */
  synchronized int count() {
    return measured.size();
  }

  synchronized Optional<Measurement> get(LabelledPhoto photo) {
    return Optional.ofNullable(measured.get(rowKey(photo.image(), photo.object())));
  }

  /** Adds a row and writes it to the file. */
  synchronized Measurement add(Measurement row) {
    try {
      measured.put(rowKey(row.image(), row.object()), row);
      out.write(columns.line(row));
      out.flush();
      return row;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Removes the file, once the table of measurements has been written. */
  void finish() throws IOException {
    out.close();
    Files.deleteIfExists(file);
  }

  @Override
  public void close() throws IOException {
    out.close();
  }

  /** Returns a digest of the settings and of the name, size and time of every file. */
  private static String key(Dataset dataset, MeasureSettings settings) throws IOException {
    StringBuilder keyText = new StringBuilder();
    keyText.append(settings.detectors()).append(settings.test()).append(dataset.camera());
    keyText.append(settings.pip()).append(dataset.samples());
    List<Path> files = new ArrayList<>(dataset.templates().values());
    dataset.samples().forEach(photo -> files.add(photo.file()));
    for (Path photo : files) {
      keyText.append(photo).append(Files.size(photo)).append(Files.getLastModifiedTime(photo));
    }
    return Sha256.of(keyText.toString().getBytes(StandardCharsets.UTF_8)).substring(0, KEY_LENGTH);
  }
}
