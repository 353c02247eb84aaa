package org.hificamsim.core.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * The record of the files that commands have written into a folder: the SHA-256 of each file by its
 * name, in the format of the tool sha256sum. A file that is not recorded, or whose hash has
 * changed, belongs to the user.
 */
public final class FileRecord {
  /** The name of the record's file in the folder. */
  public static final String NAME = ".hificamsim.sha256";

  private static final Pattern LINE = Pattern.compile("([0-9a-f]{64}) {2}(.+)");

  private final Map<String, String> hashes = new TreeMap<>();

  /** Reads a record; empty if the file is missing. Unknown lines are ignored. */
  static FileRecord read(Path file) {
    FileRecord record = new FileRecord();
    if (Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
      try (TextLines lines = TextLines.open(file)) {
        while (lines.next()) {
          Matcher line = LINE.matcher(lines.text());
          if (line.matches() && isBelow(line.group(2))) {
            record.put(line.group(2), line.group(1));
          }
        }
      }
    }
    return record;
  }

  /** Reads the record of a folder. */
  public static FileRecord of(Path folder) throws IOException {
    Path file = folder.resolve(NAME);
    if (Files.exists(file, LinkOption.NOFOLLOW_LINKS)
        && !Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
      throw new IOException("'" + NAME + "' is a link or a folder");
    }
    return read(file);
  }

  /** Whether a name is a path below the folder, without control characters. */
  static boolean isBelow(String name) {
    return name.matches("[^/\\\\\\p{Cntrl}]+(/[^/\\\\\\p{Cntrl}]+)*")
        && !("/" + name + "/").contains("/../");
  }

  /** The names of the recorded files. */
  public Set<String> names() {
    return hashes.keySet();
  }

  /** Whether a file is unchanged since a command wrote it. */
  public boolean isUnchanged(Path folder, String name) throws IOException {
    Path file = folder.resolve(name);
    return Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)
        && Sha256.of(file).equals(hashes.get(name));
  }

  /** The existing files of a folder that have changed since commands wrote them. */
  public List<String> changed(Path folder) throws IOException {
    List<String> changed = new ArrayList<>();
    for (String name : names()) {
      if (Files.exists(folder.resolve(name)) && !isUnchanged(folder, name)) {
        changed.add(name);
      }
    }
    return changed;
  }

  void put(String name, String hash) {
    hashes.put(name, hash);
  }

  void remove(String name) {
    hashes.remove(name);
  }

  /** Returns a copy with the same files and hashes. */
  FileRecord copy() {
    FileRecord copy = new FileRecord();
    copy.hashes.putAll(hashes);
    return copy;
  }

  /** The record as the text of its file. */
  String text() {
    return hashes.entrySet().stream()
        .map(file -> file.getValue() + "  " + file.getKey() + "\n")
        .collect(Collectors.joining());
  }
}
