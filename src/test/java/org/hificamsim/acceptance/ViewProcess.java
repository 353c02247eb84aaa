package org.hificamsim.acceptance;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PipedReader;
import java.io.PipedWriter;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.hificamsim.cli.Main;

/** Runs {@code view --no-browser} on a thread of its own until its page is closed. */
final class ViewProcess implements AutoCloseable {
  private final StringWriter err = new StringWriter();
  private final CompletableFuture<Integer> exit = new CompletableFuture<>();
  private final Thread thread;
  private final String address;

  /**
   * @param words the arguments of {@code view}
   */
  ViewProcess(Object... words) {
    String[] args =
        Stream.concat(Stream.of("view", "--no-browser"), Arrays.stream(words).map(Object::toString))
            .toArray(String[]::new);
    try {
      PipedWriter pipe = new PipedWriter();
      BufferedReader out = new BufferedReader(new PipedReader(pipe));
      PrintWriter writer = new PrintWriter(pipe, true);
      thread =
          new Thread(
              () -> exit.complete(Main.execute(writer, new PrintWriter(err, true), args)), "view");
      thread.start();
      address = out.readLine();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the address that the command printed. */
  String address() {
    return address;
  }

  /** Waits until the command has ended, at most half a minute. */
  int exit() throws Exception {
    return exit.get(30, TimeUnit.SECONDS);
  }

  String err() {
    return err.toString();
  }

  @Override
  public void close() {
    thread.interrupt();
  }
}
