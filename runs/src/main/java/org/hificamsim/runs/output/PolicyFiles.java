package org.hificamsim.runs.output;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;

/** The files that policies decide by, such as a trained network. */
public final class PolicyFiles {
  private final Registry<ZoomPolicy> policies = Catalogue.load().policies();

  /** Those of a policy; none of one that is not known here. */
  public List<Path> of(String policy) {
    return policies.knows(policy) ? policies.create(policy).files() : List.of();
  }

  /**
   * What is in one of them.
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
