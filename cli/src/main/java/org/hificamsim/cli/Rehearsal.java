package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.file.Unfinished;

/**
 * Runs several commands in one process, with the word {@code then} between them: the archive of
 * classes that the launcher dumps at its end holds what each of them loads (ADR 3).
 */
final class Rehearsal {
  private static final String THEN = "then";

  private Rehearsal() {}

  /** Exits with the code of the first command that fails. */
  public static void main(String[] args) {
    Unfinished.deleteAtExit();
    List<String> words = new ArrayList<>();
    for (String word : args) {
      if (word.equals(THEN)) {
        rehearse(words);
        words.clear();
      } else {
        words.add(word);
      }
    }
    rehearse(words);
    System.exit(0);
  }

  private static void rehearse(List<String> words) {
    HeadStart.begin(words.toArray(new String[0]));
    PrintWriter out = new PrintWriter(System.out, true, StandardCharsets.UTF_8);
    PrintWriter err = new PrintWriter(System.err, true, StandardCharsets.UTF_8);
    int exit = Main.execute(out, err, words.toArray(new String[0]));
    if (exit != 0) {
      System.exit(exit);
    }
  }
}
