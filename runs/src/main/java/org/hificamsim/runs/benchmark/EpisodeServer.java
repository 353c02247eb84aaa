package org.hificamsim.runs.benchmark;

import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import org.hificamsim.catalogue.Catalogue;

/**
 * Plays episodes in a process of its own: reads {@linkplain Trial trials} from the standard input,
 * and writes the views that the policy chose. The first argument is the file of the tasks.
 */
final class EpisodeServer {
  private static final int FAILURE = 1;

  private EpisodeServer() {}

  /** Plays until the input ends. Any fault ends the process with one line on standard error. */
  @SuppressWarnings("CatchAndPrintStackTrace") // the reader of the errors wants their last line
  public static void main(String[] args) {
    DataOutputStream out =
        new DataOutputStream(new BufferedOutputStream(new FileOutputStream(FileDescriptor.out)));
    System.setOut(System.err); // keeps the output of policies apart from the views
    try {
      serve(Path.of(args[0]), new DataInputStream(System.in), out);
    } catch (EOFException e) {
      return;
    } catch (IOException | RuntimeException | Error e) {
      String message = e.getMessage() == null ? e.getClass().getName() : e.getMessage();
      System.err.println(message.replaceAll("\\s+", " "));
      Runtime.getRuntime().halt(FAILURE);
    }
  }

  private static void serve(Path file, DataInputStream in, DataOutputStream out)
      throws IOException {
    Benchmark benchmark = Benchmark.read(file, Catalogue.load());
    while (true) {
      Trial trial = Trial.read(in);
      int[][] views = Episode.play(benchmark, trial.plan(benchmark)).views();
      for (int[] chosen : views) {
        for (int view : chosen) {
          out.writeInt(view);
        }
      }
      out.flush();
    }
  }
}
