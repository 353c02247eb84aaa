package org.hificamsim.runs.benchmark;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.NamedSetting;
import org.hificamsim.core.file.Sha256;

/** Draws seeds from a secret, so that nobody can know them without the secret. */
final class FreshSeeds {
  private static final int FEWEST_CHARACTERS = 8;

  private final String secret;

  /**
   * @param secret a text of 8 or more characters
   */
  FreshSeeds(String secret) {
    this.secret = secret;
    if (secret.length() < FEWEST_CHARACTERS) {
      throw InputException.of(
          "%s has %s characters, expected %s or more",
          NamedSetting.setting("secret"), secret.length(), FEWEST_CHARACTERS);
    }
  }

  /** The seeds of a task's episodes. */
  List<Long> draw(String task, int episodes) {
    return IntStream.range(0, episodes).mapToObj(episode -> seed(task, episode)).toList();
  }

  private long seed(String task, int episode) {
    String text = String.join("\n", secret, task, Integer.toString(episode));
    byte[] digest = Sha256.bytes(text.getBytes(StandardCharsets.UTF_8));
    return ByteBuffer.wrap(digest).getLong() & Long.MAX_VALUE;
  }

  /** The SHA-256 of the secret, by which it can be recognised once it is published. */
  String hash() {
    return Sha256.of(secret.getBytes(StandardCharsets.UTF_8));
  }
}
