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
 * What commands have put into a folder: the SHA-256 of each file by its name, as {@code sha256sum
 * --check} takes it. A file that is not in it, or has another hash by now, is the user's.
 */
public final class FileRecord {
  /** The file's name in the folder. */
  public static final String NAME = ".hificamsim.sha256";

  private static final Pattern LINE = Pattern.compile("([0-9a-f]{64}) {2}(.+)");

  private final Map<String, String> hashes = new TreeMap<>();

  /** What a file says; nothing where there is none. Lines that are none of ours are left out. */
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

  /** The record of a folder. */
  public static FileRecord of(Path folder) throws IOException {
    Path file = folder.resolve(NAME);
    if (Files.exists(file, LinkOption.NOFOLLOW_LINKS)
        && !Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
      throw new IOException("'" + NAME + "' is a link or a folder");
    }
    return read(file);
  }

  /** Whether a name stays below the folder, and in one line. */
  static boolean isBelow(String name) {
    return name.matches("[^/\\\\\\p{Cntrl}]+(/[^/\\\\\\p{Cntrl}]+)*")
        && !("/" + name + "/").contains("/../");
  }

  /** The files' names. */
  public Set<String> names() {
    return hashes.keySet();
  }

  /** Whether a folder's file is as a command wrote it. */
  public boolean isUnchanged(Path folder, String name) throws IOException {
    Path file = folder.resolve(name);
    return Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)
        && Sha256.of(file).equals(hashes.get(name));
  }

  /** The files of a folder that are there, and not as commands wrote them. */
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

  /** The same files and hashes. */
  FileRecord copy() {
    FileRecord copy = new FileRecord();
    copy.hashes.putAll(hashes);
    return copy;
  }

  /** The text of the file. */
  String text() {
    return hashes.entrySet().stream()
        .map(file -> file.getValue() + "  " + file.getKey() + "\n")
        .collect(Collectors.joining());
  }
}
