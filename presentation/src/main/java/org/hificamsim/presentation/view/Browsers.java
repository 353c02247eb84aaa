package org.hificamsim.presentation.view;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.stream.Stream;

/** Opens the user's browser. */
public final class Browsers {
  private static final String PAGE =
      """
      <!DOCTYPE html><meta charset="utf-8"><meta name="referrer" content="no-referrer">
      <meta http-equiv="refresh" content="0; url=%s"><title>HiFi-CamSim</title>
      """;

  private static final Path XDG_OPEN = Path.of("/usr/bin/xdg-open");

  private Browsers() {}

  /**
   * Opens an address if there is a desktop; otherwise does nothing. The list of processes shows the
   * arguments of the browser to other users, so the browser is not given the address, but a file
   * that only this user can read.
   */
  public static void open(String address) {
    try {
      if (Files.isExecutable(XDG_OPEN) && hasScreen()) {
        Path file = Files.createTempFile("hificamsim-", ".html");
        file.toFile().deleteOnExit();
        Files.writeString(file, page(address));
        new ProcessBuilder(XDG_OPEN.toString(), file.toString())
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
      }
    } catch (IOException e) {
      // the user opens the printed address
    }
  }

  /** Returns the content of this file: a page that redirects to the address. */
  public static String page(String address) {
    return PAGE.formatted(address);
  }

  private static boolean hasScreen() {
    return Stream.of("DISPLAY", "WAYLAND_DISPLAY")
        .anyMatch(name -> !Objects.requireNonNullElse(System.getenv(name), "").isEmpty());
  }
}
