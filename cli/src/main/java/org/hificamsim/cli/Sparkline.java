package org.hificamsim.cli;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;

/** Numbers from 0 as bars in one line of characters, with what the lowest and highest bar mean. */
final class Sparkline {
  private static final String BLOCKS = "\u2581\u2582\u2583\u2584\u2585\u2586\u2587\u2588";
  private static final String ASCII = "_.:-=+*#";

  private Sparkline() {}

  /** The line in characters that the terminal can show. */
  static String of(double[] values) {
    return of(values, terminal());
  }

  /** The line in Unicode's blocks where the character set has them, else in ASCII. */
  static String of(double[] values, Charset charset) {
    String bars = charset.newEncoder().canEncode(BLOCKS) ? BLOCKS : ASCII;
    int last = bars.length() - 1;
    double most = Arrays.stream(values).max().orElse(0);
    StringBuilder line = new StringBuilder();
    for (double value : values) {
      line.append(bars.charAt(most == 0 ? 0 : (int) Math.round(value / most * last)));
    }
    return line
        + String.format(
            Locale.ROOT, "  (%c 0 to %c %.2f)", bars.charAt(0), bars.charAt(last), most);
  }

  /** What the locale says; the JVM's own default is UTF-8 whatever the terminal. */
  private static Charset terminal() {
    String name = System.getProperty("native.encoding", "");
    return !name.isEmpty() && Charset.isSupported(name)
        ? Charset.forName(name)
        : StandardCharsets.US_ASCII;
  }
}
