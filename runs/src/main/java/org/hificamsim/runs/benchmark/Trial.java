package org.hificamsim.runs.benchmark;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import org.hificamsim.runs.RunPlan;

/**
 * An episode of an entered policy.
 *
 * @param policy the policy with its options
 * @param isFresh whether the seed is neither for training nor for testing
 */
record Trial(String task, String policy, long seed, boolean isFresh) {
  RunPlan plan(Benchmark benchmark) {
    return isFresh ? benchmark.freshPlan(task, policy, seed) : benchmark.plan(task, policy, seed);
  }

  void write(DataOutputStream out) throws IOException {
    out.writeUTF(task);
    out.writeUTF(policy);
    out.writeLong(seed);
    out.writeBoolean(isFresh);
  }

  static Trial read(DataInputStream in) throws IOException {
    return new Trial(in.readUTF(), in.readUTF(), in.readLong(), in.readBoolean());
  }
}
