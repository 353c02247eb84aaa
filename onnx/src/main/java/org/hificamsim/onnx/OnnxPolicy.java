package org.hificamsim.onnx;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;

/**
 * A policy that was trained elsewhere: {@code onnx:FILE}. Each camera does what the network in the
 * file values most among what the camera may do; all cameras are asked in one call.
 */
public final class OnnxPolicy implements ZoomPolicy {
  private static final String EXPECTED = "expected a trained network: onnx:FILE";

  private String file = "";
  private Deciding deciding;

  @Override
  public String name() {
    return "onnx";
  }

  @Override
  public void configure(Options options) {
    file = options.mainText("file", "", "the trained network, in ONNX format");
    files().forEach(TrainedNetwork::requireReadable);
  }

  @Override
  public List<Path> files() {
    try {
      return file.isEmpty() ? List.of() : List.of(Path.of(file));
    } catch (InvalidPathException e) {
      throw new InputException("policy onnx: file is '" + file + "', " + EXPECTED, e);
    }
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    if (file.isEmpty()) {
      throw new InputException("policy onnx: no file, " + EXPECTED);
    }
    deciding = new Deciding(TrainedNetwork.of(files().get(0)), network);
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    deciding.decide(network, views);
  }
}
