package org.hificamsim.runs.output;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;

/** Finds the files that policies read, such as a trained network. */
public final class PolicyFiles {
  private final Registry<ZoomPolicy> policies = Catalogue.load().policies();

  /** Returns the files of a policy and those that its options name; none for an unknown policy. */
  public List<Path> of(String policy) {
    if (!policies.knows(policy)) {
      return List.of();
    }
    Stream<Path> named =
        Arrays.stream(policy.split("[:,=]")).map(File::new).filter(File::isFile).map(File::toPath);
    return Stream.concat(policies.create(policy).files().stream(), named).distinct().toList();
  }

  /**
   * The content of a file that a policy reads.
   *
   * @throws InputException when it cannot be read
   */
  public static byte[] content(Path file) {
    try {
      return Files.readAllBytes(file);
    } catch (IOException e) {
      throw new InputException(file + " cannot be read, expected a file of a policy", e);
    }
  }
}
