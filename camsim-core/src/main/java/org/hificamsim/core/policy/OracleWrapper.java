package org.hificamsim.core.policy;

import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.registry.Options;

/** Hands the oracle's view to a policy that passes it on to the oracle policy that it wraps. */
record OracleWrapper(ZoomPolicy wrapper) implements OraclePolicy {
  @Override
  public String name() {
    return wrapper.name();
  }

  @Override
  public void configure(Options options) {
    wrapper.configure(options);
  }

  @Override
  public List<Path> files() {
    return wrapper.files();
  }

  @Override
  public boolean jumps() {
    return wrapper.jumps();
  }

  @Override
  public void begin(OracleView network, SplittableRandom random) {
    wrapper.begin(network, random);
  }

  @Override
  public void decide(OracleView network, int[] views) {
    wrapper.decide(network, views);
  }

  @Override
  public void learn(OracleView network) {
    wrapper.learn(network);
  }

  @Override
  public String estimates(int camera, double[] estimates, double[] counts) {
    return wrapper.estimates(camera, estimates, counts);
  }

  @Override
  public boolean believe(int camera, BeliefListener listener) {
    return wrapper.believe(camera, listener);
  }

  @Override
  public long messages() {
    return wrapper.messages();
  }

  @Override
  public long bits() {
    return wrapper.bits();
  }
}
