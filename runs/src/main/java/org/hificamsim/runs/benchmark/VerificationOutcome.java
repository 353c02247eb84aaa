package org.hificamsim.runs.benchmark;

/** The outcomes of verifying an entry's scores on fresh seeds, the worst first. */
public enum VerificationOutcome {
  /** The policy scores less on fresh seeds, or does not reproduce the entry's scores in testing. */
  NOT_HELD("not held"),
  /** The scores hold, on a system that did not keep the policy from reading files. */
  UNCONFINED("unconfined"),
  /** The scores hold. */
  HELD("fresh seeds");

  private final String label;

  VerificationOutcome(String label) {
    this.label = label;
  }

  /** The word in tables. */
  String label() {
    return label;
  }

  /** The worse of two outcomes. */
  public static VerificationOutcome worse(VerificationOutcome first, VerificationOutcome second) {
    return first.compareTo(second) <= 0 ? first : second;
  }
}
